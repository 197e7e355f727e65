#include "tools/goalnet/launch/launcher.h"

#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

namespace goalnet::tools {
namespace {

// How soon the end of a process and the wish to stop are noticed. Output is handed on at once.
constexpr int kLookEvery = 20;  // [ms]

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Watched {
  explicit Watched(const LaunchedProcess& the_plan) : plan(the_plan), policy(the_plan.restart) {}
  const LaunchedProcess& plan;
  RestartPolicy policy;
  std::optional<ChildProcess> child;
  std::optional<double> start_at;  // waits to be started (again)
  double started = 0.0;            // [s]
  bool silent = false;             // and killed for it
};

class Launcher {
 public:
  Launcher(const LaunchPlan& plan, const LaunchCallbacks& callbacks) : plan_(plan), callbacks_(callbacks) {
    for (const LaunchedProcess& process : plan.processes) watched_.emplace_back(process);
  }

  Expected<void> run() {
    for (Watched& one : watched_) one.start_at = now();
    while (!lost_ && !callbacks_.stop_asked() && anything_to_do()) {
      for (Watched& one : watched_) look_after(one);
      wait(kLookEvery);
    }
    for (auto one = watched_.rbegin(); one != watched_.rend(); ++one) stop(*one);
    if (lost_) return tl::unexpected<Error>(*lost_);
    return {};
  }

 private:
  bool anything_to_do() const {
    return std::any_of(watched_.begin(), watched_.end(),
                       [](const Watched& one) { return one.child || one.start_at; });
  }

  void look_after(Watched& one) {
    hand_on_output(one, false);
    if (one.child) {
      if (const auto code = one.child->exit_code()) return ended(one, *code);
      listen(one);
    } else if (one.start_at && now() >= *one.start_at) {
      start(one);
    }
  }

  // What hangs, or was stopped, does not hear SIGTERM either.
  void listen(Watched& one) {
    const double most = one.plan.restart.silent_after;
    if (most <= 0.0 || one.plan.node.empty() || one.silent || !callbacks_.last_sign) return;
    // Only who has answered since it was started can fall silent: it may be loading, or not to be found on this network.
    const double last = callbacks_.last_sign(one.plan.node);
    const double silence = now() - last;
    if (last < one.started) return;
    if (silence <= most) return;
    one.silent = true;
    char text[64];
    std::snprintf(text, sizeof text, "no sign of life for %.1f s", silence);
    tell({LaunchEvent::Kind::kSilent, one.plan.name, one.child->pid(), 0, 0.0, text});
    one.child->signal(SIGKILL);
  }

  void start(Watched& one) {
    one.start_at.reset();
    one.started = now();
    one.silent = false;
    auto child = ChildProcess::start(one.plan.command, one.plan.environment);
    if (!child) return give_up(one, child.error().message);
    one.child.emplace(std::move(*child));
    tell({LaunchEvent::Kind::kStarted, one.plan.name, one.child->pid()});
  }

  void ended(Watched& one, int code) {
    hand_on_output(one, true);
    one.child.reset();
    tell({LaunchEvent::Kind::kEnded, one.plan.name, 0, code});
    const auto decision = one.policy.ended(code != 0, now());
    switch (decision.kind) {
      case RestartPolicy::Decision::Kind::kStayEnded:
        return;
      case RestartPolicy::Decision::Kind::kRestart:
        one.start_at = decision.at;
        return tell({LaunchEvent::Kind::kRestarting, one.plan.name, 0, 0, decision.at - now()});
      case RestartPolicy::Decision::Kind::kGiveUp:
        return give_up(one, code >= 128 ? "ended by signal " + std::to_string(code - 128)
                                        : "ended with code " + std::to_string(code));
    }
  }

  void give_up(const Watched& one, const std::string& why) {
    tell({LaunchEvent::Kind::kGivenUp, one.plan.name, 0, 0, 0.0, why});
    if (one.plan.required && !lost_)
      lost_ = Error{Outcome::kComponentLost, one.plan.name + " is lost: " + why};
  }

  void stop(Watched& one) {
    one.start_at.reset();
    if (!one.child) return;
    tell({LaunchEvent::Kind::kStopping, one.plan.name, one.child->pid()});
    one.child->signal(SIGTERM);
    const double patience_ends = now() + plan_.patience;
    bool killed = false;
    std::optional<int> code;
    while (!(code = one.child->exit_code())) {
      if (!killed && now() > patience_ends) {
        killed = true;
        tell({LaunchEvent::Kind::kKilled, one.plan.name, one.child->pid()});
        one.child->signal(SIGKILL);
      }
      wait(2);
      for (Watched& other : watched_) hand_on_output(other, false);
    }
    hand_on_output(one, true);
    one.child.reset();
    tell({LaunchEvent::Kind::kEnded, one.plan.name, 0, *code});
  }

  void hand_on_output(Watched& one, bool rest) {
    if (!one.child) return;
    one.child->read_lines(
        [&](const std::string& line, bool error) { callbacks_.on_line(one.plan.name, line, error); }, rest);
  }

  void wait(int milliseconds) const {
    std::vector<pollfd> ends;
    for (const Watched& one : watched_) {
      if (!one.child) continue;
      for (const int fd : {one.child->out(), one.child->err()}) {
        if (fd >= 0) ends.push_back({fd, POLLIN, 0});
      }
    }
    poll(ends.data(), ends.size(), milliseconds);
  }

  void tell(const LaunchEvent& event) const { callbacks_.on_event(event); }

  const LaunchPlan& plan_;
  const LaunchCallbacks& callbacks_;
  std::vector<Watched> watched_;
  std::optional<Error> lost_;
};

}  // namespace

const char* to_string(LaunchEvent::Kind kind) {
  switch (kind) {
    case LaunchEvent::Kind::kStarted:
      return "started";
    case LaunchEvent::Kind::kSilent:
      return "silent";
    case LaunchEvent::Kind::kEnded:
      return "ended";
    case LaunchEvent::Kind::kRestarting:
      return "restarting";
    case LaunchEvent::Kind::kGivenUp:
      return "given_up";
    case LaunchEvent::Kind::kStopping:
      return "stopping";
    case LaunchEvent::Kind::kKilled:
      return "killed";
  }
  return "";
}

Expected<void> launch(const LaunchPlan& plan, const LaunchCallbacks& callbacks) {
  return Launcher(plan, callbacks).run();
}

}  // namespace goalnet::tools
