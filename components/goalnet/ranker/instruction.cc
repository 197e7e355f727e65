#include "components/goalnet/ranker/instruction.h"

#include <algorithm>
#include <array>
#include <set>

namespace goalnet::inference {
namespace {

constexpr std::size_t kLongestName = 4;  // words
constexpr std::size_t kMaxObjects = 10000;

bool is_filler(const std::string& word) {
  static constexpr std::array<std::string_view, 14> kFillers = {"the",    "a",    "an",      ".",    ",",
                                                                "please", "and",  "then",    "now",  "kindly",
                                                                "also",   "next", "finally", "could"};
  return std::find(kFillers.begin(), kFillers.end(), word) != kFillers.end();
}

bool is_article(const std::string& word) { return word == "the" || word == "a" || word == "an"; }

void find_mentions(Instruction& instruction, const Lexicon& lexicon, const std::vector<bool>& plural) {
  const auto& words = instruction.words;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t length = std::min(kLongestName, words.size() - i);
    std::string phrase;
    for (; length > 0; --length) {
      phrase = words[i];
      for (std::size_t k = 1; k < length; ++k) phrase += " " + words[i + k];
      if (lexicon.is_name(phrase)) break;
    }
    if (length == 0) {
      ++i;
      continue;
    }
    instruction.mentions.push_back(
        {static_cast<int>(i), static_cast<int>(i + length), phrase, plural[i + length - 1]});
    i += length;
  }
}

// The frame of each word; 0 for what is no verb or stands in the name of a thing ("spoon").
std::vector<std::uint32_t> find_frames(Instruction& instruction, const Language& language) {
  std::vector<std::uint32_t> frames;
  for (const std::string& word : instruction.words)
    frames.push_back(static_cast<std::uint32_t>(language.verb(word)));
  for (const Mention& mention : instruction.mentions)
    for (int i = mention.begin; i < mention.end; ++i) frames[static_cast<std::size_t>(i)] = 0;
  const auto first =
      std::find_if(frames.begin(), frames.end(), [](std::uint32_t frame) { return frame != 0; });
  if (first != frames.end()) instruction.first_frame = *first;
  return frames;
}

void hash_words(Instruction& instruction, const std::vector<std::uint32_t>& frames) {
  constexpr std::uint32_t kFrame = 0x46000000u;
  std::vector<std::uint32_t> words = {hash_text("<s>")}, common = words;  // common: verbs by their frames
  for (std::size_t i = 0; i < frames.size(); ++i) {
    words.push_back(hash_text(instruction.words[i]));
    common.push_back(frames[i] != 0 ? kFrame + frames[i] : words.back());
  }
  instruction.unigrams.assign(words.begin() + 1, words.end());
  instruction.unigrams.insert(instruction.unigrams.end(), common.begin() + 1, common.end());
  for (auto* list : {&words, &common}) {
    list->push_back(hash_text("</s>"));
    for (std::size_t i = 1; i < list->size(); ++i)
      instruction.bigrams.push_back((*list)[i - 1] * 31u + (*list)[i]);
  }
  for (auto* list : {&instruction.unigrams, &instruction.bigrams}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  const auto first = std::find_if_not(instruction.words.begin(), instruction.words.end(), is_filler);
  if (first != instruction.words.end()) instruction.first_verb = hash_text(*first);
}

// The words of a grounding key stand without blanks ("coffeetable"): where do they stand in the sentence?
int find_joined(const std::vector<std::string>& words, const std::string& key) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string joined;
    for (std::size_t k = i; k < words.size() && joined.size() < key.size(); ++k) {
      joined += words[k];
      if (joined == key || singular(key) == joined) return static_cast<int>(i);
    }
  }
  return -1;
}

void ground(Instruction& instruction, const Grounding& grounding, const Symbols& symbols) {
  for (const auto& [key, names] : grounding) {
    const int at = find_joined(instruction.words, key);
    int mention = -1;
    for (std::size_t m = 0; m < instruction.mentions.size(); ++m)
      if (instruction.mentions[m].begin <= at && at < instruction.mentions[m].end)
        mention = static_cast<int>(m);
    if (mention < 0) {
      mention = static_cast<int>(instruction.mentions.size());
      instruction.mentions.push_back({std::max(at, 0), std::max(at, 0) + 1, key, false});
    }
    int rivals = 0;
    for (const std::string& name : names) rivals += instruction.find(symbols.find(name)) >= 0;
    for (const std::string& name : names) {
      const int found = instruction.find(symbols.find(name));
      if (found < 0) continue;
      SeenObject& object = instruction.objects[static_cast<std::size_t>(found)];
      if (object.grounded && object.rivals <= rivals) continue;
      object.grounded = true;
      object.mention = mention;
      object.rivals = rivals;
    }
  }
}

}  // namespace

std::uint32_t hash_text(std::string_view text) {
  std::uint32_t hash = 0x811c9dc5u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193u;
  return hash;
}

Instruction see_instruction(const std::vector<std::string>& words, const Grounding* grounding,
                            const std::vector<std::string>& objects, Lexicon& lexicon,
                            const Language& language, Symbols& symbols) {
  Instruction instruction;
  std::vector<bool> plural;
  for (const std::string& word : words) {
    if (is_article(word)) continue;
    if (word == "." && instruction.words.empty()) continue;  // many recorded sentences begin with a stop
    std::string normal = singular(word);
    plural.push_back(normal != word);
    if (!lexicon.is_word_of_name(normal) && language.verb(normal) == Frame::kNone)
      normal = language.synonym(normal);
    instruction.words.push_back(std::move(normal));
  }
  if (!instruction.words.empty() && instruction.words.back() == ".") instruction.words.pop_back();

  find_mentions(instruction, lexicon, plural);
  const std::vector<std::uint32_t> frames = find_frames(instruction, language);
  hash_words(instruction, frames);

  std::set<std::string> names(objects.begin(), objects.end());
  for (const std::string& name : names) {
    const Symbol symbol = symbols.intern(name);
    if (symbol == symbol::kNone || symbol == symbol::kRobot) continue;
    if (instruction.index.size() <= symbol) instruction.index.resize(symbol + 1u, -1);
    if (instruction.index[symbol] >= 0 || instruction.objects.size() >= kMaxObjects) continue;
    instruction.index[symbol] = static_cast<std::int16_t>(instruction.objects.size());
    instruction.objects.push_back(
        {.symbol = symbol, .name_hash = hash_text(name), .class_id = lexicon.class_of(symbol, symbols)});
  }
  std::vector<std::uint8_t> count(lexicon.classes(), 0);
  for (SeenObject& object : instruction.objects) {
    object.rank = count[object.class_id];
    if (count[object.class_id] < 255) ++count[object.class_id];
  }
  for (SeenObject& object : instruction.objects) object.of_class = count[object.class_id];

  for (std::size_t m = 0; m < instruction.mentions.size(); ++m) {
    const std::string& phrase = instruction.mentions[m].phrase;
    NameLevel best = NameLevel::kNone;
    int rivals = 0;
    for (const SeenObject& object : instruction.objects) {
      const NameLevel level = lexicon.names(phrase, object.symbol, object.class_id);
      if (level > best) best = level, rivals = 0;
      rivals += level == best && level != NameLevel::kNone;
    }
    for (SeenObject& object : instruction.objects) {
      const NameLevel level = lexicon.names(phrase, object.symbol, object.class_id);
      if (level == NameLevel::kNone || level <= object.level) continue;
      object.level = level;
      object.mention = static_cast<int>(m);
      object.rivals = level == best ? rivals : 100;
    }
  }
  if (grounding != nullptr) {
    instruction.grounding_given = true;
    ground(instruction, *grounding, symbols);
  }
  for (SeenObject& object : instruction.objects) {
    if (object.mention < 0) continue;
    const int begin = instruction.mentions[static_cast<std::size_t>(object.mention)].begin;
    object.word_before = begin > 0 ? hash_text(instruction.words[static_cast<std::size_t>(begin - 1)]) : 1;
    object.clause = instruction.first_frame;
    for (int i = 0; i < begin; ++i)
      if (const std::uint32_t frame = frames[static_cast<std::size_t>(i)]; frame != 0) object.clause = frame;
  }
  return instruction;
}

}  // namespace goalnet::inference
