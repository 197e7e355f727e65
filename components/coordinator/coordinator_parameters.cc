#include "components/coordinator/coordinator_parameters.h"

#include "components/core/config_path.h"

namespace goalnet::coordinator {
namespace {

// Declares parameters until the first that makes no sense.
class Declarer {
 public:
  explicit Declarer(ros::Node& node) : node_(node) {}

  void seconds(const char* name, double& value, const char* description) {
    declare(name, value,
            {.description = std::string(description) + " [s]",
             .read_only = true,
             .range = ros::ParameterRange{0.01, 1e6, 0.0},
             .additional_constraints = ""});
  }
  void count(const char* name, std::uint32_t& value, double most, const char* description) {
    declare(name, value,
            {.description = description,
             .read_only = true,
             .range = ros::ParameterRange{0.0, most, 1.0},
             .additional_constraints = ""});
  }
  template <class T>
  void declare(const char* name, T& value, const ros::ParameterDescriptor& descriptor) {
    if (error_) return;
    const auto declared = node_.declare_parameter<T>(name, value, descriptor);
    if (declared) {
      value = *declared;
    } else {
      error_ = declared.error();
    }
  }
  const std::optional<Error>& error() const { return error_; }

 private:
  ros::Node& node_;
  std::optional<Error> error_;
};

}  // namespace

Expected<NodeParams> declare_parameters(ros::Node& node) {
  NodeParams params;
  CoordinatorParams& core = params.core;
  Declarer declare(node);
  declare.count("max_steps", core.max_steps, 1000, "Inference steps per instruction before giving up");
  declare.count("queue_length", core.queue_length, 1000, "Instructions that may wait with when_busy = queue");
  declare.count("max_replans", core.max_replans, 1000, "New plans per step before giving up");
  declare.count("max_action_failures", core.max_action_failures, 1000,
                "Failures of one action per step before giving up");
  declare.seconds("resend_period", core.resend_period,
                  "A request nobody reacted to is sent again this often");
  declare.seconds("first_world_timeout", core.first_world_timeout,
                  "Until the first world state must be there");
  declare.seconds("world_timeout", core.world_timeout, "Older than this, the world state is stale");
  declare.seconds("inference_timeout", core.inference_timeout, "Until goalnet must have answered");
  declare.seconds("planning_timeout", core.planning_timeout, "Until the planner must have answered");
  declare.seconds("action_silence_timeout", core.action_silence_timeout,
                  "Longest silence of manipulation in an action");
  declare.seconds("action_timeout", core.action_timeout, "Longest time for one action");
  declare.seconds("instruction_timeout", core.instruction_timeout, "Longest time for one instruction");
  declare.seconds("cancel_timeout", core.cancel_timeout, "Until manipulation must have stopped the robot");
  declare.seconds("effect_timeout", core.effect_timeout, "Until the world must show what an action did");
  std::string when_busy = "refuse";
  declare.declare("when_busy", when_busy,
                  {.description = "What happens to an instruction that comes while another runs",
                   .read_only = true,
                   .range = {},
                   .additional_constraints = "refuse or queue"});
  params.domain = config_path("domains/household.pddl");
  declare.declare("domain", params.domain,
                  {.description = "PDDL domain that says what actions need and do",
                   .read_only = true,
                   .range = {},
                   .additional_constraints = "a file"});
  if (declare.error()) return tl::unexpected<Error>(*declare.error());
  if (when_busy != "refuse" && when_busy != "queue") {
    return fail(Outcome::kInvalidRequest,
                "parameter when_busy is \"" + when_busy + "\"; it must be refuse or queue");
  }
  core.when_busy = when_busy == "queue" ? WhenBusy::kQueue : WhenBusy::kRefuse;
  return params;
}

}  // namespace goalnet::coordinator
