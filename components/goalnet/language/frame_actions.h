// Clauses to actions, one frame at a time, played through in SymSim so that later clauses see what earlier
// ones did.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/goalnet/language/clause.h"
#include "components/goalnet/language/resolve.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

class FrameActions {
 public:
  FrameActions(const Instruction& instruction, const Lexicon& lexicon, const Language& language,
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

  // Adds what the clause asks for; otherwise adds nothing and says why not, in one sentence.
  std::string add(const Clause& clause);
  // "pass me the coke? It should be in the fridge": makes a statement of each command that only tells where a
  // thing that was asked for before is thought to be. Before the first add().
  void believe_places(std::vector<Clause>& clauses);
  // What is to be done when all is added: a tap that only filled something is turned off.
  void finish() { close_tap(); }
  void leave_tap_on() { closes_tap_ = false; }
  // Whether `problem`, as add() said it, is that a thing spoken of is not here or not known.
  bool names_missing_thing(const std::string& problem) const {
    return !missing_.empty() && problem == missing_;
  }
  // Whether something was asked for by a number that nothing here has: "channel 9".
  bool no_such_number() const { return no_such_number_; }
  // Takes note of what a statement or question is about: "it" means that from here on.
  void notice(const Clause& clause);
  // What a forbidden clause would do must not be among the actions; says which is.
  std::string check_forbidden(const Clause& clause, const SymState& start) const;
  // Why what a statement tells cannot be so ("a burner is on" where none is); empty: it can.
  std::string contradicted(const Clause& statement);
  const std::vector<SymAction>& macros() const { return macros_; }
  // What each of the actions is for.
  const std::vector<SymDelta>& steps() const { return steps_; }
  Resolver& resolver() { return resolver_; }

 private:
  using Problem = std::string;  // empty: none
  using Objects = std::vector<Symbol>;

  // frame_actions.cc: what is meant
  Objects objects_of(const NounPhrase& phrase, Sort sort, const Clause& clause);
  Objects pronoun(const NounPhrase& phrase, Sort sort, const Objects& not_these) const;
  void prefer_there(const Clause& clause, const NounPhrase& phrase, Objects& options) const;
  bool misplaced(const Clause& clause, const NounPhrase& phrase, const Objects& options);
  Objects direct(const Clause& clause, Sort sort, Problem& problem);
  Objects role_objects(const Clause& clause, Role role, Sort sort, Problem& problem);
  Objects places(const NounPhrase& phrase, const Objects& for_these, std::size_t wanted, Problem& problem);
  Symbol mentioned_content(const Clause& clause, Role role) const;
  Symbol vessel_with(Symbol content) const;
  Symbol burner_for(Symbol object) const;
  Symbol surface() const;  // where things go that have to go somewhere
  Problem unknown_thing(const NounPhrase& phrase, Sort sort) const;
  Problem unknown_name(const std::string& word) const;
  Problem not_here(Problem problem) const;  // takes note: a thing is missing
  void remember(const Objects& objects);
  Problem act(const SymAction& macro);
  void keep_held(SymDelta& step) const;
  void close_tap();
  Problem keep(Symbol x, Symbol y, Where where);
  Clause what_holds_it(const Clause& said);
  Problem dispatch(const Clause& clause);
  bool holds(const Clause& statement, Problem& problem);
  // Whether it is on, open, full, ... now; nothing for states that no fact tells.
  std::optional<bool> is_so(Symbol object, const std::string& state) const;
  // Whether the clause is to be done, by its condition.
  bool wanted(const Clause& clause, Problem& problem);

  // frame_moves.cc: carrying things about
  Problem go(const Clause& clause);
  Problem take(const Clause& clause);
  Problem take_up(Symbol object);
  Problem put_on_tray(const Clause& clause);
  std::optional<Problem> give_content(const Clause& clause);
  std::optional<Problem> give(const Clause& clause);
  Problem put(const Clause& clause);
  Problem put_without_place(const Clause& clause);
  Problem stack(const Objects& objects);
  Symbol home_of(Symbol object) const;  // kNone: it has none here
  bool is_home(Symbol object, Symbol place) const;
  static NounPhrase it();
  NounPhrase unsaid() const;  // "it", or "them" where nothing was spoken of and both hands are full
  void put_what_is_unsaid(Clause& clause);
  bool lexicon_place(const NounPhrase& phrase);  // names furniture or fixtures, nothing that moves
  std::optional<Problem> put_on_each(const Clause& clause);
  std::optional<Problem> put_content(const Clause& clause, const NounPhrase& thing,
                                     const NounPhrase& destination, const Objects& vessels);
  Problem put_with(const NounPhrase& with, Symbol object, Where where);
  Problem put_at(const Clause& clause, const Objects& objects, const NounPhrase& destination);
  // "discard everything that is in the mug": nothing where it is not about what a vessel holds.
  std::optional<Problem> discard_content(const Clause& clause);
  Problem discard(const Clause& clause);
  Problem release(const Clause& clause);
  Problem swap(const Clause& clause);
  Problem clear(const Clause& clause);
  Problem cool(const Clause& clause);
  Problem insert(const Clause& clause);
  Problem play(const Clause& clause);

  // frame_kitchen.cc: water, heat and food
  Problem fill(const Clause& clause);
  Problem fill_one(Symbol vessel, Symbol content);
  Problem fill_with_water(Symbol vessel);
  Problem pour(const Clause& clause);
  Problem pour_into(Symbol source, Symbol vessel, bool named);
  Problem empty(const Clause& clause);
  Problem wash(const Clause& clause);
  Problem heat(const Clause& clause, bool boil);
  Problem heat_objects(const Objects& objects, bool microwave, const NounPhrase* where);
  Problem add_to(const Clause& clause);
  Problem add_content(const NounPhrase& what, Symbol target, bool& done);
  Problem scoop(const Clause& clause);
  Problem scoop_into(Symbol target, int times);
  Problem make(const Clause& clause);

  // frame_devices.cc: doors, knobs and the television
  Problem turn(const Clause& clause, int on);
  Problem turn_on(Symbol device, bool on, int number);
  bool is_on(Symbol device) const;
  Objects other_devices_on() const;
  static bool is_switched(Symbol thing);  // the television, the stove or a burner
  bool only_devices(const Clause& clause) const;
  Problem door(const Clause& clause, bool open);
  Problem open_or_close(Symbol thing, bool open, bool left, bool right);
  Problem television(const Clause& clause);
  bool about_television(const Clause& clause) const;
  const NounPhrase* channel_of_television(const Clause& clause) const;

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
