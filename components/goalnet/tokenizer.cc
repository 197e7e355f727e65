#include "components/goalnet/tokenizer.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace goalnet::inference {
namespace {

bool is_word_byte(unsigned char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_digit(unsigned char c) { return c >= '0' && c <= '9'; }

// Length of the valid UTF-8 sequence at `at`, or 0. Overlong forms, surrogates and values past U+10FFFF are
// invalid.
std::size_t utf8_length(std::string_view text, std::size_t at, std::uint32_t* code) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  std::size_t length = lead < 0x80 ? 1 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if ((lead >= 0x80 && lead < 0xc2) || lead > 0xf4 || at + length > text.size()) return 0;
  std::uint32_t value = length == 1 ? lead : lead & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
    value = (value << 6) | (byte(at + i) & 0x3fu);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (value < kSmallest[length] || (value >= 0xd800 && value < 0xe000) || value > 0x10ffff) return 0;
  *code = value;
  return length;
}

bool is_separator(std::uint32_t code) {
  return (code >= 0x2000 && code <= 0x206f) || code == 0xa0 || (code >= 0x3000 && code <= 0x3002) ||
         code == 0xfeff || (code >= 0x2190 && code <= 0x2bff) || (code >= 0x1f000 && code <= 0x1faff) ||
         (code >= 0xfe00 && code <= 0xfe0f) || code == 0xd7 ||
         code == 0xf7;  // arrows, pictures, multiplication
}

// Letters of Western Europe without their accents ("café"); 0 for others.
char plain_letter(std::uint32_t code) {
  constexpr std::string_view kLetters = "aaaaaaaceeeeiiiidnoooooxouuuuypy";
  if (code < 0xc0 || code > 0xff || code == 0xdf) return '\0';
  return kLetters[(code - 0xc0) % 32];
}

}  // namespace

Expected<std::vector<std::string>> tokenize(std::string_view sentence, Endings endings) {
  if (sentence.size() > kMaxSentenceBytes)
    return fail(Outcome::kInvalidRequest, "the instruction has " + std::to_string(sentence.size()) +
                                              " bytes; at most " + std::to_string(kMaxSentenceBytes) +
                                              " are read");
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty()) words.push_back(std::move(word));
    word.clear();
  };
  for (std::size_t i = 0; i < sentence.size();) {
    std::uint32_t code = 0;
    const std::size_t length = utf8_length(sentence, i, &code);
    if (length == 0)
      return fail(Outcome::kInvalidRequest,
                  "the instruction is not valid UTF-8 at byte " + std::to_string(i));
    const char c = length == 1 ? sentence[i] : '\0';
    const char next = i + 1 < sentence.size() ? sentence[i + 1] : '\0';
    if (code < 0x20 && c != '\t' && c != '\n' && c != '\r')
      return fail(Outcome::kInvalidRequest,
                  "the instruction holds a control character at byte " + std::to_string(i));
    const bool apostrophe = c == '\'' || code == 0x2019;
    if (apostrophe && !word.empty()) {
      // "cd's" -> "cd"; "don't" -> "dont"
      const std::size_t after = i + length;
      const bool possessive =
          after < sentence.size() && (sentence[after] | 0x20) == 's' &&
          (after + 1 == sentence.size() || !is_word_byte(static_cast<unsigned char>(sentence[after + 1])));
      if (possessive) {
        // "it's" is "it is", "let's" "let us"; elsewhere the ending only says whose
        static constexpr std::array<std::string_view, 10> kIs = {"it",  "that", "there", "what", "where",
                                                                 "who", "here", "how",   "he",   "she"};
        const std::string before = word;
        finish();
        if (std::find(kIs.begin(), kIs.end(), before) != kIs.end())
          words.emplace_back("is");
        else if (endings == Endings::kKept && before != "let")
          words.emplace_back("'s");
        if (before == "let") words.emplace_back("us");
        i = after + 1;
        continue;
      }
    } else if (length == 1 && is_word_byte(static_cast<unsigned char>(c))) {
      word.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c);
    } else if (c == '/' && !word.empty() && is_digit(static_cast<unsigned char>(word.back())) &&
               is_digit(static_cast<unsigned char>(next))) {
      word.push_back(c);
    } else if (plain_letter(code) != '\0') {
      word.push_back(plain_letter(code));
    } else if (length > 1 && !is_separator(code)) {
      word.append(sentence.substr(i, length));
    } else {
      finish();
      const bool blank_before = i == 0 || sentence[i - 1] == ' ';
      if (c == '-' && next == '>') {  // "books -> shelf"
        words.emplace_back("to");
      } else if ((c == '-' && blank_before && next == ' ') || code == 0x2013 || code == 0x2014) {
        words.emplace_back(",");  // a dash parts clauses
      } else if (c == '.' || c == ';' || c == '!' || c == '?') {
        if (words.empty() || words.back() != ".") words.emplace_back(".");
      } else if (c == ',' || c == ':') {
        const bool heading =
            endings == Endings::kKept && c == ':' && !is_digit(static_cast<unsigned char>(next));
        words.emplace_back(heading ? ":" : ",");
      } else if (c == '&' || c == '+') {
        words.emplace_back("and");
      }
    }
    if (words.size() > kMaxWords)
      return fail(Outcome::kInvalidRequest,
                  "the instruction has more than " + std::to_string(kMaxWords) + " words");
    i += length;
  }
  finish();
  return words;
}

}  // namespace goalnet::inference
