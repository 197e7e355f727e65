#include "components/goalnet/encoder/wordpiece.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>

namespace goalnet::inference {
namespace {

constexpr std::size_t kMaxVocabulary = 1000000;
constexpr std::size_t kLongestWord = 100;  // characters; longer ones are unknown, as in the original

// The next code point of UTF-8 text, or -1 for a byte that starts none; `at` moves on.
std::int32_t next_code(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  const int length = lead < 0x80   ? 1
                     : lead < 0xc2 ? 0
                     : lead < 0xe0 ? 2
                     : lead < 0xf0 ? 3
                     : lead < 0xf5 ? 4
                                   : 0;
  if (length == 0 || at + static_cast<std::size_t>(length) > text.size()) {
    ++at;
    return -1;
  }
  std::int32_t code = length == 1 ? lead : lead & (0x7f >> length);
  for (int i = 1; i < length; ++i) {
    const unsigned char part = byte(at + static_cast<std::size_t>(i));
    if ((part & 0xc0) != 0x80) {
      ++at;
      return -1;
    }
    code = code << 6 | (part & 0x3f);
  }
  at += static_cast<std::size_t>(length);
  return code;
}

void append(std::string& text, std::int32_t code) {
  const auto put = [&text](std::int32_t byte) { text.push_back(static_cast<char>(byte)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6), put(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    put(0xe0 | code >> 12), put(0x80 | (code >> 6 & 0x3f)), put(0x80 | (code & 0x3f));
  } else {
    put(0xf0 | code >> 18), put(0x80 | (code >> 12 & 0x3f)), put(0x80 | (code >> 6 & 0x3f)),
        put(0x80 | (code & 0x3f));
  }
}

// Lower case without accent, for ASCII and the letters of western Europe (U+00C0 to U+00FF); others stay.
std::int32_t plain(std::int32_t code) {
  if (code >= 'A' && code <= 'Z') return code + 32;
  constexpr std::string_view kBase = "aaaaaa ceeeeiiii nooooo  uuuuy  aaaaaa ceeeeiiii nooooo  uuuuy y";
  static_assert(kBase.size() == 64);
  if (code < 0xc0 || code > 0xff) return code;
  const char base = kBase[static_cast<std::size_t>(code - 0xc0)];
  if (base != ' ') return base;
  return code < 0xdf && code != 0xd7 ? code + 32 : code;  // letters without a base: only lower case
}

bool is_space(std::int32_t code) {
  return code == ' ' || code == '\t' || code == '\n' || code == '\r' || code == 0xa0 || code == 0x3000;
}

bool is_punctuation(std::int32_t code) {
  return (code >= 33 && code <= 47) || (code >= 58 && code <= 64) || (code >= 91 && code <= 96) ||
         (code >= 123 && code <= 126) || (code >= 0x2010 && code <= 0x2027) ||
         (code >= 0x3001 && code <= 0x3003) || code == 0xa1 || code == 0xab || code == 0xbb || code == 0xbf;
}

bool is_chinese(std::int32_t code) {
  return (code >= 0x4e00 && code <= 0x9fff) || (code >= 0x3400 && code <= 0x4dbf) ||
         (code >= 0xf900 && code <= 0xfaff);
}

}  // namespace

Expected<WordPiece> WordPiece::parse(std::string_view vocabulary, const std::string& name) {
  WordPiece result;
  std::size_t begin = 0;
  int number = 0;
  while (begin < vocabulary.size()) {
    const std::size_t end = std::min(vocabulary.find('\n', begin), vocabulary.size());
    std::string_view line = vocabulary.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    result.pieces_.emplace(line, number++);
    if (result.pieces_.size() > kMaxVocabulary)
      return fail(Outcome::kInvalidRequest, name + " holds more than a million pieces");
    begin = end + 1;
  }
  for (const auto& [piece, id] : {std::pair<const char*, int*>{"[UNK]", &result.unknown_},
                                  {"[CLS]", &result.begin_},
                                  {"[SEP]", &result.end_}}) {
    const auto found = result.pieces_.find(piece);
    if (found == result.pieces_.end())
      return fail(Outcome::kInvalidRequest, name + " is no WordPiece vocabulary: it lacks " + piece);
    *id = found->second;
  }
  return result;
}

Expected<WordPiece> WordPiece::load(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return fail(Outcome::kInvalidRequest, path.string() + " cannot be read");
  return parse(text.str(), path.string());
}

void WordPiece::add_word(const std::string& word, std::vector<int>& ids) const {
  if (word.empty()) return;
  std::size_t characters = 0;
  for (const char c : word) characters += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  std::vector<int> pieces;
  for (std::size_t begin = 0; begin < word.size() && characters <= kLongestWord;) {
    std::size_t end = word.size();
    for (; end > begin; --end) {
      if (end < word.size() && (static_cast<unsigned char>(word[end]) & 0xc0) == 0x80)
        continue;  // inside a character
      const auto found = pieces_.find((begin > 0 ? "##" : "") + word.substr(begin, end - begin));
      if (found == pieces_.end()) continue;
      pieces.push_back(found->second);
      break;
    }
    if (end == begin) {
      pieces.clear();
      break;
    }
    begin = end;
  }
  if (pieces.empty()) pieces.push_back(unknown_);
  ids.insert(ids.end(), pieces.begin(), pieces.end());
}

std::vector<int> WordPiece::encode(std::string_view text, std::size_t most) const {
  std::vector<int> ids = {begin_};
  std::string word;
  const auto finish = [&] {
    add_word(word, ids);
    word.clear();
  };
  for (std::size_t at = 0; at < text.size() && ids.size() < most;) {
    const std::int32_t code = next_code(text, at);
    if (code < 0 || code == 0xfffd || (code < 32 && !is_space(code)) || code == 127) continue;
    if (is_space(code)) {
      finish();
    } else if (is_punctuation(code) || is_chinese(code)) {
      finish();
      append(word, code);
      finish();
    } else {
      append(word, plain(code));
    }
  }
  finish();
  if (ids.size() > most - 1) ids.resize(most - 1);
  ids.push_back(end_);
  return ids;
}

}  // namespace goalnet::inference
