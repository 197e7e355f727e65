#include "components/goalnet/goal_model.h"

#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {

Expected<Goal> GoalModel::infer(const StepInput& input) {
  if (input.states.empty())
    return fail(Outcome::kInvalidRequest, "no world state is known yet; wait for /world_state");
  if (input.sentence.size() > kMaxSentenceBytes)
    return fail(Outcome::kInvalidRequest, "the instruction has " + std::to_string(input.sentence.size()) +
                                              " bytes; at most " + std::to_string(kMaxSentenceBytes) +
                                              " are read");
  if (input.goals.size() >= input.states.size() + 1)
    return fail(Outcome::kInvalidRequest, "more goals than states before the present one");
  return do_infer(input);
}

}  // namespace goalnet::inference
