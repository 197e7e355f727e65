#include "tools/goalnet/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace goalnet::tools {

ProgressLine::ProgressLine(std::chrono::milliseconds pause_elsewhere)
    : terminal_(isatty(STDERR_FILENO) != 0),
      pause_(terminal_ ? std::chrono::milliseconds(200) : pause_elsewhere) {}

void ProgressLine::show(double done, const std::string& measured) {
  const auto now = std::chrono::steady_clock::now();
  if (done < 1 && now - shown_ < pause_) return;
  shown_ = now;
  if (first_share_ < 0) first_share_ = done;
  const double gained = done - first_share_;  // after a resume the first report starts far from 0
  std::string left = "--:--";
  if (gained > 0) {
    const int rest = static_cast<int>(seconds() / gained * (1 - done));
    left = std::to_string(rest / 60) + ":" + (rest % 60 < 10 ? "0" : "") + std::to_string(rest % 60);
  }
  std::fprintf(stderr, "%s%3d %%  %s left  %s%s", terminal_ ? "\r" : "", static_cast<int>(done * 100),
               left.c_str(), measured.c_str(), terminal_ ? "\x1b[K" : "\n");
  std::fflush(stderr);
}

void ProgressLine::finish() const {
  if (terminal_) std::fputc('\n', stderr);
}

double ProgressLine::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

}  // namespace goalnet::tools
