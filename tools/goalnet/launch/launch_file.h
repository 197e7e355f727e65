// The file that `goalnet launch` reads: which processes, with what arguments, and when to start them again.
//
//   arguments: {scene: kitchen}              # defaults; name:=value on the command line wins; ${scene} below
//   namespace: /robot1                       # of all components
//   use_sim_time: true                       # for all components but the simulator
//   environment: {GOALNET_ROS_DISTRO: jazzy} # an empty value leaves the variable as it is
//   restart: {when: on_failure, delay: 0.5, longest_delay: 8, limit: 5, window: 60, silent_after: 20}
//   patience: 3                              # [s] between SIGTERM and SIGKILL at the end
//   processes:                               # started in this order, stopped in the opposite one
//     simulator: {component: simulator, parameters: {scene: "${scene}"}}
//     planner: {component: planner, params_file: planner.yaml, remap: {/plan: /my_plan}}
//     watcher: {command: [ros2, topic, echo, /plan], restart: never, required: false}
#pragma once

#include <map>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "tools/goalnet/launch/restart_policy.h"

namespace goalnet::tools {

struct LaunchedProcess {
  std::string name;
  std::string node;  // full name of the ROS 2 node it is; "" for other commands
  std::vector<std::string> command;  // the first word is a path that can be executed
  std::map<std::string, std::string> environment;
  RestartParams restart;
  bool required = true;  // when it is given up, all ends
};

struct LaunchPlan {
  std::vector<LaunchedProcess> processes;
  double patience = 3.0;  // [s]
};

// What a plan needs to know of its surroundings; tests bring their own.
struct LaunchSurroundings {
  std::string goalnet;                  // path of the program that runs components
  std::vector<std::string> components;  // their names
  std::string search_path;              // as $PATH
};

// `given` are arguments of the command line. kInvalidRequest, naming file, line and what to do.
Expected<LaunchPlan> read_launch_file(const std::string& path,
                                      const std::map<std::string, std::string>& given,
                                      const LaunchSurroundings& surroundings);

// The same from text; `origin` stands for the file in messages, relative files are looked for in `folder`.
Expected<LaunchPlan> parse_launch(const std::string& text, const std::string& origin,
                                  const std::string& folder, const std::map<std::string, std::string>& given,
                                  const LaunchSurroundings& surroundings);

}  // namespace goalnet::tools
