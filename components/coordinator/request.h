// Checks of what people and programs send, before anything moves.
#pragma once

#include <cstddef>
#include <string_view>

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::coordinator {

constexpr std::size_t kMaxInstructionBytes = 4096;
constexpr std::size_t kMaxGoalPredicates = 256;

// Whether `text` is well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates, at most U+10FFFF).
bool is_utf8(std::string_view text);

// kInvalidRequest for an empty or blank instruction, one above kMaxInstructionBytes, or text that is not
// UTF-8 or has control characters other than tab and line ends.
Expected<void> check_instruction(std::string_view text);

// kInvalidRequest for an empty goal, more than kMaxGoalPredicates predicates, malformed predicates, or a
// predicate that is asked for and excluded at once.
Expected<void> check_goal(const Goal& goal);

}  // namespace goalnet::coordinator
