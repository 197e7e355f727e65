// Cuts PDDL text into parentheses and words. Comments start with ';'.
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

namespace goalnet::planner {

struct Token {
  enum class Kind { kOpen, kClose, kWord, kEnd, kBad };
  Kind kind = Kind::kEnd;
  std::string_view text;   // the word; for kBad the offending character
  std::size_t offset = 0;  // into the text
};

class Lexer {
 public:
  // Ends soon after `stop` asks, as if the text ended there.
  Lexer(std::string_view text, std::stop_token stop) : text_(text), stop_(std::move(stop)) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // the mark that some editors put there
    advance();
  }

  const Token& peek() const { return token_; }
  Token next() {
    const Token result = token_;
    advance();
    return result;
  }

  // "12:7" (line and column, both from 1) of an offset.
  std::string position(std::size_t offset) const;

 private:
  void advance();
  // Passes the characters that are `inside`.
  template <class Inside>
  void skip(const Inside& inside);

  std::string_view text_;
  std::stop_token stop_;
  bool stopped_ = false;
  std::size_t at_ = 0;
  Token token_;
};

}  // namespace goalnet::planner
