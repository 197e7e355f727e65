#include "tools/goalnet/run_command.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>

#include "components/ros/arguments.h"
#include "tools/goalnet/command_line.h"
#include "tools/goalnet/lockstep_loop.h"
#include "tools/goalnet/physics_start.h"
#include "tools/goalnet/run_options.h"
#include "tools/goalnet/run_record.h"
#include "tools/goalnet/stop_signal.h"
#include "tools/goalnet/trace_printer.h"
#include "tools/goalnet/untidy_start.h"
#include "tools/goalnet/world_file.h"

namespace goalnet::tools {
namespace {

using SteadyClock = std::chrono::steady_clock;

// After Ctrl-C: the robot gets this long to come to rest before we leave all the same. A whole second is
// promised.
constexpr std::chrono::milliseconds kPatience{800};

constexpr double kResting = 0.5, kRolling = 2.0;  // [s] simulated, until things lie still

double since(SteadyClock::time_point start) {
  return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

RunLabel label_of(const RunOptions& options) {
  RunLabel label{options.instruction, options.scene, options.seed};
  if (!options.goal.empty()) {
    for (const Predicate& fact : options.goal.positive)
      label.instruction += (label.instruction.empty() ? "" : " ") + to_string(fact);
    for (const Predicate& fact : options.goal.negative) {
      label.instruction += (label.instruction.empty() ? "not " : " not ") + to_string(fact);
    }
  }
  return label;
}

// Something was wrong before anything moved.
int refuse(const RunOptions& options, const Error& error) {
  if (options.json) print_json(to_json(label_of(options), error));
  std::cerr << "goalnet run: " << error.message << "\n";
  return static_cast<int>(error.outcome);
}

// One run from the instruction to its end.
class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_(options),
        label_(label_of(options)),
        printer_(std::cout, style_for(STDOUT_FILENO)),
        stop_([this] {
          if (LockstepLoop* loop = interruptible_.load()) loop->interrupt();
        }) {}
  ~Run() { interruptible_ = nullptr; }

  Expected<void> prepare(const ros::Arguments& arguments) {
    if (auto folder = make_picture_folder(); !folder) return folder;
    WorldFile start;
    if (!options_.start.empty()) {
      auto file = read_world(options_.start);
      if (!file) return tl::unexpected<Error>(std::move(file.error()));
      start = std::move(*file);
    }
    LoopOptions loop_options;
    loop_options.scene = options_.scene;
    loop_options.robot = options_.robot;
    loop_options.model = options_.model;
    loop_options.seed = options_.seed;
    loop_options.max_steps = options_.max_steps;
    loop_options.instruction_timeout = options_.max_sim_time;
    loop_options.console = options_.verbose;
    loop_options.process_only = options_.private_run;
    loop_options.record = options_.record;
    loop_options.record_storage = options_.record_storage;
    loop_options.arguments = arguments;
    LoopEvents events;
    events.on_status = [this](const coordinator::Report& report) {
      record_.on_status(report);
      if (!options_.json) printer_.on_status(report, sim_elapsed(), since(start_));
    };
    events.on_world = [this](const WorldState& world) { record_.on_world(world); };
    events.on_stage = [this](const std::string& stage, double progress) {
      if (!options_.json) printer_.on_stage(stage, progress, sim_elapsed(), since(start_));
    };
    events.stop_asked = [this] { return stop_.requested(); };
    auto loop = LockstepLoop::create(loop_options, std::move(events));
    if (!loop) return tl::unexpected<Error>(std::move(loop.error()));
    loop_ = std::move(*loop);
    interruptible_ = loop_.get();
    if (options_.untidy) make_untidy(loop_->world(), options_.seed);
    if (!options_.start.empty())
      arrange(loop_->world(), start.world.facts, start.whole ? Contents::kAsSaid : Contents::kAsTheyAre);
    const bool moved = options_.untidy || !options_.start.empty();
    if (auto settled = loop_->settle(moved ? kRolling : kResting); !settled) return settled;
    tell_what_differs(start.world.facts);
    return {};
  }

  int carry_out() {
    if (!options_.json) printer_.begin(label_, "");
    start_ = SteadyClock::now();
    sim_start_ = loop_->sim_time();
    if (options_.goal.empty()) {
      loop_->instruct(options_.instruction);
    } else {
      loop_->pursue(options_.goal);
    }
    take_picture("start");
    bool cancelled = false;
    while (!record_.last().finished && stop_.age() < kPatience) {
      if (stop_.requested() && !cancelled) {
        loop_->cancel("interrupted");
        cancelled = true;
      }
      loop_->step();
      if (const auto& done = record_.last().actions; done.size() >= pictures_ && !options_.render.empty()) {
        take_picture(to_string(done.back()));
      }
    }
    coordinator::Report last = record_.last();
    if (!last.finished) {
      last.outcome = Outcome::kCancelled;
      last.message = "interrupted; the robot had not come to rest";
      record_.on_status(last);
    }
    const double sim_time = sim_elapsed(), wall_time = since(start_);
    nlohmann::ordered_json json = to_json(label_, record_, sim_time, wall_time);
    if (!options_.json) {
      printer_.end(last, difference(record_.facts(), record_.facts_before()),
                   difference(record_.facts_before(), record_.facts()), sim_time, wall_time);
    }
    const Outcome recorded = finish_recording(json);  // simulates on for a moment
    if (options_.json) print_json(json);
    // Whoever asked for a recording did not get what was asked for, whatever the robot did.
    return static_cast<int>(last.outcome == Outcome::kDone ? recorded : last.outcome);
  }

 private:
  double sim_elapsed() const { return loop_ ? loop_->sim_time() - sim_start_ : 0.0; }

  // A state can say what cannot be: places with no room left, things in the hand, things that are not here.
  void tell_what_differs(const FactSet& start) const {
    std::string missing;
    for (const Predicate& fact : difference(start, record_.facts())) {
      if (is_place(fact) || fact.relation == "state" || fact.relation == "Grasping")
        missing += " " + to_string(fact);
    }
    if (!missing.empty())
      std::cerr << "goalnet run: not as " << options_.start << " has it:" << missing << "\n";
  }

  Expected<void> make_picture_folder() const {
    if (options_.render.empty()) return {};
    std::error_code failed;
    std::filesystem::create_directories(options_.render, failed);
    if (!failed && access(options_.render.c_str(), W_OK) != 0)
      failed = std::error_code(errno, std::generic_category());
    if (failed)
      return fail(Outcome::kInvalidRequest,
                  "--render: pictures cannot be written to " + options_.render + ": " + failed.message());
    return {};
  }

  // "02-keep-on-Mug_1-Sink.png"; the first is "00-start.png". Trouble with pictures does not end a run.
  void take_picture(std::string name) {
    if (options_.render.empty()) return;
    std::replace(name.begin(), name.end(), ' ', '-');
    const std::string number = (pictures_ < 10 ? "0" : "") + std::to_string(pictures_);
    ++pictures_;
    const auto written = loop_->picture(options_.render + "/" + number + "-" + name + ".png");
    if (!written) std::cerr << "goalnet run: " << written.error().message << "\n";
  }

  // Completes the bag and says in `json` whether it is whole.
  Outcome finish_recording(nlohmann::ordered_json& json) {
    if (options_.record.empty()) return Outcome::kDone;
    const auto recorded = loop_->finish_recording();
    json["recording"] = {{"directory", options_.record},
                         {"complete", recorded.has_value()},
                         {"message", recorded ? "" : recorded.error().message}};
    if (recorded) return Outcome::kDone;
    std::cerr << "goalnet run: " << recorded.error().message << "; the recording is not complete\n";
    return recorded.error().outcome;
  }

  const RunOptions& options_;
  RunLabel label_;
  TracePrinter printer_;
  RunRecord record_;
  SteadyClock::time_point start_ = SteadyClock::now();
  double sim_start_ = 0.0;
  std::size_t pictures_ = 0;
  std::atomic<LockstepLoop*> interruptible_{nullptr};
  StopSignal stop_;  // last: its thread ends first
  std::unique_ptr<LockstepLoop> loop_;
};

}  // namespace

int run_command(int argc, char** argv) {
  const ParsedRun parsed = parse_run_options(argc, argv);
  if (parsed.help_shown) return 0;
  if (parsed.refused) return refuse(parsed.options, *parsed.refused);
  const auto arguments = ros::parse_arguments(parsed.options.ros_arguments);
  if (!arguments) return refuse(parsed.options, arguments.error());
  Run run(parsed.options);
  if (const auto prepared = run.prepare(*arguments); !prepared)
    return refuse(parsed.options, prepared.error());
  return run.carry_out();
}

}  // namespace goalnet::tools
