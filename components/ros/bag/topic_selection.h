// Which topics to record or play, as `ros2 bag` lets people say it.
#pragma once

#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::ros {

class TopicSelection {
 public:
  struct Options {
    std::vector<std::string> topics;  // these; a "/" in front may be left out
    std::string regex;                // and those in which this is found
    std::string exclude;              // but none in which this is found
    bool hidden = false;              // also names with a part that begins with "_"
  };
  // Neither topics nor regex: all. kInvalidRequest for a bad regular expression.
  static Expected<TopicSelection> create(const Options& options);

  bool selects(const std::string& topic) const;
  const std::vector<std::string>& topics() const { return topics_; }  // full names

 private:
  std::vector<std::string> topics_;
  std::optional<std::regex> regex_, exclude_;
  bool hidden_ = false;
};

}  // namespace goalnet::ros
