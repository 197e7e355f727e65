// Who writes what, here and elsewhere: what a recorder needs to know to subscribe to anything.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "components/ros/endpoint.h"
#include "components/ros/qos.h"

namespace goalnet::ros::detail {

struct TopicWriter {
  std::string dds_type;
  std::string type_hash;  // as announced; "" where the writer does not (Humble)
  OfferedQos offered;
};

// By DDS topic name, then by writer.
using TopicWriters = std::map<std::string, std::map<Gid, TopicWriter>>;

// Thread-safe. Bounded: what comes beyond is not remembered.
class WrittenTopics {
 public:
  void note(const std::string& topic, const Gid& writer, TopicWriter what);
  void forget(const std::string& topic, const Gid& writer);
  TopicWriters snapshot() const;

  // Called after a writer of this process was made, in its thread, before it writes anything: who subscribes
  // then misses nothing. One at a time; an empty function ends it.
  void on_local_writer(std::function<void()> callback);
  void local_writer_made() const;

 private:
  mutable std::mutex mutex_;
  std::function<void()> on_local_writer_;
  TopicWriters topics_;
  std::size_t count_ = 0;
};

}  // namespace goalnet::ros::detail
