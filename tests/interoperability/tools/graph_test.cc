// Every component as a process of its own, and what ROS 2 tools need of what they announce: seen by Cyclone
// DDS, judged by the rules that rmw_dds_common, rcl, ros2cli and rclpy go by (docs/design/070-ros2-tools.md).
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "idl/type_description.h"
#include "tests/interoperability/tools/seen_graph.h"
#include "tests/support/process.h"
#include "tests/support/slowdown.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing_support::Process;

const int kDomain = own_domain();
const std::vector<std::string> kComponents = {"/coordinator", "/executor",  "/goalnet",       "/manipulation",
                                              "/planner",     "/simulator", "/visualization", "/world_model"};

// goalnet launch asks its components for signs of life with a node of its own, as ros2 launch has one.
bool is_launcher(const std::string& name) { return name.starts_with("/goalnet_launch_"); }

std::vector<std::string> without_launcher(std::vector<std::string> names) {
  EXPECT_LE(std::erase_if(names, is_launcher), 1u);
  return names;
}

// One look at a launched robot, for all tests of a distribution.
class ToolsGraph : public testing::TestWithParam<const char*> {
 protected:
  static void SetUpTestSuite() {
    for (const char* distro : {"humble", "jazzy"}) {
      const std::string domain = std::to_string(kDomain);
      Process watcher({testing_support::program("cyclone_graph"), domain, "60", distro}, {});
      ASSERT_TRUE(watcher.wait_for_text("ready", 5s)) << watcher.err();
      Process robot(
          {testing_support::program("goalnet"), "launch", "robot", std::string("distro:=") + distro},
          {{"ROS_DOMAIN_ID", domain}});
      // Until all are active: an action server and markers are only there then; at most a minute.
      std::size_t before = 0;
      for (int i = 0, quiet = 0; i < 60 && quiet < 2; ++i) {
        std::this_thread::sleep_for(1s);
        graphs_[distro] = fullest_graph(watcher.out());
        const std::size_t now = graphs_[distro].endpoints.size();
        const bool all = without_launcher(graphs_[distro].node_names()) == kComponents;
        quiet = all && now == before ? quiet + 1 : 0;
        before = now;
      }
      testing_support::Slowdown slowdown;
      Process passer_by({testing_support::program("cyclone_graph"), domain, "3", distro, "50"}, {});
      glances_[distro] = seen_graphs(passer_by.wait(20s).out);
      slowdowns_[distro] = slowdown.stop();
      for (const std::string& node : kComponents) {
        Process tool({testing_support::program("cyclone_services"), "state", domain, node}, {});
        tool.wait(12s);
        // Replies to the launcher's own questions reach the tool too; idlc's types complain of their format.
        states_[distro] += node + " " + (tool.out().empty() ? tool.err() : tool.out());
      }
      robot.signal(SIGINT);
      robot.wait(15s);
    }
  }
  const SeenGraph& graph() const { return graphs_.at(GetParam()); }
  bool jazzy() const { return std::string(GetParam()) == "jazzy"; }
  // Endpoints that ROS 2 tools show: topics, requests and replies.
  std::vector<const GraphEndpoint*> ros_endpoints() const {
    std::vector<const GraphEndpoint*> found;
    for (const auto& [guid, one] : graph().endpoints) {
      const std::string prefix = one.topic.substr(0, 3);
      if (prefix == "rt/" || prefix == "rq/" || prefix == "rr/") found.push_back(&one);
    }
    return found;
  }
  // Names of the services that a node serves, as `ros2 node info` finds them.
  std::map<std::string, std::string> services_of(const SeenNode& node) const {
    std::map<std::string, std::string> services;
    for (const std::string& gid : node.readers) {
      const auto found = graph().endpoints.find(gid);
      if (found == graph().endpoints.end() || !found->second.topic.starts_with("rq/")) continue;
      const std::string& topic = found->second.topic;
      std::string type = idl::ros_type_name(found->second.type);
      type.erase(type.rfind("_Request"));
      services[topic.substr(2, topic.size() - 2 - std::string("Request").size())] = type;
    }
    return services;
  }

  static std::map<std::string, SeenGraph> graphs_;
  static std::map<std::string, std::vector<SeenGraph>> glances_;  // of a newcomer, in its first moments
  static std::map<std::string, double> slowdowns_;                // of the machine meanwhile
  static std::map<std::string, std::string> states_;
};
std::map<std::string, SeenGraph> ToolsGraph::graphs_;
std::map<std::string, std::vector<SeenGraph>> ToolsGraph::glances_;
std::map<std::string, double> ToolsGraph::slowdowns_;
std::map<std::string, std::string> ToolsGraph::states_;

// ros2 node list; the warning of nodes that share a name; participants without an enclave are not in the
// graph.
TEST_P(ToolsGraph, NodesAreListedOnceAndVisible) {
  EXPECT_EQ(without_launcher(graph().node_names()), kComponents);
  EXPECT_EQ(graph().nodes.size(), kComponents.size() + 1) << "one of them is the launcher's";
  for (const SeenNode& node : graph().nodes) {
    ASSERT_TRUE(graph().participants.contains(node.participant)) << node.full_name();
    const SeenParticipant& participant = graph().participants.at(node.participant);
    EXPECT_EQ(participant.name, "/");
    EXPECT_EQ(participant.user_data, std::string("enclave=/;") + '\0');
  }
}

// ros2 topic info -v, ros2 node info: an endpoint that no node claims is _NODE_NAME_UNKNOWN_.
TEST_P(ToolsGraph, EachEndpointBelongsToOneNodeOfItsParticipant) {
  std::map<std::string, std::vector<const SeenNode*>> owners;
  for (const SeenNode& node : graph().nodes) {
    for (const auto* gids : {&node.readers, &node.writers}) {
      for (const std::string& gid : *gids) {
        owners[gid].push_back(&node);
        const auto found = graph().endpoints.find(gid);
        ASSERT_NE(found, graph().endpoints.end()) << node.full_name() << " claims " << gid;
        EXPECT_EQ(found->second.is_writer, gids == &node.writers) << found->second.topic;
      }
    }
  }
  EXPECT_GT(ros_endpoints().size(), 200u);
  for (const GraphEndpoint* one : ros_endpoints()) {
    ASSERT_EQ(owners[one->guid].size(), 1u) << one->topic << " " << one->guid;
    EXPECT_EQ(owners[one->guid][0]->participant, one->participant) << one->topic;
  }
}

// ros2 topic list -t, ros2 service list -t: one type a name, demangled to one that exists; in Jazzy the type
// hash that Jazzy's own generator computes, in Humble no USER_DATA.
TEST_P(ToolsGraph, TypesAndTheirHashes) {
  nlohmann::json reference;
  const auto path = std::filesystem::path(GOALNET_SOURCE_DIR) / "../shared/data/ros2/type_hashes_jazzy.json";
  if (std::ifstream file(path); file) reference = nlohmann::json::parse(file);
  std::map<std::string, std::string> types;
  int compared = 0;
  for (const GraphEndpoint* one : ros_endpoints()) {
    const auto [known, is_new] = types.try_emplace(one->topic, one->type);
    EXPECT_EQ(known->second, one->type) << one->topic;
    const auto* type = idl::find_type(idl::ros_type_name(one->type));
    ASSERT_NE(type, nullptr) << one->topic << " has the type " << one->type;
    const std::string hash = std::string("typehash=") + type->hash + ";";
    EXPECT_EQ(one->user_data, jazzy() ? hash : "") << one->topic;
    if (!reference.contains(type->name)) continue;
    EXPECT_EQ(reference[type->name], type->hash) << type->name;
    ++compared;
  }
  if (!reference.is_null()) {
    EXPECT_GT(compared, 150);
  }
}

// ros2 topic info -v prints these; a shorter deadline of a subscription would make it incompatible with the
// default profile of a publisher. (Lifespans are compared in replay/endpoints_test.cc.)
TEST_P(ToolsGraph, DurationsAreInfiniteAndLivelinessAutomatic) {
  for (const GraphEndpoint* one : ros_endpoints()) {
    EXPECT_EQ(one->deadline, "infinite") << one->topic;
    EXPECT_EQ(one->lease, "infinite") << one->topic;
    EXPECT_EQ(one->liveliness, 0) << one->topic;
  }
}

// ros2 doctor compares every publisher with every subscription of its topic.
TEST_P(ToolsGraph, NoPairIsIncompatible) {
  int pairs = 0;
  for (const GraphEndpoint* writer : ros_endpoints()) {
    if (!writer->is_writer) continue;
    for (const GraphEndpoint* reader : graph().on(writer->topic, false)) {
      EXPECT_TRUE(writer->reliable || !reader->reliable) << writer->topic;
      EXPECT_TRUE(writer->transient_local || !reader->transient_local) << writer->topic;
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 15);
}

// rmw_service_server_is_available counts request readers and reply writers of a name: unequal numbers mean
// "not ready".
TEST_P(ToolsGraph, ServicesAreComplete) {
  int services = 0;
  for (const GraphEndpoint* one : ros_endpoints()) {
    if (!one->topic.starts_with("rq/") || one->is_writer) continue;
    const std::string name = one->topic.substr(3, one->topic.size() - 3 - std::string("Request").size());
    EXPECT_EQ(graph().on(one->topic, false).size(), 1u) << name;
    const auto replies = graph().on("rr/" + name + "Reply", true);
    ASSERT_EQ(replies.size(), 1u) << name;
    EXPECT_EQ(replies[0]->participant, one->participant) << name;
    std::string response = one->type;
    response.replace(response.rfind("_Request_"), std::string::npos, "_Response_");
    EXPECT_EQ(replies[0]->type, response) << name;
    EXPECT_TRUE(one->reliable && !one->transient_local) << name;
    ++services;
  }
  EXPECT_GT(services, 80);
}

// ros2 param: Jazzy's waits five seconds for each node that lacks one of the six. ros2 lifecycle nodes looks
// for get_state of that type; list, get and set use the others. ros2 component list looks for
// _container/list_nodes.
TEST_P(ToolsGraph, EveryNodeHasTheServicesThatToolsCall) {
  for (const SeenNode& node : graph().nodes) {
    const auto services = services_of(node);
    std::map<std::string, std::string> wanted = {
        {"describe_parameters", "rcl_interfaces/srv/DescribeParameters"},
        {"get_parameters", "rcl_interfaces/srv/GetParameters"},
        {"get_parameter_types", "rcl_interfaces/srv/GetParameterTypes"},
        {"list_parameters", "rcl_interfaces/srv/ListParameters"},
        {"set_parameters", "rcl_interfaces/srv/SetParameters"},
        {"set_parameters_atomically", "rcl_interfaces/srv/SetParametersAtomically"}};
    const std::map<std::string, std::string> managed = {
        {"change_state", "lifecycle_msgs/srv/ChangeState"},
        {"get_state", "lifecycle_msgs/srv/GetState"},
        {"get_available_states", "lifecycle_msgs/srv/GetAvailableStates"},
        {"get_available_transitions", "lifecycle_msgs/srv/GetAvailableTransitions"},
        {"get_transition_graph", "lifecycle_msgs/srv/GetAvailableTransitions"}};
    if (!is_launcher(node.full_name())) wanted.insert(managed.begin(), managed.end());
    if (jazzy()) {
      wanted["get_type_description"] = "type_description_interfaces/srv/GetTypeDescription";
      wanted["get_logger_levels"] = "rcl_interfaces/srv/GetLoggerLevels";
      wanted["set_logger_levels"] = "rcl_interfaces/srv/SetLoggerLevels";
    }
    for (const auto& [name, type] : wanted) {
      const auto found = services.find(node.full_name() + "/" + name);
      ASSERT_NE(found, services.end()) << node.full_name() << " " << name;
      EXPECT_EQ(found->second, type);
    }
    for (const auto& [name, type] : services) {
      EXPECT_EQ(name.find("_container"), std::string::npos) << name;
      // Humble's tools cannot show a service whose type they do not have.
      EXPECT_TRUE(jazzy() || !type.starts_with("type_description_interfaces/")) << name;
    }
    EXPECT_EQ(graph().has(node, "rt" + node.full_name() + "/transition_event",
                          "lifecycle_msgs::msg::dds_::TransitionEvent_", true),
              !is_launcher(node.full_name()))
        << node.full_name();
    EXPECT_TRUE(graph().has(node, "rt/rosout", "rcl_interfaces::msg::dds_::Log_", true)) << node.full_name();
    EXPECT_TRUE(graph().has(node, "rt/parameter_events", "rcl_interfaces::msg::dds_::ParameterEvent_", true))
        << node.full_name();
  }
}

// ros2 action list and info find servers by …/_action/feedback among a node's publishers, clients among its
// subscriptions; send_goal waits for three services and both topics.
TEST_P(ToolsGraph, TheActionIsComplete) {
  const std::string name = "/follow_instruction/_action/";
  const std::string type = "goalnet_msgs::action::dds_::FollowInstruction_";
  for (const auto& [topic, message] : std::map<std::string, std::string>{
           {"feedback", type + "FeedbackMessage_"}, {"status", "action_msgs::msg::dds_::GoalStatusArray_"}}) {
    const auto writers = graph().on("rt" + name + topic, true);
    ASSERT_EQ(writers.size(), 1u) << topic;
    EXPECT_EQ(writers[0]->type, message);
    EXPECT_EQ(writers[0]->transient_local, topic == "status");
    EXPECT_TRUE(writers[0]->reliable);
  }
  for (const auto& [service, request] :
       std::map<std::string, std::string>{{"send_goal", type + "SendGoal_Request_"},
                                          {"cancel_goal", "action_msgs::srv::dds_::CancelGoal_Request_"},
                                          {"get_result", type + "GetResult_Request_"}}) {
    const auto readers = graph().on("rq" + name + service + "Request", false);
    ASSERT_EQ(readers.size(), 1u) << service;
    EXPECT_EQ(readers[0]->type, request);
  }
}

// What RViz, tf2 and rosbag2 subscribe to late or with a profile of their own.
TEST_P(ToolsGraph, LatchedTopicsAndClock) {
  for (const char* topic : {"rt/robot_description", "rt/tf_static", "rt/markers"}) {
    const auto writers = graph().on(topic, true);
    ASSERT_EQ(writers.size(), 1u) << topic;
    EXPECT_TRUE(writers[0]->reliable && writers[0]->transient_local) << topic;
  }
  ASSERT_EQ(graph().on("rt/clock", true).size(), 1u);
  for (const GraphEndpoint* reader : graph().on("rt/clock", false)) {
    EXPECT_FALSE(reader->reliable) << "a simulator may publish the time with best effort";
  }
}

// Names that begin with _ are hidden from every list: only an action's own may.
TEST_P(ToolsGraph, NothingElseIsHidden) {
  for (const GraphEndpoint* one : ros_endpoints()) {
    std::string name = one->topic.substr(2);
    if (const auto at = name.find("/_action/"); at != std::string::npos) name.erase(at, 9);
    EXPECT_EQ(name.find("/_"), std::string::npos) << one->topic;
    EXPECT_EQ(name.find("__"), std::string::npos) << one->topic;
    EXPECT_LE(one->topic.size(), 255u) << one->topic;
  }
}

// A command without a daemon looks for half a second: of a machine that lets everybody run. One that takes
// ten times as long for everything is given ten times as long. Whoever misses a word and hears it with the
// next heartbeat only is late on any machine.
TEST_P(ToolsGraph, HalfASecondShowsEverything) {
  const auto missing = [&](const SeenGraph& glance) {
    std::string names;
    for (const std::string& node : kComponents) {
      const auto seen = glance.node_names();
      if (!std::binary_search(seen.begin(), seen.end(), node)) names += " " + node;
    }
    for (const auto& [guid, endpoint] : graph().endpoints) {
      const bool ours = guid.starts_with("010f");
      if (ours && !glance.endpoints.contains(guid)) names += " " + endpoint.topic;
    }
    return names;
  };
  const auto& glances = glances_.at(GetParam());
  ASSERT_FALSE(glances.empty());
  EXPECT_EQ(missing(glances.back()), "");
  const auto complete = std::find_if(glances.begin(), glances.end(),
                                     [&](const SeenGraph& glance) { return missing(glance).empty(); });
  ASSERT_NE(complete, glances.end());
  const double slowdown = slowdowns_.at(GetParam());
  std::cout << "all seen after " << complete->seconds << " s; everything takes " << slowdown
            << " times as long\n";
  EXPECT_LT(complete->seconds / slowdown, 0.5);
}

// ros2 lifecycle get with rmw_cyclonedds: one process each.
TEST_P(ToolsGraph, CycloneToolsAreAnswered) {
  std::string expected;
  for (const std::string& node : kComponents) expected += node + " state 3 active\n";
  EXPECT_EQ(states_.at(GetParam()), expected);
}

INSTANTIATE_TEST_SUITE_P(Distributions, ToolsGraph, testing::Values("humble", "jazzy"));

}  // namespace
}  // namespace goalnet::ros
