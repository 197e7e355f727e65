#include "components/ros/detail/written_topics.h"

namespace goalnet::ros::detail {

void WrittenTopics::note(const std::string& topic, const Gid& writer, TopicWriter what) {
  constexpr std::size_t kMostWriters = 20'000;  // what hostile peers can make us remember
  std::lock_guard lock(mutex_);
  if (count_ >= kMostWriters) return;
  if (topics_[topic].insert_or_assign(writer, std::move(what)).second) ++count_;
}

void WrittenTopics::forget(const std::string& topic, const Gid& writer) {
  std::lock_guard lock(mutex_);
  const auto found = topics_.find(topic);
  if (found == topics_.end() || found->second.erase(writer) == 0) return;
  --count_;
  if (found->second.empty()) topics_.erase(found);
}

TopicWriters WrittenTopics::snapshot() const {
  std::lock_guard lock(mutex_);
  return topics_;
}

void WrittenTopics::on_local_writer(std::function<void()> callback) {
  std::lock_guard lock(mutex_);
  on_local_writer_ = std::move(callback);
}

void WrittenTopics::local_writer_made() const {
  std::function<void()> callback;
  {
    std::lock_guard lock(mutex_);
    callback = on_local_writer_;
  }
  if (callback) callback();
}

}  // namespace goalnet::ros::detail
