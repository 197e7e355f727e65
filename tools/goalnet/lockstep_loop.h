// All components in one process and one thread, over DDS, with the simulator as the clock: simulated time
// stands still while components compute and moves on when nothing is left to be delivered. The same seed
// gives the same run.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "components/coordinator/port.h"
#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/ros/arguments.h"

namespace goalnet::sim {
class World;
}
namespace goalnet::ros {
class ManagedComponent;
}

namespace goalnet::tools {

struct LoopOptions {
  std::string scene = "kitchen";  // name or file
  std::string robot;              // file; empty: the default robot
  std::string model;              // file; empty: the shipped model
  std::uint64_t seed = 1;
  std::uint32_t max_steps = 0;       // 0: the coordinator's default
  double instruction_timeout = 0.0;  // [s] simulated; 0: the coordinator's default
  bool console = false;              // components log to standard error, too (always to /rosout)
  bool process_only = false;         // invisible to other processes
  std::string record;  // directory of a bag to record everything into, in simulated time; empty: none
  std::string record_storage = "mcap";  // or sqlite3
  ros::Arguments arguments;             // given by a person; win over all of the above
};

// What is seen on the topics, in order of arrival. Called between simulation steps.
struct LoopEvents {
  std::function<void(const coordinator::Report&)> on_status;
  std::function<void(const std::string& stage, double progress)> on_stage;  // of the running action
  std::function<void(const WorldState&)> on_world;
  // Whether the person has lost interest: create() and settle() then end with kCancelled. May be empty.
  std::function<bool()> stop_asked;
};

class LockstepLoop {
 public:
  // Errors: kInvalidRequest with the component's message (unknown scene, broken model file, bad parameter …);
  // kBusy where the domain has a robot of the same names already; kCancelled.
  static Expected<std::unique_ptr<LockstepLoop>> create(const LoopOptions& options, LoopEvents events);
  ~LockstepLoop();

  // Lets things come to rest and the world be seen. kWorldStale if it is not within `limit` simulated
  // seconds; kBusy as create(); kCancelled.
  Expected<void> settle(double at_least = 0.5, double limit = 10.0);

  // As anyone could through DDS; read the outcome from on_status.
  void instruct(const std::string& instruction);
  void pursue(const Goal& goal);
  void cancel(const std::string& reason);

  // Delivers everything, then moves simulated time on by one tick (10 ms).
  void step();

  // Writes a picture (PNG) of the room as it is now; takes about a second.
  Expected<void> picture(const std::string& path) const;

  // Completes the bag, if one is recorded, after a few more steps; nothing more goes into it then. Returns
  // what went wrong, if anything did.
  Expected<void> finish_recording();

  // [s] since the simulation began.
  double sim_time() const;

  // The physics behind the topics, for faults and tests; change it between steps only.
  sim::World& world();

  // One of the components, to change its lifecycle state between steps. Throws std::out_of_range for a name
  // that component_registry.h does not have.
  ros::ManagedComponent& component(std::string_view name);

  // Ends a long computation inside step(); from any thread.
  void interrupt();

 private:
  struct Impl;
  explicit LockstepLoop(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace goalnet::tools
