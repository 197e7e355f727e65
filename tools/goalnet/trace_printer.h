// The story of a run for a person at a terminal: one paragraph per step, one line per action.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "components/coordinator/port.h"
#include "tools/goalnet/run_record.h"

namespace goalnet::tools {

struct TraceStyle {
  bool colour = false;    // ANSI colours
  bool live = false;      // the line of the running action is redrawn in place; else printed when it is over
  bool simulated = true;  // there are two times to tell; else sim_time is left out
};

// Colours and redrawing where file descriptor `fd` is a terminal that can do it (NO_COLOR and TERM=dumb are
// respected).
TraceStyle style_for(int fd);

// Not thread-safe. Times are in seconds since the run began.
class TracePrinter {
 public:
  TracePrinter(std::ostream& out, TraceStyle style) : out_(out), style_(style) {}

  void begin(const RunLabel& label, const std::string& note);
  void on_status(const coordinator::Report& report, double sim_time, double wall_time);
  // From manipulation: what it does inside the current action.
  void on_stage(const std::string& stage, double progress, double sim_time, double wall_time);
  void end(const coordinator::Report& report, const FactSet& added, const FactSet& removed, double sim_time,
           double wall_time);

 private:
  enum class Paint { kPlain, kBold, kDim, kGreen, kRed, kYellow, kCyan };
  std::string paint(const std::string& text, Paint colour) const;
  void print_goal(const coordinator::Report& report);
  void print_plan(const coordinator::Report& report);
  std::string took(double sim_time, double wall_time) const;  // by the action that runs
  void draw_action(const std::string& mark, const std::string& right, bool final_line);
  void close_action(const coordinator::Report& report, double sim_time, double wall_time);

  std::ostream& out_;
  TraceStyle style_;
  std::uint64_t id_ = 0;
  std::int64_t goal_step_ = -1;              // the last step whose goal was printed
  std::optional<std::vector<Action>> plan_;  // printed for the goal under way
  std::string difference_;                   // the last reason printed for a new plan
  std::size_t carried_out_ = 0;
  std::string action_;  // the one that runs; empty: none
  double action_sim_start_ = 0.0;
  double action_wall_start_ = 0.0;
  bool line_open_ = false;
};

}  // namespace goalnet::tools
