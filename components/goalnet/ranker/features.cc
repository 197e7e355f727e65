#include "components/goalnet/ranker/features.h"

#include <algorithm>

namespace goalnet::inference {

using namespace symbol;

void FeatureContext::extract_stop(std::vector<std::uint32_t>& out) const {
  Appender add(out, instruction_);
  const std::uint32_t last = verb_code(last_), before = verb_code(before_last_);
  ObjectCode other_x, other_y;
  const ObjectCode &x = code(uses_device(last_.verb) ? device_of(last_.x) : last_.x, other_x),
                   &y = code(last_.y, other_y);
  const std::uint32_t vote_stop = vote_code(stop_vote());
  add(1000);
  add(1001, step_);
  add(1002, last);
  add(1003, last, before);
  add(1004, last, x.mention);
  add(1005, last, y.mention);
  add(1006, last, x.mention, y.mention);
  add(1007, named_, named_handled_);
  add(1008, last, named_, named_handled_);
  add(1009, held_, held_named_);
  add(1010, last, held_, held_named_);
  add(1011, last, x.class_code);
  add(1012, last, x.class_code, y.class_code);
  add(1013, last, instruction_.first_verb);
  add(1014, last, instruction_.first_verb, named_handled_);
  add(1015, few(static_cast<int>(instruction_.words.size()) / 3, 8), step_);
  add(1016, vote_stop);
  add(1017, vote_stop, last);
  add(1018, instruction_.first_verb, step_);
  add(1030, read_);
  add(1031, read_, last);
  add(1032, read_, step_);
  add(1033, instruction_.first_frame, step_);
  add(1034, instruction_.first_frame, last);
  add(1035, instruction_.first_frame, last, named_, named_handled_);
  add(1036, last, switch_code(last_, run_.now));
  add(1037, last, x.turn, y.turn);
  add(1038, last, x.contents);
  add(1039, world_);
  const std::uint32_t next = vote_code(next_by_words_.stop()), here = vote_code(next_by_room_.stop());
  add(1050, next);
  add(1051, next, step_);
  add(1052, here);
  add(1053, here, next);
  add(1054, next, vote_stop);
  add(1055, next, read_);
  add(1056, next, last);
  for (const std::uint32_t word : instruction_.unigrams) {
    add(1020, word);
    add(1021, word, last);
    add(1022, word, step_);
    add(1023, word, last, x.class_code);
  }
  for (const std::uint32_t pair : instruction_.bigrams) {
    add(1024, pair);
    add(1025, pair, last);
  }
}

// What does not change during a run: the words, the classes, the names.
void FeatureContext::extract_fixed(const SymAction& action, const ActionHints& hints,
                                   std::vector<std::uint32_t>& out) const {
  if (action.verb == Verb::kStop) return;
  Appender add(out, instruction_);
  const std::uint32_t v = verb_code(action), verb_only = static_cast<std::uint32_t>(action.verb);
  const std::uint32_t w0 = instruction_.first_verb, frame = instruction_.first_frame;
  ObjectCode other_x, other_y;
  const ObjectCode &x = code(uses_device(action.verb) ? device_of(action.x) : action.x, other_x),
                   &y = code(action.y, other_y);
  const std::uint32_t votes = hints.votes, habits = hints.habits;
  add(105, v, x.clause, x.mention);
  add(106, v, x.clause, x.class_code);
  add(107, v, frame, x.mention, y.mention);
  add(1, v);
  add(2, v, x.mention);
  add(4, v, x.mention, y.mention);
  add(5, v, x.class_code);
  add(8, v, x.class_code, x.mention);
  add(15, v, x.rank, x.class_code);
  add(16, v, x.rank, x.mention);
  add(30, v, w0, x.mention, y.mention);
  add(33, v, w0, x.class_code, y.class_code);
  add(34, v, x.before, x.mention);
  add(35, v, votes);
  add(36, v, votes, x.mention);
  add(37, votes);
  add(150, habits);
  add(151, v, habits);
  add(152, habits, votes);
  add(153, v, habits, x.mention);
  add(42, verb_only, x.name);  // habits about single things: the first burner, the left pillow
  if (action.y != kNone) {
    add(140, v, y.clause, y.mention);
    add(141, v, y.clause, y.class_code);
    add(147, v, x.clause, y.clause, x.mention, y.mention);
    add(50, v, y.mention);
    add(51, v, y.class_code);
    add(52, v, x.class_code, y.class_code);
    add(53, v, y.class_code, y.mention);
    add(55, v, y.before, y.mention);
    add(56, v, x.before, y.before);
    add(57, v, y.name);
    add(59, v, y.rank, y.mention);
    if (x.mention_index >= 0 && y.mention_index >= 0)
      add(61, v, x.mention_index < y.mention_index ? 1 : 2, x.mention, y.mention);
  }
  for (const std::uint32_t word : instruction_.unigrams) {
    add(70, v, word);
    add(71, word, x.class_code);
    add(73, v, word, x.mention);
    if (action.y != kNone) {
      add(75, word, y.class_code);
      add(77, v, word, y.mention);
    }
  }
  for (const std::uint32_t pair : instruction_.bigrams) {
    add(80, v, pair);
  }
}

// What depends on the moment: what was done, where things are.
void FeatureContext::extract_moment(const SymAction& action, const ActionHints& hints,
                                    EarlierFeatures& earlier, std::vector<std::uint32_t>& out) const {
  if (action.verb == Verb::kStop) return extract_stop(out);
  const std::uint32_t v = verb_code(action), last = verb_code(last_), before = verb_code(before_last_);
  const std::uint32_t verb_only = static_cast<std::uint32_t>(action.verb);
  ObjectCode other_x, other_y;
  const ObjectCode &x = code(uses_device(action.verb) ? device_of(action.x) : action.x, other_x),
                   &y = code(action.y, other_y);
  const std::uint32_t w0 = instruction_.first_verb, frame = instruction_.first_frame;
  const std::uint32_t same =
      (last_.x == action.x ? 1u : 0u) + (last_.y == action.y && action.y != kNone ? 2u : 0u) +
      (last_.x == action.y && action.y != kNone ? 4u : 0u) + (last_.y == action.x ? 8u : 0u);
  const std::uint32_t votes = hints.votes, habits = hints.habits, on = switch_code(action, run_.now);
  const std::uint32_t read = reading_code(action, x, y), again = repeats(action, x.class_code);
  Appender add(out, instruction_, earlier, {x.changing << 5 | again << 2 | on, y.changing});
  add.append(small_feature<100, kReadingCodes>(read));
  add(101, v, read);
  add.append(small_feature<102, kReadingCodes, kSteps>(read, step_));
  add.append(small_feature<103, kReadingCodes, kVoteCodes>(read, votes));
  add(156, habits, x.state, step_);
  add(157, v, habits, last);
  const std::uint32_t next = vote_code(next_by_words_.share(hints.by_class)),
                      here = vote_code(next_by_room_.share(hints.by_object));
  add.append(small_feature<160, kVoteCodes>(next));
  add(161, v, next);
  add(162, next, x.mention);
  add.append(small_feature<163, kVoteCodes, kVoteCodes>(next, votes));
  add.append(small_feature<164, kVoteCodes>(here));
  add(165, v, here);
  add.append(small_feature<166, kVoteCodes, kVoteCodes>(here, next));
  add.append(small_feature<167, kVoteCodes, kVoteCodes>(here, habits));
  add.append(small_feature<168, kVoteCodes, kReadingCodes>(next, read));
  add.append(small_feature<169, kVoteCodes, kSteps>(next, step_));
  add(104, read, frame);
  add.steady([&] { add(108, v, frame, x.state); });
  add(109, v, frame, last, x.state);
  add.steady([&] {
    add(110, v, x.last_use);
    add(111, v, x.last_use, x.mention);
    add(112, v, x.last_place);
    add(113, v, again);
    add(114, v, again, x.mention);
    add(115, v, x.turn);
    add(116, v, x.turn, x.mention);
    add(117, v, x.turn, x.clause);
    add(118, v, x.contents);
    add(119, v, x.contents, frame);
  });
  add(120, v, world_);
  add.steady([&] {
    add(121, v, x.place_named, x.mention);
    add(122, v, x.clause, x.state);
  });
  add(123, v, x.class_code, x.last_use, last);
  add.steady([&] {
    add(10, v, x.state);
    add(11, v, x.state, x.mention);
    add(12, v, x.place);
    add(13, v, x.place, x.mention);
  });
  add(20, v, last);
  add(21, v, last, before);
  add(22, v, last, same);
  add(23, v, last, same, x.mention, y.mention);
  add(24, v, x.class_code, last, class_code(last_.x));
  add(25, v, step_);
  add(26, v, step_, x.mention, y.mention);
  add(27, v, named_, named_handled_);
  add(28, v, held_, held_named_, x.state);
  add(29, v, x.class_code, same, last);
  add.steady([&] { add(31, v, w0, x.state); });
  add(32, v, w0, last, x.state);
  add(38, votes, step_, x.state);
  add(39, v, votes, last);
  add(40, verb_only, x.mention, x.state, step_);
  add.steady([&] { add(41, v, x.state, x.class_code); });
  if (on != 0) {
    add.steady([&] {
      add(130, v, on);
      add(131, v, on, frame);
    });
    add(132, v, on, last);
    add(133, v, on, read);
    add.steady([&] {
      add(134, v, on, again);
      for (const std::uint32_t word : instruction_.unigrams) add(135, v, on, word);
      for (const std::uint32_t pair : instruction_.bigrams) add(136, v, on, pair);
    });
  }
  if (action.y != kNone) {
    add.steady([&] {
      add(142, v, y.turn, x.turn);
      add(143, v, y.last_place);
    });
    add(144, v, y.last_place, last_.y == action.y ? 1 : 0);
    add.steady([&] {
      add(145, v, y.last_use);
      add(146, v, y.contents, x.contents);
      add(54, v, y.state);
      add(58, v, x.place, y.class_code);
      add(60, v, x.state, y.state);
    });
  }
  add.steady([&] {
    for (const std::uint32_t word : instruction_.unigrams) add(74, v, word, x.state);
  });
}

}  // namespace goalnet::inference
