#include "components/coordinator/request.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace goalnet::coordinator {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

// Bytes of the well-formed character at the start of `text`, or 0.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return 0;
  }
  const auto second = static_cast<unsigned char>(text[1]);
  if (first == 0xE0 && second < 0xA0) return 0;  // overlong
  if (first == 0xED && second > 0x9F) return 0;  // surrogate
  if (first == 0xF0 && second < 0x90) return 0;  // overlong
  if (first == 0xF4 && second > 0x8F) return 0;  // above U+10FFFF
  return length;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && !is_blank(c)) || byte == 0x7F;
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

Expected<void> check_instruction(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_blank)) {
    return fail(Outcome::kInvalidRequest,
                "the instruction is empty; say what to do, for example \"open the microwave\"");
  }
  if (text.size() > kMaxInstructionBytes) {
    return fail(Outcome::kInvalidRequest, "the instruction has " + std::to_string(text.size()) +
                                              " bytes; at most " + std::to_string(kMaxInstructionBytes) +
                                              " are taken");
  }
  if (!is_utf8(text)) return fail(Outcome::kInvalidRequest, "the instruction is not valid UTF-8 text");
  if (std::any_of(text.begin(), text.end(), is_control)) {
    return fail(Outcome::kInvalidRequest, "the instruction has control characters; send plain text");
  }
  return {};
}

Expected<void> check_goal(const Goal& goal) {
  if (goal.empty()) {
    return fail(Outcome::kInvalidRequest,
                "the goal is empty; give at least one predicate such as (On Mug_1 Sink)");
  }
  const std::size_t count = goal.positive.size() + goal.negative.size();
  if (count > kMaxGoalPredicates) {
    return fail(Outcome::kInvalidRequest, "the goal has " + std::to_string(count) + " predicates; at most " +
                                              std::to_string(kMaxGoalPredicates) + " are taken");
  }
  for (const auto* list : {&goal.positive, &goal.negative}) {
    for (const Predicate& predicate : *list) {
      if (const auto parsed = parse_predicate(to_string(predicate)); !parsed || *parsed != predicate) {
        return fail(Outcome::kInvalidRequest,
                    parsed ? "the goal has a malformed predicate" : "the goal: " + parsed.error().message);
      }
    }
  }
  for (const Predicate& predicate : goal.positive) {
    if (std::find(goal.negative.begin(), goal.negative.end(), predicate) != goal.negative.end()) {
      return fail(Outcome::kInvalidRequest,
                  "the goal asks for " + to_string(predicate) + " and excludes it at once");
    }
  }
  return {};
}

}  // namespace goalnet::coordinator
