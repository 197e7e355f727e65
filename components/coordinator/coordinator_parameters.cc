#include "components/coordinator/coordinator_parameters.h"

#include "components/coordinator/coordinator_node.h"

namespace goalnet::coordinator {

void CoordinatorNode::describe(ros::ParameterSet& set, Params& params) {
  CoordinatorParams& core = params.core;
  const auto seconds = [&set](const char* name, double& value, const std::string& description) {
    set.number(name, value, description + " [s]", 0.01, 1e6);
  };
  set.text("domain", params.domain, "PDDL domain that says what actions need and do",
           "a name in config/domains or a file");
  set.choice("when_busy", params.when_busy, "what happens to an instruction that comes while another runs",
             {"refuse", "queue"});
  set.whole("queue_length", core.queue_length, "instructions that may wait with when_busy = queue", 0, 1000);
  set.whole("max_steps", core.max_steps, "inference steps per instruction before giving up", 1, 1000);
  set.whole("max_replans", core.max_replans, "new plans per step before giving up", 0, 1000);
  set.whole("max_action_failures", core.max_action_failures,
            "failures of one action per step before giving up", 1, 1000);
  seconds("resend_period", core.resend_period, "a request nobody reacted to is sent again this often");
  seconds("first_world_timeout", core.first_world_timeout, "until the first world state must be there");
  seconds("world_timeout", core.world_timeout, "older than this, the world state is stale");
  seconds("inference_timeout", core.inference_timeout, "until goalnet must have answered");
  seconds("planning_timeout", core.planning_timeout, "until the planner must have answered");
  seconds("action_silence_timeout", core.action_silence_timeout,
          "longest silence of manipulation in an action");
  seconds("action_timeout", core.action_timeout, "longest time for one action");
  seconds("instruction_timeout", core.instruction_timeout, "longest time for one instruction");
  seconds("cancel_timeout", core.cancel_timeout, "until manipulation must have stopped the robot");
  seconds("effect_timeout", core.effect_timeout, "until the world must show what an action did");
  seconds("standstill_timeout", core.standstill_timeout,
          "simulated time that stands still for so long in real time means that the simulator is gone");
  set.whole(
      "first_id", params.first_id,
      "number of the first instruction; 0: from the wall clock, so that numbers stay new after a restart", 0,
      1e15);
}

}  // namespace goalnet::coordinator
