#include "tools/goalnet/record_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <string_view>

namespace goalnet::tools {
namespace {

constexpr const char* kRecordFooter =
    "Examples:\n"
    "  goalnet record                                   everything, until Ctrl-C\n"
    "  goalnet record -o bag --storage sqlite3 /world_state /tf\n"
    "  goalnet record --repair bag                      after a crash of the recorder\n"
    "\n"
    "\"ros2 bag info\", \"ros2 bag play\" and Foxglove open the result. GOALNET_ROS_DISTRO=humble writes "
    "what Humble "
    "reads.";

constexpr const char* kReplayFooter =
    "Examples:\n"
    "  goalnet replay bag\n"
    "  goalnet replay bag --rate 2 --clock --topics /tf /joint_states";

// "rosbag2_2024_05_31-12_00_00", as ros2 bag calls them.
std::string default_directory() {
  char name[64];
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::strftime(name, sizeof name, "rosbag2_%Y_%m_%d-%H_%M_%S", &local);
  return name;
}

// Parses what stands before --ros-args, whose grammar is ROS 2's own. Returns whether help was shown.
Expected<bool> parse(CLI::App& app, int argc, char** argv, std::vector<std::string>& ros_arguments) {
  char** const ros =
      std::find_if(argv, argv + argc, [](const char* a) { return std::string_view(a) == "--ros-args"; });
  ros_arguments.assign(ros, argv + argc);
  try {
    app.parse(static_cast<int>(ros - argv), argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      return fail(Outcome::kInvalidRequest,
                  std::string(error.what()) + "; \"" + app.get_name() + " --help\" tells more");
    }
    app.exit(error);
    return true;
  }
  return false;
}

}  // namespace

Expected<ParsedRecord> parse_record_options(int argc, char** argv) {
  ParsedRecord parsed;
  CLI::App app{"Records topics of ROS 2 nodes on this domain into a bag, until Ctrl-C."};
  app.name("goalnet record");
  app.footer(kRecordFooter);
  ros::TopicSelection::Options selection;
  std::string storage = "mcap", compression = "none", output;
  bool all = false;
  double most_seconds = 0.0;
  app.add_option("topics", selection.topics, "What to record [everything that is not hidden]");
  app.add_flag("-a,--all", all, "Everything that is not hidden, beside the topics named");
  app.add_option("-e,--regex", selection.regex, "Topics in whose names this is found");
  app.add_option("-x,--exclude", selection.exclude, "But none in whose names this is found");
  app.add_flag("--include-hidden-topics", selection.hidden, "Also names with a part that begins with \"_\"");
  app.add_option("-o,--output", output, "Directory to make [rosbag2_DATE-TIME]");
  app.add_option("-s,--storage", storage, "mcap or sqlite3")->capture_default_str();
  app.add_option("--compression", compression, "none or zstd (MCAP only)")
      ->check(CLI::IsMember({"none", "zstd"}))
      ->capture_default_str();
  app.add_option("-b,--max-bag-size", parsed.options.bag.split_bytes,
                 "Begin a new file at this size [bytes; 0: never]");
  app.add_option("-d,--max-bag-duration", most_seconds, "Begin a new file after this time [s; 0: never]")
      ->check(CLI::Range(0.0, 1e9));
  app.add_option("--repair", parsed.repair, "Make this directory whole instead, whose recorder was killed");
  auto shown = parse(app, argc, argv, parsed.ros_arguments);
  if (!shown) return tl::unexpected<Error>(std::move(shown.error()));
  parsed.help_shown = *shown;
  auto kind = ros::parse_bag_storage(storage);
  if (!kind) return tl::unexpected<Error>(std::move(kind.error()));
  parsed.options.bag.storage = *kind;
  parsed.options.bag.directory = output.empty() ? default_directory() : output;
  parsed.options.bag.file.compress = compression == "zstd";
  parsed.options.bag.split_duration = std::chrono::nanoseconds(static_cast<std::int64_t>(most_seconds * 1e9));
  if (parsed.options.bag.file.compress && *kind == ros::BagStorage::kSqlite)
    return fail(Outcome::kInvalidRequest, "--compression is for MCAP only");
  if (all) selection.regex = ".";
  auto selected = ros::TopicSelection::create(selection);
  if (!selected) return tl::unexpected<Error>(std::move(selected.error()));
  parsed.options.selection = std::move(*selected);
  return parsed;
}

Expected<ParsedReplay> parse_replay_options(int argc, char** argv) {
  ParsedReplay parsed;
  CLI::App app{
      "Publishes what a bag holds (MCAP or SQLite, from any recorder), with its types and quality of "
      "service."};
  app.name("goalnet replay");
  app.footer(kReplayFooter);
  ros::TopicSelection::Options selection;
  double delay = 0.5;
  app.add_option("bag", parsed.bag, "The bag's directory, or its .mcap or .db3 file")->required();
  app.add_option("-r,--rate", parsed.options.rate, "Times as fast as recorded")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--topics", selection.topics, "Only these [all]");
  app.add_option("-e,--regex", selection.regex, "Only those in whose names this is found");
  app.add_option("-x,--exclude", selection.exclude, "None in whose names this is found");
  app.add_option("--clock", parsed.options.clock_hz,
                 "Publish /clock in the recording's time, so often in a second [40]")
      ->expected(0, 1)
      ->default_str("40")
      ->check(CLI::Range(0.1, 1000.0));
  app.add_flag("-l,--loop", parsed.options.loop, "For ever");
  app.add_option("-d,--delay", delay, "Seconds before the first message, for subscribers to find the topics")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 3600.0));
  auto shown = parse(app, argc, argv, parsed.ros_arguments);
  if (!shown) return tl::unexpected<Error>(std::move(shown.error()));
  parsed.help_shown = *shown;
  selection.hidden = true;  // whoever recorded them wanted them
  auto selected = ros::TopicSelection::create(selection);
  if (!selected) return tl::unexpected<Error>(std::move(selected.error()));
  parsed.options.selection = std::move(*selected);
  parsed.options.delay = std::chrono::nanoseconds(static_cast<std::int64_t>(delay * 1e9));
  return parsed;
}

}  // namespace goalnet::tools
