#include "tools/goalnet/tell_command.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "components/coordinator/request.h"
#include "components/coordinator/status_message.h"
#include "components/messages/conversions.h"
#include "components/ros/action_client.h"
#include "components/ros/arguments.h"
#include "components/ros/node.h"
#include "goalnet_msgs/action/FollowInstruction_action.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "tools/goalnet/command_line.h"
#include "tools/goalnet/reset_executor.h"
#include "tools/goalnet/run_record.h"
#include "tools/goalnet/stop_signal.h"
#include "tools/goalnet/trace_printer.h"

namespace goalnet::tools {
namespace {

using namespace std::chrono_literals;
using FollowAction = goalnet_msgs::action::FollowInstruction;
using goalnet_msgs::msg::InstructionStatus;
using SteadyClock = std::chrono::steady_clock;

constexpr const char* kFooter =
    "Examples:\n"
    "  goalnet launch robot                       # in another terminal\n"
    "  goalnet tell \"fill the mug with water\"\n"
    "  goalnet tell yes                                   when it asked \"did you mean ...?\"\n"
    "  goalnet tell --namespace /robot1 --json \"open the microwave\"\n"
    "  goalnet tell --reset                       # after an emergency stop\n"
    "\n"
    "The robot is found on ROS_DOMAIN_ID. Ctrl-C cancels: the robot comes to rest smoothly and this ends "
    "with "
    "code 22;\n"
    "a second Ctrl-C only leaves. The exit code is the outcome: 0 done, 10-19 refused, 20-29 a limit, 30-39 "
    "a "
    "fault.";

// How long the robot may take to say how a cancelled instruction ended, and why it did not accept one.
constexpr auto kPatience = 10s;
constexpr auto kReason = 2s;

struct TellOptions {
  std::string instruction;
  std::string name_space;
  std::uint32_t max_steps = 0;
  double wait = 10.0;  // [s]
  bool json = false;
  bool reset = false;
};

TraceStyle one_clock(TraceStyle style) {
  style.simulated = false;
  return style;
}

// One instruction, from the search for the robot to the result.
class Telling {
 public:
  Telling(ros::Node& node, ros::EventLoop& loop, const TellOptions& options)
      : loop_(loop),
        options_(options),
        printer_(std::cout, one_clock(style_for(STDOUT_FILENO))),
        client_(node, "follow_instruction"),
        status_(node.subscribe<InstructionStatus>(
            "instruction_status", ros::Qos::latched().keep_last(100),
            [this](const InstructionStatus& message) { on_status(coordinator::from_message(message)); })),
        place_(node.resolve("follow_instruction")),
        stop_([this] { loop_.wake(); }) {}

  Expected<coordinator::Report> carry_out() {
    if (auto found = find_robot(); !found) return tl::unexpected<Error>(std::move(found.error()));
    start_ = SteadyClock::now();
    sent_ = true;
    FollowAction::Goal goal;
    goal.instruction(options_.instruction);
    goal.max_steps(options_.max_steps);
    const ros::GoalId id = client_.send(goal, {.on_response = [this](bool accepted) { accepted_ = accepted; },
                                               .on_feedback = {},
                                               .on_result = [this](auto result) { on_result(result); }});
    // In rounds, so that a signal is seen.
    std::optional<SteadyClock::time_point> patience;
    while (!result_) {
      loop_.run_for(100ms, [this] { return result_ || accepted_ == false; });
      if (accepted_ == false && !result_) return refusal();
      if (stop_.requested() && !patience) {
        client_.cancel(id, [this](const Expected<ros::CancelCode>& code) { on_cancel_answer(code); });
        patience = SteadyClock::now() + kPatience;
      }
      if (patience && SteadyClock::now() > *patience)
        return fail(Outcome::kComponentLost, "the robot did not answer that it has stopped: look at it");
    }
    return *result_;
  }

  void tell_person(const coordinator::Report& report) {
    if (!options_.json) printer_.end(report, report.facts_added, report.facts_removed, 0.0, seconds());
  }
  double seconds() const { return std::chrono::duration<double>(SteadyClock::now() - start_).count(); }
  const RunRecord& record() const { return record_; }

 private:
  Expected<void> find_robot() {
    const auto end = SteadyClock::now() + std::chrono::duration<double>(options_.wait);
    bool said = false;
    while (!client_.wait_for_server(0s)) {
      if (stop_.requested()) return fail(Outcome::kCancelled, "interrupted before a robot was found");
      if (SteadyClock::now() > end)
        return fail(Outcome::kComponentLost,
                    "nobody offers the action " + place_ +
                        " here: is the robot up (\"goalnet launch robot\"), with this ROS_DOMAIN_ID, and is "
                        "its namespace the one given with --namespace?");
      loop_.run_for(100ms);
      if (!said && SteadyClock::now() + std::chrono::duration<double>(options_.wait) > end + 2s) {
        std::cerr << "looking for " << place_ << " …\n";
        said = true;
      }
    }
    // What the robot did last is not news.
    status_->wait_for_publishers(1, 1s);
    loop_.run_for(200ms, [this] { return last_seen_ > 0; });
    return {};
  }

  void on_status(const coordinator::Report& report) {
    const bool ours = sent_ && report.id > last_seen_ && report.instruction == options_.instruction &&
                      (ours_ == 0 || report.id == ours_);
    if (!sent_) last_seen_ = std::max(last_seen_, report.id);
    if (!ours) return;
    ours_ = report.id;
    record_.on_status(report);
    if (!options_.json) printer_.on_status(report, seconds(), seconds());
  }

  void on_result(const Expected<std::pair<ros::GoalState, FollowAction::Result>>& answer) {
    if (!answer) {
      const bool lost = answer.error().outcome == Outcome::kComponentLost;
      result_ = fail(answer.error().outcome,
                     lost ? place_ +
                                " went away before it said how the instruction ended; if it was started "
                                "again, the instruction is lost all the same"
                          : answer.error().message);
      return;
    }
    const auto& [state, told] = *answer;
    if (state == ros::GoalState::kUnknown) {
      result_ = fail(Outcome::kComponentLost, "the robot knows nothing of the instruction any more");
      return;
    }
    coordinator::Report report = record_.last();
    report.finished = true;
    report.stage = coordinator::Stage::kFinished;
    report.outcome = outcome_from_int(told.outcome());
    report.message = told.message();
    report.facts_added = FactSet(messages::from_message(told.facts_added()));
    report.facts_removed = FactSet(messages::from_message(told.facts_removed()));
    report.actions = messages::from_message(told.actions());
    result_ = std::move(report);
  }

  // One that was started again in the meantime stops what its predecessor began.
  void on_cancel_answer(const Expected<ros::CancelCode>& code) {
    if (code && *code == ros::CancelCode::kUnknownGoal && !result_)
      result_ = fail(Outcome::kComponentLost, "the robot knows nothing of the instruction any more");
  }

  // The reason of a goal that was not accepted is in the status of that instruction.
  Expected<coordinator::Report> refusal() {
    loop_.run_for(kReason, [this] { return record_.last().finished; });
    if (record_.last().finished) return record_.last();
    return fail(Outcome::kBusy,
                "the robot did not accept the instruction and said no reason: is it active "
                "(\"ros2 lifecycle get /coordinator\")?");
  }

  ros::EventLoop& loop_;
  const TellOptions& options_;
  TracePrinter printer_;
  RunRecord record_;
  ros::ActionClient<FollowAction> client_;
  std::shared_ptr<ros::Subscription<InstructionStatus>> status_;
  std::string place_;
  SteadyClock::time_point start_ = SteadyClock::now();
  bool sent_ = false;
  std::uint64_t last_seen_ = 0;  // id of the newest instruction before ours
  std::uint64_t ours_ = 0;
  std::optional<bool> accepted_;
  std::optional<Expected<coordinator::Report>> result_;
  StopSignal stop_;  // last: its thread ends first
};

nlohmann::ordered_json to_json(const TellOptions& options, const RunRecord& record,
                               const coordinator::Report& report, double seconds) {
  nlohmann::ordered_json object;
  object["instruction"] = options.instruction;
  object["outcome"] = to_string(report.outcome);
  object["message"] = report.message;
  object["facts_added"] = texts(report.facts_added);
  object["facts_removed"] = texts(report.facts_removed);
  object["steps"] = to_json(record.steps());
  object["actions"] = texts(report.actions);
  object["wall_time_s"] = std::round(seconds * 1000.0) / 1000.0;
  return object;
}

int reset(ros::Node& node, ros::EventLoop& loop, const TellOptions& options) {
  const auto done = reset_executor(node, loop, std::chrono::duration<double>(options.wait));
  if (!done) return tell("goalnet tell", done.error(), options.json);
  if (options.json) {
    print_json({{"outcome", to_string(Outcome::kDone)}, {"message", *done}});
  } else {
    std::cout << *done << "\n";
  }
  return 0;
}

}  // namespace

int tell_command(int argc, char** argv) {
  TellOptions options;
  std::vector<std::string> words;
  // --ros-args follows ROS 2's own grammar and is parsed where nodes are made.
  char** const ros =
      std::find_if(argv, argv + argc, [](const char* a) { return std::string_view(a) == "--ros-args"; });
  CLI::App app{"Gives an instruction to a robot that is up, and follows what it does about it."};
  app.name("goalnet tell");
  app.footer(kFooter);
  app.add_option("instruction", words, "What to do, in plain English");
  app.add_option("-n,--namespace", options.name_space, "Namespace of the robot, for example /robot1");
  app.add_option("--max-steps", options.max_steps, "Inference steps before giving up [the robot's]")
      ->check(CLI::Range(1, 1000));
  app.add_option("--wait", options.wait, "Seconds to look for the robot")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  app.add_flag("--reset", options.reset, "End the fault of the executor instead: the robot will move again");
  app.add_flag("--json", options.json, "One JSON object on standard output and nothing else");
  if (const auto code = parse_or_tell(app, static_cast<int>(ros - argv), argv)) return *code;
  // Forgotten quotes are forgiven: the words are one instruction.
  for (const std::string& word : words)
    options.instruction += (options.instruction.empty() ? "" : " ") + word;
  const auto refuse = [&](const Error& error) { return tell("goalnet tell", error, options.json); };
  if (options.reset && !words.empty())
    return refuse({Outcome::kInvalidRequest, "--reset and an instruction are two commands; give one"});
  if (const auto checked = coordinator::check_instruction(options.instruction); !options.reset && !checked)
    return refuse(checked.error());
  auto arguments = ros::parse_arguments({ros, argv + argc});
  if (!arguments) return refuse(arguments.error());
  if (!options.name_space.empty())
    arguments->remaps.insert(arguments->remaps.begin(),
                             {"", ros::RemapKind::kNamespace, "", options.name_space});
  const auto context = ros::Context::create();
  if (!context) return refuse(context.error());
  ros::EventLoop loop;
  ros::NodeOptions node_options;
  node_options.name = "goalnet_tell";
  node_options.arguments = *arguments;
  const auto node = ros::Node::create(**context, loop, std::move(node_options));
  if (!node) return refuse(node.error());
  if (options.reset) return reset(**node, loop, options);
  Telling telling(**node, loop, options);
  const auto report = telling.carry_out();
  if (!report) return refuse(report.error());
  if (options.json) {
    print_json(to_json(options, telling.record(), *report, telling.seconds()));
  } else {
    telling.tell_person(*report);
  }
  return static_cast<int>(report->outcome);
}

}  // namespace goalnet::tools
