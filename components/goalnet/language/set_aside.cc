// Readings of a message without the parts that are most likely background.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {
namespace {

using namespace word_group;

constexpr double kLeast = 0.35;  // how likely a part that is set aside must be background
constexpr double kSure = 0.8;    // the same of one that begins as orders do, or speaks of time or number
constexpr std::size_t kShortestRequest = 3;  // words
constexpr double kMostRequest = 0.1;         // less likely background surely asks for something
constexpr double kLeastIdle =
    0.15;  // the same of one that speaks of nothing here and begins as no order does
constexpr double kLeastBeside = 0.04;     // and begins with "for" or "if you", or is one word
constexpr std::size_t kMostParts = 16;    // longer messages are not searched: time is bounded
constexpr std::size_t kMostReadings = 6;  // that are tried

// Words that change what other parts ask for; a part that has one of them is never set aside.
constexpr std::array kTurnsRequest = {"if"sv,        "unless"sv,     "except"sv, "instead"sv,  "without"sv,
                                      "otherwise"sv, "until"sv,      "till"sv,   "rather"sv,   "wait"sv,
                                      "sorry"sv,     "actually"sv,   "mean"sv,   "whenever"sv, "other"sv,
                                      "anything"sv,  "everything"sv, "one"sv,    "ones"sv};
// Words of time and of how many: only where the part is surely background.
constexpr std::array kMayTurn = {"hour"sv,  "hours"sv,    "minutes"sv, "minute"sv, "mins"sv,
                                 "later"sv, "tomorrow"sv, "tonight"sv, "oclock"sv, "every"sv,
                                 "both"sv,  "all"sv,      "each"sv,    "only"sv};
constexpr std::array kJoins = {"and"sv, "then"sv, "please"sv, "so"sv, "but"sv};
// Nor one that begins with these, but for going on with one that is set aside ("I like glasses, not cans").
constexpr std::array kDenies = {"not"sv, "no"sv, "dont"sv, "never"sv, "nothing"sv, "nobody"sv};

// "if you can", "if it is no trouble"
bool polite(const std::vector<std::string>& tokens, std::size_t i) {
  static constexpr std::array kWhose = {"you"sv, "youd"sv, "youre"sv, "thats"sv, "possible"sv, "i"sv};
  static constexpr std::array kMay = {"can"sv,  "could"sv, "would"sv, "may"sv,    "are"sv,  "will"sv,
                                      "have"sv, "dont"sv,  "like"sv,  "manage"sv, "know"sv, "be"sv};
  return tokens[i] == "if" && i + 2 < tokens.size() && one_of(tokens[i + 1], kWhose) &&
         (one_of(tokens[i + 2], kMay) || tokens[i + 1] == "possible");
}

}  // namespace

// Whether the part asks for what nobody here can do or has: "iron my shirt", "could you mow the lawn". Half
// of what was asked for is no answer.
bool RobotLanguage::asks_for_unknown(const std::vector<std::string>& tokens, const SentencePart& part) const {
  static constexpr std::array kLeads = {"and"sv,  "then"sv, "please"sv, "so"sv,    "but"sv,
                                        "also"sv, "just"sv, "can"sv,    "could"sv, "would"sv,
                                        "will"sv, "you"sv,  "kindly"sv};
  static constexpr std::array kCourtesy = {
      "bless"sv,   "excuse"sv, "pardon"sv, "forgive"sv, "thank"sv,   "thanks"sv, "hurry"sv, "look"sv,
      "listen"sv,  "see"sv,    "mind"sv,   "guess"sv,   "believe"sv, "trust"sv,  "hope"sv,  "love"sv,
      "imagine"sv, "be"sv,     "have"sv,   "welcome"sv, "greet"sv,   "hi"sv,     "hello"sv, "cheers"sv,
      "like"sv,    "damn"sv,   "do"sv,     "is"sv,      "okay"sv,    "know"sv,   "cheer"sv, "watch"sv,
      "well"sv,    "dear"sv,   "lord"sv,   "man"sv};
  static constexpr std::array kSome = {"a"sv,       "an"sv,  "the"sv, "my"sv, "some"sv,
                                       "another"sv, "our"sv, "his"sv, "her"sv};
  std::size_t head = part.begin;
  while (head + 1 < part.end && one_of(tokens[head], kLeads)) ++head;
  bool names = false;  // something of this place
  for (std::size_t i = head; i < part.end; ++i)
    names = names || language_->names_thing(tokens[i]) ||
            language_->content(singular(tokens[i])) != symbol::kNone;
  if (names) return false;
  const std::string& verb = tokens[head];
  const bool plain =
      !(verb.size() > 5 && verb.ends_with("ing")) && !verb.ends_with("ed") && !verb.ends_with("s");
  // "iron my shirt": a noun before a determiner is a verb
  const bool slip = language_->may_be_a_slip(verb) && !language_->corrections(verb).empty();
  std::size_t object = head + 1;  // "sing us a song", "knit me a jumper"
  while (object + 1 < part.end && one_of(tokens[object], kPersons) && one_of(tokens[object + 1], kSome))
    ++object;
  // "jarvis my friend" is no order
  const bool to_somebody =
      one_of(tokens[part.end - 1], kCourtesy) ||
      (object < part.end && one_of(tokens[object], kPossessives) && language_->person(tokens[part.end - 1]));
  const bool sound = verb.find_first_of("aeiouy") == std::string::npos;  // "shhh the baby is asleep"
  const bool noun = !slip && !sound && !to_somebody && !language_->known(verb) && head + 1 < part.end;
  // whether the part ends with a thing that nobody here has
  std::size_t last = object;
  while (last < part.end && (one_of(tokens[last], kSome) || language_->describes(tokens[last]))) ++last;
  const bool of_unknown = last > object && last + 1 == part.end && !language_->known(tokens[last]) &&
                          (language_->real_word(tokens[last]) || !language_->kind_of(tokens[last]).empty());
  if (!plain || one_of(verb, kCourtesy) || one_of(verb, kTurnsRequest) || one_of(verb, kPastForms))
    return false;
  // "clean my car"; but "take a break", "hold the line" say nothing of things
  static constexpr std::array kDone = {Frame::kWash,   Frame::kHeat,  Frame::kBoil,   Frame::kOpen,
                                       Frame::kClose,  Frame::kFill,  Frame::kPour,   Frame::kEmpty,
                                       Frame::kAdd,    Frame::kScoop, Frame::kTurn,   Frame::kStop,
                                       Frame::kInsert, Frame::kSwap,  Frame::kDiscard};
  if (const Frame frame = language_->verb(verb); frame != Frame::kNone)
    return of_unknown && std::find(kDone.begin(), kDone.end(), frame) != kDone.end();
  // that are nouns more often
  static constexpr std::array kVerbsToo = {"order"sv, "phone"sv, "mail"sv, "email"sv,  "text"sv,  "post"sv,
                                           "iron"sv,  "dust"sv,  "mop"sv,  "hoover"sv, "paint"sv, "hammer"sv};
  if (!language_->english_verb(verb) && !noun && !one_of(verb, kVerbsToo)) return false;
  // "order a pizza" is no way of putting one, "iron my shirt" no way of pressing a button; "share the good
  // news" may be small talk
  if (language_->synonym(verb) != verb) return of_unknown;
  const bool behind = head > part.begin && (tokens[head - 1] == "and" || tokens[head - 1] == "then");
  return head + 1 == part.end ? behind  // "and dance"
                              : object < part.end && one_of(tokens[object], kSome);
}

// "I also need the newspaper"
bool RobotLanguage::needs_unknown(const std::vector<std::string>& tokens, const SentencePart& part) const {
  static constexpr std::array kNeeds = {"need"sv, "want"sv, "fancy"sv, "require"sv};
  std::size_t head = part.begin;
  while (head < part.end &&
         (tokens[head] == "i" || tokens[head] == "we" || tokens[head] == "also" || tokens[head] == "and"))
    ++head;
  return head > part.begin && head + 3 == part.end && one_of(tokens[head], kNeeds) &&
         (one_of(tokens[head + 1], kDeterminers) || one_of(tokens[head + 1], kPossessives));
}

// Whether the part names nothing of this place, not even by "it", and does not begin as orders do.
bool RobotLanguage::idle(const std::vector<std::string>& tokens, const SentencePart& part) const {
  static constexpr std::array kPoints = {"it"sv,      "them"sv, "that"sv, "those"sv, "this"sv,
                                         "one"sv,     "ones"sv, "here"sv, "there"sv, "some"sv,
                                         "another"sv, "more"sv, "again"sv};
  std::size_t head = part.begin;
  while (head + 1 < part.end && one_of(tokens[head], kJoins)) ++head;
  // "a napkin" may be asked for, "a napkin is missing" tells
  const bool named = one_of(tokens[head], kDeterminers) || one_of(tokens[head], kPossessives);
  bool told = one_of(tokens[head], kSubjects) || tokens[head] == "for" || tokens[head] == "if" ||
              tokens[head] == "no" || (!named && !language_->english_verb(tokens[head])) ||
              part.end - head == 1;
  for (std::size_t i = head; i < part.end && named; ++i) told = told || language_->copula(tokens[i]);
  if (!told) return false;
  for (std::size_t i = part.begin; i < part.end; ++i) {
    const std::string stem = singular(tokens[i]);
    const bool no_more = tokens[i] == "more" && i > part.begin && tokens[i - 1] == "no";
    const bool particle = one_of(tokens[i], kParticles) && i > part.begin &&
                          language_->english_verb(tokens[i - 1]) &&
                          !language_->copula(tokens[i - 1]);  // "kick off", "walk around"
    const bool modal = tokens[i] == "can" && i > part.begin && one_of(tokens[i - 1], kSubjects);
    if ((language_->names_thing(stem) && !modal) || language_->content(stem) != symbol::kNone ||
        (one_of(tokens[i], kPoints) && !no_more) ||
        (language_->may_be_a_slip(tokens[i]) && !language_->corrections(tokens[i]).empty()) ||
        (language_->wanted_by_state(tokens[i]) != Frame::kNone && !particle) ||
        language_->wish(tokens[i]) != nullptr)
      return false;
  }
  return true;
}

std::vector<SentencePart> RobotLanguage::parts(const std::vector<std::string>& tokens) const {
  return sentence_parts(tokens, *language_);
}

std::vector<std::string> RobotLanguage::without(const std::vector<std::string>& tokens,
                                                const std::vector<SentencePart>& parts,
                                                const std::vector<bool>& aside) const {
  return without_parts(tokens, parts, aside, *language_, *lexicon_);
}

std::vector<RobotLanguage::WithoutBackground> RobotLanguage::without_background(
    const std::vector<std::string>& tokens) const {
  const std::vector<SentencePart> parts = this->parts(tokens);
  if (parts.size() > kMostParts) return {};
  std::vector<double> likely(parts.size(), 0);
  std::vector<std::size_t> order;  // of those that may be set aside, the likeliest background first
  bool aside_before = false;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    bool may = !asks_for_unknown(tokens, parts[p]) && !needs_unknown(tokens, parts[p]), may_turn = false;
    for (std::size_t i = parts[p].begin; i < parts[p].end; ++i) {
      may = may && (!one_of(tokens[i], kTurnsRequest) || polite(tokens, i));
      may_turn = may_turn || one_of(tokens[i], kMayTurn);
    }
    const bool idle = this->idle(tokens, parts[p]);
    if (one_of(tokens[parts[p].begin], kDenies) && (!idle || parts[p].end - parts[p].begin == 1))
      may = may && p > 0 && aside_before;
    if (may) likely[p] = background_.of(parts[p].signs);
    std::size_t head = parts[p].begin;
    while (head + 1 < parts[p].end && one_of(tokens[head], kJoins)) ++head;
    const std::string& first = tokens[head];
    const bool orders = language_->verb(first) != Frame::kNone && language_->verb_base(first) == first;
    const bool one_word = parts[p].end - parts[p].begin == 1;
    const bool beside = first == "for" || first == "if" || one_word;
    // "lend me your ears and that book": what goes on with "and" may be of the same order
    if (p + 1 < parts.size() && tokens[parts[p + 1].begin] == "and" && language_->english_verb(first) &&
        !one_word &&
        (one_of(tokens[parts[p + 1].begin + 1], kDeterminers) ||
         one_of(tokens[parts[p + 1].begin + 1], kPointers)))
      continue;
    if (likely[p] >= ((orders && !(one_word && idle)) || may_turn ? kSure
                      : !idle                                     ? kLeast
                      : beside                                    ? kLeastBeside
                                                                  : kLeastIdle))
      order.push_back(p);
    aside_before = !order.empty() && order.back() == p;
  }
  // "[I'm dying] [for that drink in the fridge]": what is kept hangs on what stands before it
  std::erase_if(order, [&](std::size_t p) {
    return p + 1 < parts.size() && parts[p].end == parts[p + 1].begin && tokens[parts[p].end] == "for" &&
           std::find(order.begin(), order.end(), p + 1) == order.end();
  });
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return likely[a] > likely[b]; });
  std::vector<WithoutBackground> readings;
  const auto add = [&](const std::vector<bool>& aside) {
    if (readings.size() >= kMostReadings || std::find(aside.begin(), aside.end(), false) == aside.end())
      return;
    WithoutBackground reading{without(tokens, parts, aside), {}};
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (aside[p] || background(parts[p]) > kMostRequest || idle(tokens, parts[p])) continue;
      if (parts[p].end - parts[p].begin < kShortestRequest) continue;
      std::vector<bool> more = aside;
      more[p] = true;
      if (std::find(more.begin(), more.end(), false) != more.end())
        reading.less.push_back(without(tokens, parts, more));
    }
    readings.push_back(std::move(reading));
  };
  // All of them is the most probable choice, then all but the least sure, and so on; perhaps only one is in
  // the way.
  for (std::size_t count = order.size(); count > 0; --count) {
    std::vector<bool> aside(parts.size(), false);
    for (std::size_t i = 0; i < count; ++i) aside[order[i]] = true;
    add(aside);
  }
  for (std::size_t i = 1; i < order.size(); ++i) {
    std::vector<bool> aside(parts.size(), false);
    aside[order[i]] = true;
    add(aside);
  }
  return readings;
}

}  // namespace goalnet::inference
