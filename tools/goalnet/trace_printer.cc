#include "tools/goalnet/trace_printer.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace goalnet::tools {
namespace {

constexpr std::size_t kActionWidth = 34;

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 9.95 ? "%.1f s" : "%.0f s", value);
  return text;
}

std::string bar(double part) {
  constexpr int kCells = 12;
  const int filled = static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * kCells));
  std::string text;
  for (int i = 0; i < kCells; ++i) text += i < filled ? "█" : "░";
  return text;
}

// Where the robot stands and which hand holds what is how, not what: left out of the summary.
bool worth_telling(const Predicate& fact) { return fact.relation != "Near" && fact.relation != "Held"; }

std::string join(const FactSet& facts) {
  std::string text;
  for (const Predicate& fact : facts) {
    if (!worth_telling(fact)) continue;
    if (!text.empty()) text += "  ";
    text += goalnet::to_string(fact);
  }
  return text;
}

}  // namespace

TraceStyle style_for(int fd) {
  const char* term = std::getenv("TERM");
  const bool capable = isatty(fd) != 0 && term != nullptr && std::strcmp(term, "dumb") != 0;
  const char* no_colour = std::getenv("NO_COLOR");
  return {capable && (no_colour == nullptr || *no_colour == '\0'), capable};
}

std::string TracePrinter::paint(const std::string& text, Paint colour) const {
  if (!style_.colour || text.empty()) return text;
  const char* code = "";
  switch (colour) {
    case Paint::kPlain:
      return text;
    case Paint::kBold:
      code = "1";
      break;
    case Paint::kDim:
      code = "2";
      break;
    case Paint::kGreen:
      code = "32";
      break;
    case Paint::kRed:
      code = "31";
      break;
    case Paint::kYellow:
      code = "33";
      break;
    case Paint::kCyan:
      code = "36";
      break;
  }
  return std::string("\x1b[") + code + "m" + text + "\x1b[0m";
}

void TracePrinter::begin(const RunLabel& label, const std::string& note) {
  out_ << paint(label.instruction, Paint::kBold) << "\n"
       << paint("scene " + label.scene + ", seed " + std::to_string(label.seed) +
                    (note.empty() ? "" : ", " + note),
                Paint::kDim)
       << "\n"
       << std::flush;
}

void TracePrinter::print_goal(const coordinator::Report& report) {
  out_ << "\n" << paint("step " + std::to_string(report.step + 1), Paint::kBold) << "  wants";
  for (const Predicate& fact : report.goal.positive)
    out_ << "  " << paint(goalnet::to_string(fact), Paint::kCyan);
  for (const Predicate& fact : report.goal.negative) {
    out_ << "  " << paint("not " + goalnet::to_string(fact), Paint::kYellow);
  }
  if (report.goal.confidence < 0.995) {
    char text[32];
    std::snprintf(text, sizeof text, "  (%.0f %% sure)", report.goal.confidence * 100.0);
    out_ << paint(text, Paint::kDim);
  }
  out_ << "\n";
}

void TracePrinter::print_plan(const coordinator::Report& report) {
  std::string text;
  for (const Action& action : report.plan) text += (text.empty() ? "" : ", ") + goalnet::to_string(action);
  out_ << "        plan  " << (text.empty() ? "nothing to do: it holds already" : text) << "\n";
}

void TracePrinter::draw_action(const std::string& mark, const std::string& right, bool final_line) {
  if (!final_line && !style_.live) return;
  if (line_open_) out_ << "\r\x1b[2K";
  const std::size_t padding = action_.size() < kActionWidth ? kActionWidth - action_.size() : 1;
  out_ << "     " << mark << " " << action_ << std::string(padding, ' ') << right;
  line_open_ = !final_line;
  if (final_line) out_ << "\n";
  out_ << std::flush;
}

std::string TracePrinter::took(double sim_time, double wall_time) const {
  const std::string real = seconds(wall_time - action_wall_start_);
  if (!style_.simulated) return real;
  return seconds(sim_time - action_sim_start_) + "  " + paint("(" + real + " real)", Paint::kDim);
}

void TracePrinter::close_action(const coordinator::Report& report, double sim_time, double wall_time) {
  if (action_.empty()) return;
  const bool done = report.actions.size() > carried_out_;
  carried_out_ = report.actions.size();
  draw_action(done ? paint("✓", Paint::kGreen) : paint("✗", Paint::kRed), took(sim_time, wall_time), true);
  action_.clear();
}

void TracePrinter::on_status(const coordinator::Report& report, double sim_time, double wall_time) {
  if (report.finished && report.id != id_ && id_ != 0) {  // another instruction was refused meanwhile
    if (line_open_) out_ << "\n";
    line_open_ = false;
    out_ << "     " << paint("!", Paint::kYellow) << " refused \"" << report.instruction
         << "\": " << report.message << "\n";
    return;
  }
  id_ = report.id;
  const std::string current =
      report.current_action.name.empty() ? "" : goalnet::to_string(report.current_action);
  // Carried out means over, even if the status still names it while its effects are awaited.
  if (!action_.empty() && (current != action_ || report.actions.size() > carried_out_ || report.finished)) {
    close_action(report, sim_time, wall_time);
  }
  if (!report.goal.empty() && static_cast<std::int64_t>(report.step) != goal_step_) {
    goal_step_ = report.step;
    print_goal(report);
  }
  if (!report.finished && report.message != difference_) {
    difference_ = report.message;
    if (!difference_.empty())
      out_ << "     " << paint("!", Paint::kYellow) << " new plan: " << difference_ << "\n";
  }
  const bool acting = report.stage == coordinator::Stage::kActing;
  if (report.stage == coordinator::Stage::kPlanning) plan_.reset();
  if (acting && !plan_) {
    plan_ = report.plan;
    print_plan(report);
  }
  if (acting && !current.empty() && action_.empty() && report.actions.size() == carried_out_) {
    action_ = current;
    action_sim_start_ = sim_time;
    action_wall_start_ = wall_time;
    draw_action("▸", "", false);
  }
  out_ << std::flush;
}

void TracePrinter::on_stage(const std::string& stage, double progress, double sim_time, double wall_time) {
  if (action_.empty()) return;
  const double part = std::isfinite(progress) ? progress : 0.0;
  draw_action("▸", bar(part) + "  " + stage + "  " + took(sim_time, wall_time), false);
}

void TracePrinter::end(const coordinator::Report& report, const FactSet& added, const FactSet& removed,
                       double sim_time, double wall_time) {
  if (line_open_) out_ << "\n";
  line_open_ = false;
  const bool done = report.outcome == Outcome::kDone;
  std::string name(to_string(report.outcome));
  std::replace(name.begin(), name.end(), '_', ' ');
  out_ << "\n" << paint(name, done ? Paint::kGreen : Paint::kRed);
  if (!report.message.empty()) out_ << ": " << report.message;
  out_ << "\n";
  if (const std::string text = join(added); !text.empty()) out_ << "  now         " << text << "\n";
  if (const std::string text = join(removed); !text.empty()) out_ << "  no longer   " << text << "\n";
  const std::size_t count = report.actions.size();
  out_ << "  " << count << (count == 1 ? " action in " : " actions in ");
  if (style_.simulated) out_ << seconds(sim_time) << " of simulated time, ";
  out_ << seconds(wall_time) << (style_.simulated ? " of real time" : "");
  if (style_.simulated && wall_time > 0.0 && sim_time > 0.0) {
    char text[48];
    std::snprintf(text, sizeof text, " (%.1f times as fast)", sim_time / wall_time);
    out_ << text;
  }
  out_ << "\n" << std::flush;
}

}  // namespace goalnet::tools
