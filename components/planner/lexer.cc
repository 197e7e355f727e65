#include "components/planner/lexer.h"

#include <algorithm>
#include <array>

namespace goalnet::planner {
namespace {

enum : unsigned char { kOther = 0, kSpace = 1, kWordCharacter = 2, kParenthesis = 3, kComment = 4 };

constexpr std::array<unsigned char, 256> classes() {
  std::array<unsigned char, 256> table{};
  for (const char c : {' ', '\t', '\n', '\r', '\f', '\v'}) table[static_cast<unsigned char>(c)] = kSpace;
  for (char c = 'a'; c <= 'z'; ++c) table[static_cast<unsigned char>(c)] = kWordCharacter;
  for (char c = 'A'; c <= 'Z'; ++c) table[static_cast<unsigned char>(c)] = kWordCharacter;
  for (char c = '0'; c <= '9'; ++c) table[static_cast<unsigned char>(c)] = kWordCharacter;
  for (const char c :
       {'-', '_', '?', ':', '=', '.', '@', '+', '*', '/', '<', '>', '#', '!', '&', '%', '$', '\''}) {
    table[static_cast<unsigned char>(c)] = kWordCharacter;
  }
  table['('] = table[')'] = kParenthesis;
  table[';'] = kComment;
  return table;
}
constexpr auto kClasses = classes();

unsigned char class_of(char c) { return kClasses[static_cast<unsigned char>(c)]; }

}  // namespace

template <class Inside>
void Lexer::skip(const Inside& inside) {
  constexpr std::size_t kPiece = 1u << 16;  // one comment may be as long as the text
  while (!stopped_) {
    const std::size_t end = std::min(at_ + kPiece, text_.size());
    while (at_ < end && inside(text_[at_])) ++at_;
    if (at_ < end || end == text_.size()) return;
    stopped_ = stop_.stop_requested();
  }
  at_ = text_.size();
}

void Lexer::advance() {
  while (at_ < text_.size()) {
    const unsigned char kind = class_of(text_[at_]);
    if (kind == kSpace) {
      skip([](char c) { return class_of(c) == kSpace; });
    } else if (kind == kComment) {
      skip([](char c) { return c != '\n'; });
    } else {
      break;
    }
  }
  const std::size_t start = at_;
  if (at_ == text_.size()) {
    token_ = {Token::Kind::kEnd, {}, start};
    return;
  }
  switch (class_of(text_[at_])) {
    case kParenthesis:
      token_ = {text_[at_] == '(' ? Token::Kind::kOpen : Token::Kind::kClose, text_.substr(start, 1), start};
      ++at_;
      return;
    case kWordCharacter:
      skip([](char c) { return class_of(c) == kWordCharacter; });
      token_ = {Token::Kind::kWord, text_.substr(start, at_ - start), start};
      return;
    default:
      token_ = {Token::Kind::kBad, text_.substr(start, 1), start};
      at_ = text_.size();
  }
}

std::string Lexer::position(std::size_t offset) const {
  const std::string_view before = text_.substr(0, std::min(offset, text_.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
  return std::to_string(line) + ":" + std::to_string(column);
}

}  // namespace goalnet::planner
