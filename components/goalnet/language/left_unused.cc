#include "components/goalnet/language/left_unused.h"

#include <algorithm>
#include <set>

#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/resolve.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

using namespace word_group;

constexpr std::array kTurnsRound = {
    "not"sv,    "no"sv,      "never"sv,  "nothing"sv,  "nobody"sv,  "without"sv, "except"sv, "but"sv,
    "only"sv,   "instead"sv, "rather"sv, "unless"sv,   "neither"sv, "nor"sv,     "none"sv,   "isnt"sv,
    "doesnt"sv, "didnt"sv,   "cant"sv,   "shouldnt"sv, "wont"sv,    "nope"sv,    "nah"sv,    "dont"sv};
constexpr std::array kOwnsSlip = {"sorry"sv, "oops"sv, "whoops"sv,   "hmm"sv,
                                  "um"sv,    "uh"sv,   "actually"sv, "scratch"sv};
// A part with one of these speaks of what is not meant.
constexpr std::array kDeniesPart = {
    "or"sv,     "not"sv,     "no"sv,       "dont"sv,    "never"sv, "without"sv, "except"sv,    "but"sv,
    "only"sv,   "instead"sv, "forget"sv,   "nor"sv,     "than"sv,  "nothing"sv, "cant"sv,      "isnt"sv,
    "doesnt"sv, "didnt"sv,   "shouldnt"sv, "wouldnt"sv, "wont"sv,  "arent"sv,   "correction"sv};
// What stands before a part that begins with one of these is taken back.
constexpr std::array kTakesBack = {"no"sv,         "sorry"sv,   "wait"sv, "actually"sv, "mean"sv,
                                   "correction"sv, "instead"sv, "not"sv,  "rather"sv,   "never"sv};
constexpr std::array kDeniesName = {"no"sv, "not"sv, "without"sv, "except"sv, "nor"sv, "never"sv, "than"sv};
constexpr std::array kLeaves = {"leave"sv, "keep"sv, "stay"sv, "remain"sv, "keeps"sv, "leaves"sv};
// "the pillow beside the beer", "the burner the kettle is on": may only tell where.
constexpr std::array kBeside = {"beside"sv,   "near"sv,    "next"sv,   "by"sv,    "with"sv,
                                "under"sv,    "behind"sv,  "close"sv,  "lying"sv, "sitting"sv,
                                "standing"sv, "nearest"sv, "closest"sv};
constexpr std::array kIs = {"is"sv, "are"sv, "was"sv, "has"sv};
constexpr std::array kBeforeOne = {"number"sv,   "burner"sv, "ring"sv,  "armchair"sv, "shelf"sv,
                                   "loveseat"sv, "couch"sv,  "plate"sv, "book"sv,     "pillow"sv};
constexpr std::array kTellsTime = {"at"sv, "since"sv, "until"sv, "till"sv, "by"sv, "for"sv, "around"sv};
constexpr std::size_t kReach = 3;  // words that a denial or a correction reaches over

using Names = std::set<std::string>;

bool in(const Names& names, const Names& others) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return others.contains(name); });
}

class Reader {
 public:
  Reader(const Words& said, const std::vector<SymAction>& actions, const Instruction& instruction,
         const SymState& start, const Language& language, const Lexicon& lexicon, const Symbols& symbols)
      : text_(said.text),
        names_(said, language, lexicon),
        actions_(actions),
        instruction_(instruction),
        start_(start),
        language_(language),
        lexicon_(lexicon),
        symbols_(symbols) {
    for (const SymAction& action : actions)
      for (const Symbol object : {action.x, action.y})
        if (object != symbol::kNone) use(symbols.name(object));
    for (const SymAction& action : actions)  // "two scoops of ice cream"
      counts_.insert(static_cast<int>(std::count(actions.begin(), actions.end(), action)));
    std::vector<std::pair<std::string, std::string>> stands;
    for (const SymFact fact : start.facts())
      if (relation_of(fact) == Relation::kOn || relation_of(fact) == Relation::kIn)
        stands.emplace_back(symbols.name(subject_of(fact)), symbols.name(object_of(fact)));
    concerned_ = used_;
    for (const auto& [thing, place] : stands)
      if (used_.contains(thing)) concerned_.insert(place);
    const Names with_parts = concerned_;
    for (const std::string& name : with_parts) add_whole(name);
    for (const SymAction& action : actions)
      if (action.verb == Verb::kPour) concerned_.insert("Sink");  // away
    // "stop heating the kettle": what stands on the burner
    for (const auto& stand : stands)
      if (std::any_of(used_.begin(), used_.end(),
                      [&](const std::string& knob) { return works(knob, stand.second); }))
        concerned_.insert(stand.first);
    around_ = concerned_;
    for (const auto& [thing, place] : stands)
      if (concerned_.contains(place)) around_.insert(thing);
  }

  LeftUnused read() {
    if (actions_.empty()) return {};  // it is so already: nothing need be used
    for (std::size_t i = 0, length; i < text_.size(); i += length) {
      length = std::max<std::size_t>(names_.name_length(i), 1);
      if (names_.name_length(i) > 0) look_at(i, i + length);
    }
    numbers();
    denials();
    return std::move(result_);
  }

 private:
  template <class Group>
  bool has(std::size_t from, std::size_t to, const Group& words) const {
    for (std::size_t i = from; i < std::min(to, text_.size()); ++i)
      if (one_of(text_[i], words)) return true;
    return false;
  }
  bool holds(Symbol content) const {
    return std::any_of(actions_.begin(), actions_.end(), [&](const SymAction& action) {
      return start_.is(action.x, content) || start_.is(action.y, content);
    });
  }

  // A scoop is of the ice cream.
  void use(const std::string& name) {
    used_.insert(name);
    const std::size_t scoop = name.find("Scoop");
    if (scoop == std::string::npos) return;
    for (const SeenObject& object : instruction_.objects)
      if (const std::string& whole = symbols_.name(object.symbol); whole.starts_with(name.substr(0, scoop)))
        used_.insert(whole);
  }

  // Whether a knob, button or door belongs to a place.
  static bool works(const std::string& knob, const std::string& place) {
    if (knob.starts_with("StoveKnob_")) return place == "StoveFire_" + knob.substr(knob.size() - 1);
    return knob != place && (place == "Fridge" || place == "Microwave" || place == "Sink") &&
           knob.starts_with(place);
  }

  // What belongs to a part that is used: the stove and the burner to a knob, the television to its buttons.
  void add_whole(const std::string& name) {
    for (const char* knob : {"StoveKnob_", "StoveFire_"})
      if (name.starts_with(knob)) {
        concerned_.insert("Stove");
        concerned_.insert("StoveFire_" + name.substr(name.size() - 1));
        concerned_.insert("StoveKnob_" + name.substr(name.size() - 1));
      }
    for (const char* whole : {"Fridge", "Microwave", "Sink", "Tv_1"})
      if (name.starts_with(whole) && !name.starts_with("Tv_1Remote"))
        for (const SeenObject& object : instruction_.objects)
          if (const std::string& part = symbols_.name(object.symbol);
              part.starts_with(whole) && !part.starts_with("Tv_1Remote"))
            concerned_.insert(part);
  }

  std::string phrase(std::size_t begin, std::size_t end) const {
    std::string name = text_[begin];
    for (std::size_t i = begin + 1; i < end; ++i) name += " " + text_[i];
    return name;
  }

  Names meant_by(const std::string& name, NameLevel least) const {
    Names meant;
    for (const SeenObject& object : instruction_.objects)
      if (lexicon_.names(name, object.symbol, object.class_id) >= least)
        meant.insert(symbols_.name(object.symbol));
    return meant;
  }

  void look_at(std::size_t begin, std::size_t end) {
    const std::string name = phrase(begin, end);
    if (language_.verb(name) != Frame::kNone || !seen_.insert(name).second) return;
    const Names any = meant_by(name, NameLevel::kGeneric), meant = meant_by(name, NameLevel::kName);
    if (any.empty()) return;
    if (const Symbol content = language_.content(name); content != symbol::kNone)
      if (meant.empty() || holds(content)) return;  // "the coffee": the mug with it
    std::set<ClassId> classes;
    bool carried = false;
    for (const SeenObject& object : instruction_.objects)
      if ((meant.empty() ? any : meant).contains(symbols_.name(object.symbol))) {
        carried = carried || lexicon_.object_class(object.class_id).movable;
        if (classes.insert(object.class_id).second) counts_.insert(object.of_class);
      }
    if (in(any, concerned_)) return;
    std::size_t part = begin, part_end = end;
    while (part > 0 && !ends_part(text_, part - 1)) --part;
    while (!ends_part(text_, part_end)) ++part_end;
    const bool denied = has(part, part_end, kDeniesPart) ||
                        has(part_end + 1, part_end + 1 + kReach, kTakesBack) ||
                        (part > 1 && (text_[part - 2] == "no" || text_[part - 2] == "not"));
    if (denied || has(part, part_end, kLeaves)) return;
    const bool beside = has(begin < kReach ? 0 : begin - kReach, begin, kBeside) || has(part, part_end, kIs);
    if (beside && in(any, around_))
      ++result_.beside;
    else if (meant.empty())
      return;  // "dish": for many kinds of things
    else
      ++(carried ? result_.things : result_.places);
    result_.words.push_back(name);
  }

  void numbers() {
    std::set<int> known;
    for (const std::string& name : concerned_) known.insert(number_of(name));
    std::set<ClassId> classes;
    std::vector<std::pair<ClassId, int>> used;
    for (const SeenObject& object : instruction_.objects)
      if (used_.contains(symbols_.name(object.symbol))) {
        const auto at =
            std::find_if(used.begin(), used.end(), [&](auto& c) { return c.first == object.class_id; });
        if (at == used.end())
          used.emplace_back(object.class_id, 1);
        else
          ++at->second;
      }
    for (const auto& [id, count] : used) counts_.insert(count);
    counts_.insert(static_cast<int>(actions_.size()));
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const int number = std::max(number_word(text_[i]), ordinal_word(text_[i]));
      if (number == 0 || number > 10 || known.contains(number) || counts_.contains(number)) continue;
      if (text_[i] == "one" && (i == 0 || !one_of(text_[i - 1], kBeforeOne))) continue;
      if (text_[i] == "both" || (i > 0 && one_of(text_[i - 1], kTellsTime))) continue;
      std::size_t part = i, part_end = i;
      while (part > 0 && !ends_part(text_, part - 1)) --part;
      while (!ends_part(text_, part_end)) ++part_end;
      if (has(part, part_end, kDeniesPart)) continue;
      bool channel = false;
      for (std::size_t k = i < 2 ? 0 : i - 2; k < std::min(i + 2, text_.size()); ++k)
        channel = channel || text_[k] == "channel";
      if (channel && (changes_channel() || on_channel(number))) continue;
      ++result_.numbers;
      result_.words.push_back(text_[i]);
    }
  }

  bool changes_channel() const {
    return std::any_of(used_.begin(), used_.end(),
                       [](const std::string& name) { return name.find("Channel") != std::string::npos; });
  }
  bool on_channel(int number) const {
    const Symbol channel = symbols_.find("Channel" + std::to_string(number));
    return channel != symbol::kNone &&
           std::any_of(start_.facts().begin(), start_.facts().end(), [&](SymFact fact) {
             return relation_of(fact) == Relation::kState && object_of(fact) == channel;
           });
  }

  void denials() {
    for (std::size_t i = 0; i < text_.size(); ++i) {
      if (!one_of(text_[i], kDeniesName)) continue;
      for (std::size_t k = i + 1; k < i + 1 + kReach && !ends_part(text_, k); ++k) {
        if (names_.name_length(k) == 0) continue;
        const std::string name = phrase(k, k + names_.name_length(k));
        if (in(meant_by(name, NameLevel::kGeneric), used_)) {
          ++result_.denied_used;
          result_.words.push_back(text_[i] + " " + name);
        }
        break;
      }
    }
  }

  const std::vector<std::string>& text_;
  const NounPhraseReader names_;
  const std::vector<SymAction>& actions_;
  const Instruction& instruction_;
  const SymState& start_;
  const Language& language_;
  const Lexicon& lexicon_;
  const Symbols& symbols_;
  Names used_, concerned_, around_;  // see LeftUnused
  Names seen_;
  std::set<int> counts_;  // how many there are of what is named or used
  LeftUnused result_;
};

}  // namespace

LeftUnused left_unused(const Words& said, const std::vector<SymAction>& actions,
                       const Instruction& instruction, const SymState& start, const Language& language,
                       const Lexicon& lexicon, const Symbols& symbols) {
  return Reader(said, actions, instruction, start, language, lexicon, symbols).read();
}

bool turns_round(const std::string& word) { return one_of(word, kTurnsRound); }

bool owns_slip(const std::string& word) { return one_of(word, kOwnsSlip); }

}  // namespace goalnet::inference
