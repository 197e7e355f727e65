#include "components/ros/log_limit.h"

#include <fmt/format.h>

namespace goalnet::ros {

std::optional<std::string> LogLimit::pass(Time now) {
  const std::lock_guard lock(mutex_);
  std::string more;
  if (now - begin_ >= kPeriod) {
    if (left_out_ > 0) {
      more = fmt::format(" ({} more in the last {:.1f} s)", left_out_,
                         std::chrono::duration<double>(now - begin_).count());
    }
    begin_ = now;
    written_ = 0;
    left_out_ = 0;
  }
  if (written_ < kLines) {
    ++written_;
    return more;
  }
  ++left_out_;
  ++left_out_in_all_;
  return std::nullopt;
}

std::uint64_t LogLimit::left_out() const {
  const std::lock_guard lock(mutex_);
  return left_out_in_all_;
}

}  // namespace goalnet::ros
