#include "components/goalnet/language/clause.h"

#include <algorithm>
#include <array>

namespace goalnet::inference {
namespace {

using std::string_view_literals::operator""sv;

template <std::size_t N>
bool one_of(const std::string& word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::array kInside = {"in"sv, "into"sv, "inside"sv};
constexpr std::array kTo = {"on"sv,    "onto"sv, "to"sv, "at"sv,     "over"sv, "under"sv,   "underneath"sv,
                            "below"sv, "near"sv, "by"sv, "beside"sv, "upon"sv, "towards"sv, "toward"sv};
constexpr std::array kParticles = {"on"sv, "off"sv, "up"sv, "down"sv, "out"sv, "away"sv, "over"sv, "in"sv};
constexpr std::array kPronouns = {"it"sv, "them"sv, "they"sv, "those"sv, "these"sv};
constexpr std::array kJoins = {"and"sv, ","sv, "then"sv, "or"sv};
constexpr std::array kAll = {"all"sv, "every"sv, "each"sv, "everything"sv};
constexpr std::array<std::pair<std::string_view, int>, 12> kNumbers = {{{"one", 1},
                                                                        {"two", 2},
                                                                        {"three", 3},
                                                                        {"four", 4},
                                                                        {"five", 5},
                                                                        {"1", 1},
                                                                        {"2", 2},
                                                                        {"3", 3},
                                                                        {"4", 4},
                                                                        {"5", 5},
                                                                        {"both", 2},
                                                                        {"couple", 2}}};
constexpr std::array<std::pair<std::string_view, int>, 8> kOrdinals = {{{"first", 1},
                                                                        {"second", 2},
                                                                        {"third", 3},
                                                                        {"fourth", 4},
                                                                        {"1st", 1},
                                                                        {"2nd", 2},
                                                                        {"3rd", 3},
                                                                        {"4th", 4}}};
constexpr std::array kAdjectives = {"empty"sv, "full"sv,  "left"sv, "right"sv, "nearest"sv, "closest"sv,
                                    "near"sv,  "other"sv, "hot"sv,  "clean"sv, "dirty"sv};

template <std::size_t N>
int number_of(const std::string& word, const std::array<std::pair<std::string_view, int>, N>& table) {
  for (const auto& [name, value] : table)
    if (name == word) return value;
  return 0;
}

class Parser {
 public:
  Parser(const Instruction& instruction, const Language& language)
      : words_(instruction.words), mentions_(instruction.mentions), language_(language) {}

  ParsedSentence parse() {
    bool fresh = true;  // a verb may open a clause here
    for (std::size_t i = 0; i < words_.size();) {
      const std::string& word = words_[i];
      const Mention* mention = mention_at(i);
      if (word == ".") {
        end_phrase_list();
        fresh = true;
        ++i;
        continue;
      }
      if (one_of(word, kJoins)) {
        fresh = true;
        joined_ = true;
        ++i;
        continue;
      }
      const Frame frame = language_.verb(word);
      const bool noun_here =
          mention != nullptr && !(fresh && !joined_ && frame != Frame::kNone && mention_at(i + 1));
      if (fresh && frame != Frame::kNone && !noun_here) {
        open_clause(frame, word);
        fresh = false;
        ++i;
        continue;
      }
      // "microwave the mug" at the start; "please", "could you" and the like keep the way open for the verb
      if (fresh && current_ == nullptr && mention == nullptr && language_.filler(word)) {
        ++i;
        continue;
      }
      i = current_ == nullptr ? outside(i, mention) : inside(i, mention);
      if (!(language_.filler(word) && mention == nullptr)) fresh = false;
      joined_ = false;
    }
    return std::move(result_);
  }

 private:
  const Mention* mention_at(std::size_t at) const {
    for (const Mention& mention : mentions_)
      if (mention.begin == static_cast<int>(at)) return &mention;
    return nullptr;
  }

  void open_clause(Frame frame, const std::string& verb) {
    result_.clauses.push_back(
        Clause{.frame = frame, .verb = verb, .phrases = {}, .particles = {}, .unknown = {}, .words = {verb}});
    current_ = &result_.clauses.back();
    role_ = Role::kDirect;
    pending_ = {};
    joined_ = false;
  }

  void end_phrase_list() {
    role_ = Role::kDirect;
    pending_ = {};
    joined_ = false;
  }

  std::size_t outside(std::size_t i, const Mention* mention) {
    const std::string& word = words_[i];
    if (mention != nullptr) return static_cast<std::size_t>(mention->end);
    if (!language_.filler(word) && !language_.known(word)) result_.stray.push_back(word);
    return i + 1;
  }

  // Whether something that names a thing follows before the next join or preposition.
  bool noun_follows(std::size_t i) const {
    for (std::size_t k = i + 1; k < words_.size(); ++k) {
      if (mention_at(k) != nullptr || one_of(words_[k], kPronouns)) return true;
      if (words_[k] == "." || one_of(words_[k], kJoins)) return false;
      if (one_of(words_[k], kTo) || one_of(words_[k], kInside) || words_[k] == "from" || words_[k] == "with")
        return false;
      if (!language_.known(words_[k])) return true;  // an unknown thing
    }
    return false;
  }

  void add_phrase(NounPhrase phrase) {
    phrase.role = role_;
    phrase.inside = inside_;
    current_->phrases.push_back(std::move(phrase));
    pending_ = {};
  }

  std::size_t inside(std::size_t i, const Mention* mention) {
    const std::string& word = words_[i];
    current_->words.push_back(word);
    if (mention != nullptr) {
      const std::size_t end = static_cast<std::size_t>(mention->end);
      // Two names side by side: the first says which of the second ("the shelf pillow").
      if (end < words_.size() && mention_at(end) != nullptr) {
        pending_.modifier = mention->phrase;
        return end;
      }
      NounPhrase phrase = pending_;
      phrase.phrase = mention->phrase;
      phrase.plural = mention->plural;
      add_phrase(std::move(phrase));
      return end;
    }
    if (one_of(word, kPronouns)) {
      NounPhrase phrase;
      phrase.pronoun = true;
      phrase.plural = word != "it";
      add_phrase(std::move(phrase));
      return i + 1;
    }
    const bool turning = current_->frame == Frame::kTurn;
    if (one_of(word, kParticles) &&
        (turning || !noun_follows(i) || word == "up" || word == "down" || word == "away")) {
      current_->particles.push_back(word);
      return i + 1;
    }
    if (word == "out" || word == "off") {
      current_->particles.push_back(word);
      if (i + 1 < words_.size() && words_[i + 1] == "of") {
        role_ = Role::kSource;
        return i + 2;
      }
      return i + 1;
    }
    if (one_of(word, kInside) || one_of(word, kTo)) {
      role_ = Role::kDestination;
      inside_ = one_of(word, kInside);
      pending_ = {};
      return i + 1;
    }
    if (word == "from") {
      role_ = Role::kSource;
      return i + 1;
    }
    if (word == "with" || word == "using") {
      role_ = Role::kWith;
      return i + 1;
    }
    if (one_of(word, kAll)) pending_.all = true;
    if (word == "some") pending_.some = true;
    if (const int count = number_of(word, kNumbers)) pending_.count = count;
    if (const int ordinal = number_of(word, kOrdinals)) pending_.ordinal = ordinal;
    if (one_of(word, kAdjectives)) pending_.adjectives.push_back(word);
    // An unknown word right before a name is an adjective nobody taught us; elsewhere it stands for a thing.
    if (!language_.known(word) && mention_at(i + 1) == nullptr) current_->unknown.push_back(word);
    return i + 1;
  }

  const std::vector<std::string>& words_;
  const std::vector<Mention>& mentions_;
  const Language& language_;
  ParsedSentence result_;
  Clause* current_ = nullptr;
  Role role_ = Role::kDirect;
  bool inside_ = false;
  bool joined_ = false;
  NounPhrase pending_;
};

}  // namespace

bool Clause::has(const std::string& word) const {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool Clause::has_particle(const std::string& word) const {
  return std::find(particles.begin(), particles.end(), word) != particles.end();
}

ParsedSentence parse_clauses(const Instruction& instruction, const Language& language) {
  return Parser(instruction, language).parse();
}

}  // namespace goalnet::inference
