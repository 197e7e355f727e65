// What clauses are read in: the world as it is and as it will be, what was spoken of, and what is to be done
// so far, played through in SymSim so that later clauses see what earlier ones did.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "components/goalnet/language/clause.h"
#include "components/goalnet/language/resolve.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

class FrameContext {
 public:
  FrameContext(const Instruction& instruction, const Lexicon& lexicon, const Language& language,
               const Symbols& symbols, const SymState& start, const Distances* distances, bool at_home)
      : resolver_(instruction, lexicon, language, symbols, distances),
        language_(language),
        start_(start),
        now_(start),
        tray_(symbols.find("Tray")),
        at_home_(at_home),
        closes_tap_(at_home) {
    resolver_.begins_with(start_);
  }

  // What is to be done when all is added: a tap that only filled something is turned off.
  void finish() { close_tap(); }
  void leave_tap_on() { closes_tap_ = false; }
  // Whether `problem`, as FrameActions::add() said it, is that a thing spoken of is not here or not known.
  bool names_missing_thing(const std::string& problem) const {
    return !missing_.empty() && problem == missing_;
  }
  // Whether something was asked for by a number that nothing here has: "channel 9".
  bool no_such_number() const { return no_such_number_; }
  const std::vector<SymAction>& macros() const { return macros_; }
  // What each of the actions is for.
  const std::vector<SymDelta>& steps() const { return steps_; }
  Resolver& resolver() { return resolver_; }

 protected:
  using Problem = std::string;  // empty: none
  using Objects = std::vector<Symbol>;

  // frame_context.cc: what is done
  Problem act(const SymAction& macro);
  Problem keep(Symbol x, Symbol y, Where where);
  void keep_held(SymDelta& step) const;
  void close_tap();

  // frame_objects.cc, frame_find.cc: what is meant
  Objects objects_of(const NounPhrase& phrase, Sort sort, const Clause& clause);
  Objects meant_by(const NounPhrase& phrase, Sort sort);  // all that "it" or the name may mean
  Objects pronoun(const NounPhrase& phrase, Sort sort, const Objects& not_these) const;
  void prefer_there(const Clause& clause, const NounPhrase& phrase, Objects& options) const;
  bool misplaced(const Clause& clause, const NounPhrase& phrase, const Objects& options);
  Objects direct(const Clause& clause, Sort sort, Problem& problem);
  Objects role_objects(const Clause& clause, Role role, Sort sort, Problem& problem);
  Objects places(const NounPhrase& phrase, const Objects& for_these, std::size_t wanted, Problem& problem);
  void remember(const Objects& objects);
  static NounPhrase it();
  NounPhrase unsaid() const;  // "it", or "them" where nothing was spoken of and both hands are full
  Symbol mentioned_content(const Clause& clause, Role role) const;
  Symbol vessel_with(Symbol content) const;
  Symbol first_of_class(std::string_view name) const;  // kNone: there is none
  bool is_vessel_or_dish(Symbol object) const;
  static bool is_canned_drink(Symbol content);
  Symbol burner_for(Symbol object) const;
  Symbol surface() const;                        // where things go that have to go somewhere
  bool lexicon_place(const NounPhrase& phrase);  // names furniture or fixtures, nothing that moves
  Symbol home_of(Symbol object) const;           // kNone: it has none here
  bool is_home(Symbol object, Symbol place) const;

  // frame_problems.cc: why it is not
  Problem unknown_thing(const NounPhrase& phrase, Sort sort) const;
  Problem unknown_name(const std::string& word) const;
  Problem not_here(Problem problem) const;  // takes note: a thing is missing

  Resolver resolver_;
  const Language& language_;
  SymState start_, now_;
  std::vector<SymAction> macros_;
  std::vector<SymDelta> steps_;
  std::vector<Objects> history_;              // what "it" may mean, the newest last
  Objects last_destination_;                  // what "there" means
  std::string content_told_;                  // "there is coffee in the mug": "it" may mean the coffee
  Objects taken_;                             // in the hands because somebody wants it there
  Objects named_;                             // by parts that only name something, since the last command
  Objects mass_;                              // "everything", newest: "it" means all of that
  std::vector<std::pair<int, bool>> judged_;  // conditions by their numbers, and whether they held
  Problem elsewhere_;                         // where the things are that are not where the sentence says
  mutable bool no_such_number_ = false;
  mutable Problem missing_;  // the last that said so; see names_missing_thing()
  Symbol tray_;              // the robot's
  bool at_home_;             // see FrameReader
  bool closes_tap_;
  bool tap_fills_ = false;  // it was turned on to fill something, and runs still
  bool tap_asked_ = false;  // somebody wants it to run
  bool silent_ = false;     // the television was to be silent while it was off
  bool moves_ = false;      // "move", "carry": to another place than where it is
  Objects avoid_;           // places: what stands there already is not what should be put there
};

}  // namespace goalnet::inference
