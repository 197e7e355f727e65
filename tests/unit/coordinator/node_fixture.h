// The coordinator as a node with the components around it played by the test over DDS.
#pragma once

#include <gmock/gmock-matchers.h>

#include "components/coordinator/coordinator_node.h"
#include "components/coordinator/status_message.h"
#include "components/messages/conversions.h"
#include "components/ros/action_client.h"
#include "tests/support/domain.h"
#include "tests/unit/coordinator/toy_world.h"

namespace goalnet::coordinator {

using goalnet_msgs::msg::ActionRequest;
using goalnet_msgs::msg::ActionStatus;
using goalnet_msgs::msg::GoalPredicates;
using goalnet_msgs::msg::InstructionStatus;
using goalnet_msgs::msg::Plan;
using goalnet_msgs::msg::StepRequest;

// Everything but the coordinator: a goalnet that wants the mug held, a planner that knows how, hands that
// never fail.
class NodeTest : public testing::Test {
 protected:
  void start(const std::vector<std::string>& words = {}) {
    ros::ContextOptions context_options;
    context_options.domain_id = testing_support::own_domain();
    context_options.process_only = true;
    context = ros::Context::create(context_options).value();
    ros::NodeOptions options;
    options.name = "coordinator";
    options.arguments = ros::parse_arguments(words).value();
    options.arguments.console = false;
    node = ros::Node::create(*context, loop, std::move(options)).value();
    ros::NodeOptions others_options;
    others_options.name = "others";
    others = ros::Node::create(*context, loop, std::move(others_options)).value();
  }

  void play_the_others() {
    instruction = others->advertise<std_msgs::msg::String>("/instruction");
    given_goal = others->advertise<GoalPredicates>("/goal");
    world = others->advertise<goalnet_msgs::msg::WorldState>("/world_state", ros::Qos::latched());
    goals = others->advertise<GoalPredicates>("/goal_predicates");
    plans = others->advertise<Plan>("/plan");
    action_status = others->advertise<ActionStatus>("/action_status");
    status = others->subscribe<InstructionStatus>(
        "/instruction_status", ros::Qos::latched().keep_last(100),
        [this](const InstructionStatus& message) { reports.push_back(from_message(message)); });
    steps = others->subscribe<StepRequest>("/step_request", ros::Qos::standard(),
                                           [this](const StepRequest& request) {
                                             if (goalnet_is_silent) return;
                                             GoalPredicates answer;
                                             answer.instruction_id(request.instruction_id());
                                             answer.step(request.step());
                                             if (request.step() == 0)
                                               messages::fill(answer, goal({"(Grasping Robot Mug_1)"}));
                                             answer.complete(request.step() > 0);
                                             goals->publish(answer);
                                           });
    goal_heard = others->subscribe<
        GoalPredicates>("/goal_predicates", ros::Qos::standard(), [this](const GoalPredicates& wanted) {
      if (planner_is_silent) return;
      Plan plan;
      plan.instruction_id(wanted.instruction_id());
      plan.step(wanted.step());
      plan.actions(messages::to_message(std::vector<Action>{{"moveto", {"Mug_1"}}, {"grasp", {"Mug_1"}}}));
      if (!wanted.complete()) plans->publish(plan);
    });
    actions = others->subscribe<ActionRequest>(
        "/action_request", ros::Qos::standard(), [this](const ActionRequest& request) {
          const std::string name = request.action().name();
          carried_out.push_back(goalnet::to_string(messages::from_message(request.action())));
          if (hands_are_stuck) return;
          facts_now.insert(name == "moveto" ? fact("(Near Robot Mug_1)") : fact("(Grasping Robot Mug_1)"));
          if (name == "grasp") facts_now.erase(fact("(On Mug_1 Counter_1)"));
          ActionStatus finished;
          finished.instruction_id(request.instruction_id());
          finished.step(request.step());
          finished.index(request.index());
          finished.state(goalnet_msgs::msg::ActionStatus_Constants::FINISHED);
          if (request.command() == goalnet_msgs::msg::ActionRequest_Constants::CANCEL) finished.outcome(22);
          action_status->publish(finished);
        });
    world_timer = others->create_timer(std::chrono::milliseconds(20), [this] {
      goalnet_msgs::msg::WorldState message;
      message.header().stamp(others->now());
      messages::fill(message, WorldState{{"Counter_1", "Mug_1", "Robot", "Sink"}, facts_now});
      world->publish(message);
    });
  }

  void say(const std::string& text) {
    std_msgs::msg::String message;
    message.data(text);
    instruction->publish(message);
  }

  bool wait_for_end() {
    return loop.run_for(std::chrono::seconds(5),
                        [this] { return !reports.empty() && reports.back().finished; });
  }

  std::unique_ptr<ros::Context> context;
  ros::EventLoop loop;
  std::unique_ptr<ros::Node> node, others;
  std::shared_ptr<ros::Publisher<std_msgs::msg::String>> instruction;
  std::shared_ptr<ros::Publisher<GoalPredicates>> given_goal, goals;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::WorldState>> world;
  std::shared_ptr<ros::Publisher<Plan>> plans;
  std::shared_ptr<ros::Publisher<ActionStatus>> action_status;
  std::shared_ptr<ros::Subscription<InstructionStatus>> status;
  std::shared_ptr<ros::Subscription<StepRequest>> steps;
  std::shared_ptr<ros::Subscription<GoalPredicates>> goal_heard;
  std::shared_ptr<ros::Subscription<ActionRequest>> actions;
  std::shared_ptr<ros::Timer> world_timer;
  FactSet facts_now = facts({"(On Mug_1 Counter_1)", "(IsGraspable Mug_1)"});
  bool goalnet_is_silent = false, planner_is_silent = false, hands_are_stuck = false;
  std::vector<Report> reports;
  std::vector<std::string> carried_out;
};

using FollowAction = goalnet_msgs::action::FollowInstruction;

// A client of follow_instruction and what it was told.
struct Follower {
  Follower(ros::Node& node) : client(node, "/follow_instruction") {}
  ros::GoalId send(const std::string& text) {
    FollowAction::Goal wanted;
    wanted.instruction(text);
    return client.send(
        wanted, {.on_response = [this](bool yes) { accepted = yes; },
                 .on_feedback = [this](const FollowAction::Feedback& f) { stages.push_back(f.stage()); },
                 .on_result =
                     [this](const auto& ended) {
                       state = ended->first;
                       result = ended->second;
                     }});
  }
  ros::ActionClient<FollowAction> client;
  std::optional<bool> accepted;
  std::vector<std::string> stages;
  std::optional<ros::GoalState> state;
  FollowAction::Result result;
};

}  // namespace goalnet::coordinator
