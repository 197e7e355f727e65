#include "components/goalnet/gist/message.h"

#include <algorithm>
#include <set>

#include "components/goalnet/language/noun_phrase.h"

namespace goalnet::inference::gist {
namespace {

constexpr std::size_t kMostWordsOfName = 4;

bool ends_sentence(const std::string& word) { return word == "." || word == ":" || word == ";"; }

std::string base_form(const std::string& token, const Lexicon& lexicon, const Language& language) {
  if (ends_sentence(token)) return ".";
  std::string word = token;
  if (!language.known(word) && language.may_be_a_slip(word)) word = language.correct(word);
  if (lexicon.is_name(word)) return word;
  if (const std::string one = singular(word); lexicon.is_word_of_name(one)) return one;
  if (const std::string verb = language.verb_base(word); !verb.empty()) return verb;
  return word;
}

std::string sort_of(const std::string& token, const std::string& word, const Lexicon& lexicon,
                    const Language& language) {
  if (word == "." || word == ",") return word;
  if (small_number(word) > 0) return "number";
  if (lexicon.is_place_name(word)) return "place";
  if (lexicon.is_name(word)) return "thing";
  if (const Frame frame = language.verb(word); frame != Frame::kNone)
    return "verb " + std::to_string(static_cast<int>(frame));
  if (const std::string kind = language.kind_of(word); !kind.empty()) return "kind " + kind;
  if (language.person(word)) return "person";
  if (!language.filler(word) && language.english_verb(token)) return "action";
  if (language.known(word)) return "small";
  return language.real_word(word) ? "word" : "strange";
}

// The classes of what the phrase names best.
std::vector<ClassId> classes_of(const std::string& phrase, const Instruction& here, const Lexicon& lexicon) {
  if (!lexicon.is_name(phrase)) return {};
  std::set<ClassId> found;
  NameLevel best = NameLevel::kGeneric;
  for (const SeenObject& object : here.objects) {
    const NameLevel level = std::min(lexicon.names(phrase, object.symbol, object.class_id), NameLevel::kName);
    if (level < best) continue;
    if (level > best) found.clear();
    best = level;
    found.insert(object.class_id);
  }
  return {found.begin(), found.end()};
}

}  // namespace

int small_number(const std::string& word) {
  constexpr int kHighest = 6;                        // channels; there are fewer burners and seats
  if (word == "both" || word == "couple") return 0;  // how many, not which
  const int number = number_word(word) > 0 ? number_word(word) : ordinal_word(word);
  return number <= kHighest ? number : 0;
}

Message see_message(const std::vector<std::string>& tokens, const Instruction& here, const Lexicon& lexicon,
                    const Language& language) {
  Message message;
  message.spoken = tokens;
  for (const std::string& token : message.spoken) {
    message.words.push_back(base_form(token, lexicon, language));
    message.sorts.push_back(sort_of(token, message.words.back(), lexicon, language));
  }
  for (std::size_t i = 0; i < message.spoken.size();) {
    std::size_t length = std::min(kMostWordsOfName, message.spoken.size() - i);
    for (; length > 0; --length) {
      std::string phrase;
      for (std::size_t k = i; k < i + length; ++k) phrase += (k == i ? "" : " ") + message.words[k];
      Named named{i, i + length, classes_of(phrase, here, lexicon), language.content(phrase)};
      if (named.classes.empty() && named.content == symbol::kNone) continue;
      message.named.push_back(std::move(named));
      break;
    }
    i += std::max<std::size_t>(length, 1);
  }
  return message;
}

}  // namespace goalnet::inference::gist
