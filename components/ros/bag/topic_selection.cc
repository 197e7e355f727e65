#include "components/ros/bag/topic_selection.h"

#include <algorithm>

namespace goalnet::ros {
namespace {

Expected<std::optional<std::regex>> compile(const std::string& text) {
  if (text.empty()) return std::optional<std::regex>();
  try {
    return std::optional(std::regex(text));
  } catch (const std::regex_error& error) {
    return fail(Outcome::kInvalidRequest,
                "\"" + text.substr(0, 80) + "\" is no regular expression: " + error.what());
  }
}

}  // namespace

Expected<TopicSelection> TopicSelection::create(const Options& options) {
  TopicSelection selection;
  selection.topics_ = options.topics;
  for (std::string& topic : selection.topics_) {
    if (!topic.starts_with("/")) topic.insert(0, "/");
  }
  auto regex = compile(options.regex), exclude = compile(options.exclude);
  if (!regex) return tl::unexpected<Error>(std::move(regex.error()));
  if (!exclude) return tl::unexpected<Error>(std::move(exclude.error()));
  selection.regex_ = std::move(*regex);
  selection.exclude_ = std::move(*exclude);
  selection.hidden_ = options.hidden;
  return selection;
}

bool TopicSelection::selects(const std::string& topic) const {
  if (exclude_ && std::regex_search(topic, *exclude_)) return false;
  if (std::find(topics_.begin(), topics_.end(), topic) != topics_.end()) return true;
  if (!hidden_ && topic.find("/_") != std::string::npos) return false;
  if (regex_) return std::regex_search(topic, *regex_);
  return topics_.empty();
}

}  // namespace goalnet::ros
