// What the coordinator may be told to do differently. Times are in seconds of the coordinator's clock:
// simulated time in simulation, so that a slow machine changes nothing.
#pragma once

#include <cstdint>

namespace goalnet::coordinator {

// What happens to an instruction that arrives while another runs.
enum class WhenBusy { kRefuse, kQueue };

struct CoordinatorParams {
  std::uint32_t max_steps = 30;  // inferences per instruction, unless the instruction says less
  WhenBusy when_busy = WhenBusy::kRefuse;
  std::uint32_t queue_length = 8;  // with kQueue: more than this many waiting are refused
  double resend_period = 1.0;      // a request nobody reacted to is sent again this often (late starters)
  double first_world_timeout =
      10.0;                    // until the first world state: longer than the others, things may be starting
  double world_timeout = 2.0;  // older than this, the world state is stale (it comes at 10 Hz)
  double inference_timeout = 10.0;        // goalnet is lost
  double planning_timeout = 20.0;         // the planner is lost
  double action_silence_timeout = 15.0;   // manipulation is lost; above its longest motion planning
  double action_timeout = 180.0;          // one action takes too long
  double instruction_timeout = 1800.0;    // one instruction takes too long
  double cancel_timeout = 5.0;            // until manipulation confirms that the robot stands still
  double standstill_timeout = 10.0;       // real seconds for which simulated time may stand still
  double effect_timeout = 6.0;            // until the world shows what an action did; filling a mug takes 2 s
  std::uint32_t max_replans = 10;         // per step
  std::uint32_t max_action_failures = 3;  // of the same action in one step
};

}  // namespace goalnet::coordinator
