// Reads the tables of config/language.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "components/goalnet/language/language.h"

namespace goalnet::inference {

using nlohmann::json;
using std::string_view_literals::operator""sv;

namespace {

constexpr std::array<std::pair<std::string_view, Frame>, 31> kFrames = {{
    {"go", Frame::kGo},         {"take", Frame::kTake},       {"place", Frame::kPlace},
    {"bring", Frame::kBring},   {"discard", Frame::kDiscard}, {"fill", Frame::kFill},
    {"pour", Frame::kPour},     {"empty", Frame::kEmpty},     {"turn", Frame::kTurn},
    {"start", Frame::kStart},   {"stop", Frame::kStop},       {"open", Frame::kOpen},
    {"close", Frame::kClose},   {"wash", Frame::kWash},       {"heat", Frame::kHeat},
    {"boil", Frame::kBoil},     {"add", Frame::kAdd},         {"squeeze", Frame::kSqueeze},
    {"scoop", Frame::kScoop},   {"insert", Frame::kInsert},   {"release", Frame::kRelease},
    {"change", Frame::kChange}, {"mute", Frame::kMute},       {"raise", Frame::kRaise},
    {"lower", Frame::kLower},   {"try", Frame::kTry},         {"make", Frame::kMake},
    {"swap", Frame::kSwap},     {"clear", Frame::kClear},     {"cool", Frame::kCool},
    {"play", Frame::kPlay},
}};

Frame frame_named(std::string_view name) {
  for (const auto& [known, frame] : kFrames)
    if (known == name) return frame;
  return Frame::kNone;
}

// Calls `add` with each verb of a table by frames. Fails with kInvalidRequest: an unknown frame.
template <typename Add>
Expected<void> each_verb(const json& verbs, const std::string& name, Add add) {
  for (const auto& [frame_name, words] : verbs.items()) {
    const Frame frame = frame_named(frame_name);
    if (frame == Frame::kNone)
      return fail(Outcome::kInvalidRequest, name + ": 'verbs' has the unknown frame '" + frame_name + "'");
    for (const auto& word : words) add(word.template get<std::string>(), frame);
  }
  return {};
}

void add_words(const json& list, std::unordered_set<std::string>& words) {
  for (const auto& word : list) words.insert(word.get<std::string>());
}

std::vector<std::string> split_words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// Words with a part in the grammar itself.
constexpr std::array kGrammarWords = {
    "on"sv,       "off"sv,     "up"sv,         "down"sv,      "out"sv,      "away"sv,   "over"sv,
    "in"sv,       "back"sv,    "into"sv,       "onto"sv,      "inside"sv,   "from"sv,   "with"sv,
    "under"sv,    "beside"sv,  "near"sv,       "it"sv,        "them"sv,     "this"sv,   "that"sv,
    "these"sv,    "those"sv,   "me"sv,         "us"sv,        "all"sv,      "both"sv,   "each"sv,
    "every"sv,    "one"sv,     "and"sv,        "then"sv,      "or"sv,       "not"sv,    "never"sv,
    "without"sv,  "before"sv,  "after"sv,      "until"sv,     "while"sv,    "if"sv,     "unless"sv,
    "because"sv,  "except"sv,  "everything"sv, "something"sv, "anything"sv, "rest"sv,   "other"sv,
    "is"sv,       "are"sv,     "was"sv,        "should"sv,    "must"sv,     "need"sv,   "want"sv,
    "please"sv,   "the"sv,     "wish"sv,       "use"sv,       "using"sv,    "let"sv,    "forgot"sv,
    "somebody"sv, "someone"sv, "nobody"sv,     "everybody"sv, "everyone"sv, "he"sv,     "she"sv,
    "whatever"sv, "better"sv,  "ensure"sv,     "there"sv,     "here"sv,     "ones"sv,   "through"sv,
    "around"sv,   "upon"sv,    "towards"sv,    "toward"sv,    "below"sv,    "behind"sv, "against"sv,
    "to"sv,       "at"sv,      "by"sv,         "of"sv,        "for"sv,      "you"sv,    "i"sv,
    "we"sv,       "your"sv,    "my"sv};

}  // namespace

Expected<Language> Language::parse(std::string_view text, const std::string& name, const Lexicon& lexicon,
                                   Symbols& symbols) {
  Language language;
  language.lexicon_ = &lexicon;
  try {
    const json file = json::parse(text);
    const auto keep_first = [&](const std::string& verb, Frame frame) {  // of the frames that list it
      language.verbs_.try_emplace(verb, frame);
    };
    if (auto added = each_verb(file.at("verbs"), name, keep_first); !added)
      return tl::unexpected(added.error());
    for (const auto& [content, phrases] : file.at("contents").items())
      for (const auto& phrase : phrases)
        language.contents_[phrase.get<std::string>()] = symbols.intern(content);
    add_words(file.at("fillers"), language.fillers_);
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  language.collect_vocabulary();
  return language;
}

void Language::collect_vocabulary() {
  vocabulary_.clear();
  if (!rewrites_.empty()) {  // a language of whole sentences
    vocabulary_.insert(vocabulary_.end(), rewrites_.words().begin(), rewrites_.words().end());
    for (const std::string_view word : kGrammarWords) vocabulary_.emplace_back(word);
  }
  add_vocabulary();
}

void Language::add_vocabulary() {
  const auto add = [&](const auto& table) {
    for (const auto& [word, meaning] : table) vocabulary_.push_back(word);
  };
  add(verbs_), add(inflected_), add(lexicon_->words()), add(states_), add(wishes_);
  vocabulary_.insert(vocabulary_.end(), fillers_.begin(), fillers_.end());
  vocabulary_.insert(vocabulary_.end(), questions_.begin(), questions_.end());
  std::sort(vocabulary_.begin(), vocabulary_.end());
  vocabulary_.erase(std::unique(vocabulary_.begin(), vocabulary_.end()), vocabulary_.end());
}

// "a notch", "by two touches", "just a tad": how much more or less; nothing here has steps that could be
// told. The words are known, but no typing error is mended to one.
void Language::add_degrees(const std::vector<std::string>& units) {
  for (const std::string& unit : units)
    for (const std::string& word : {unit, unit + "s", unit + "es"}) {
      seen_.insert(word);
      for (const std::string by : {"", "by "})
        for (const std::string count :
             {"just a ", "just one ", "a wee ", "a little ", "a ", "one ", "another ", "two ", "three ",
              "a few ", "a couple of ", "a couple ", "some "}) {
          rewrites_.add(split_words(by + count + word), {});
        }
    }
}

Expected<void> Language::add_english(std::string_view text, const std::string& name) {
  std::vector<std::string> degrees;
  const auto keep_verb = [&](const std::string& verb, Frame frame) { verbs_[verb] = frame; };
  try {
    const json file = json::parse(text);
    if (auto added = each_verb(file.at("verbs"), name, keep_verb); !added) return added;
    for (const auto& [form, base] : file.at("inflected").items()) inflected_[form] = base.get<std::string>();
    add_words(file.at("fillers"), fillers_);
    for (const auto& word : file.at("no_fillers")) fillers_.erase(word.get<std::string>());
    for (const auto& word : file.at("no_verbs")) verbs_.erase(word.get<std::string>());
    add_words(file.at("questions"), questions_), add_words(file.at("no_adverbs"), no_adverbs_);
    for (const auto& [word, entry] : file.at("states").items())
      add_state(word, entry.value("wanted", ""), entry.value("complaint", ""), entry.value("opposite", ""));
    for (const auto& [word, command] : file.at("wishes").items())
      wishes_[word] = split_words(command.get_ref<const std::string&>());
    for (const auto& rule : file.at("rewrites")) {
      const auto from = split_words(rule.at(0).get_ref<const std::string&>());
      if (from.empty()) return fail(Outcome::kInvalidRequest, name + ": 'rewrites' has an empty phrase");
      rewrites_.add(from, split_words(rule.at(1).get_ref<const std::string&>()));
    }
    // Older models lack these.
    degrees = file.value("degrees", degrees);
    const json people = file.value("people", json::array()),
               mistaken = file.value("mistaken", json::object());
    add_words(people, people_), add_words(people, seen_);
    const json homes = file.value("homes", json::object());
    for (const auto& [name_of_class, places] : homes.items())
      homes_[name_of_class] = places.get<std::vector<std::string>>();
    for (const auto& [word, meant] : mistaken.items())
      mistaken_[word] = meant.get<std::vector<std::string>>();
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  collect_vocabulary();
  add_degrees(degrees);
  return {};
}

Expected<void> Language::add_talk(std::string_view text, const std::string& name) {
  const auto keep_verb = [&](const std::string& verb, Frame frame) { verbs_[verb] = frame; };
  try {
    const json file = json::parse(text);
    const auto words_of = [&](const char* section, std::unordered_set<std::string>& words) {
      add_words(file.value(section, json::array()), words);
    };
    if (auto added = each_verb(file.value("verbs", json::object()), name, keep_verb); !added) return added;
    const json inflected = file.value("inflected", json::object()),
               states = file.value("states", json::object()), wishes = file.value("wishes", json::object()),
               groups = file.value("groups", json::object()),
               mistaken = file.value("mistaken", json::object()),
               rewrites = file.value("rewrites", json::array());
    for (const auto& [form, base] : inflected.items()) inflected_[form] = base.get<std::string>();
    for (const auto& [word, meant] : mistaken.items())
      mistaken_[word] = meant.get<std::vector<std::string>>();
    words_of("fillers", fillers_), words_of("known", seen_), words_of("people", people_),
        words_of("people", seen_);
    words_of("no_adverbs", no_adverbs_);
    for (const auto& [word, entry] : states.items())
      add_state(word, entry.value("wanted", ""), entry.value("complaint", ""), entry.value("opposite", ""));
    for (const auto& [word, command] : wishes.items())
      wishes_[word] = split_words(command.get_ref<const std::string&>());
    add_vocabulary();  // typing errors are mended to these words, but not to those of the patterns
    PhraseRules::Groups phrases;
    for (const auto& [group, members] : groups.items())
      for (const auto& member : members)
        phrases[group].push_back(split_words(member.get_ref<const std::string&>()));
    for (const auto& rule : rewrites) {
      const auto from = split_words(rule.at(0).get_ref<const std::string&>());
      const auto to = split_words(rule.at(1).get_ref<const std::string&>());
      if (auto added = rewrites_.add_pattern(from, to, phrases); !added)
        return fail(Outcome::kInvalidRequest, name + ": " + rule.dump() + ": " + added.error().message);
    }
    seen_.insert(rewrites_.words().begin(), rewrites_.words().end());
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  hears_people_ = true;
  return {};
}

void Language::add_state(const std::string& word, const std::string& wanted, const std::string& complaint,
                         const std::string& opposite) {
  StateWord& state = states_[word];
  state.wanted = frame_named(wanted), state.complaint = frame_named(complaint);
  state.opposite = opposite;
}

Expected<void> Language::add_other_words(std::string_view text, const std::string& name) {
  try {
    const json file = json::parse(text);
    add_words(file.at("real_words"), real_words_);
    // Older models lack these.
    add_words(file.value("verbs", json::array()), english_verbs_);
    add_words(file.value("moves", json::array()), moves_);
    add_words(file.value("describing", json::array()), describing_);
    for (const auto& [word, other] : file.at("synonyms").items())
      if (!known(word) && known(other.get_ref<const std::string&>()))
        synonyms_[word] = other.get<std::string>();
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  return {};
}

Expected<void> Language::add_kinds(std::string_view text, const std::string& name) {
  try {
    const json file = json::parse(text);
    for (const auto& [kind, words] : file.at("kinds").items())
      for (const auto& word : words) kinds_.try_emplace(word.get<std::string>(), kind);
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  return {};
}

}  // namespace goalnet::inference
