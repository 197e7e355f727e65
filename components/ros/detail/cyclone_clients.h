// Which reply reader belongs to which request writer, as clients of rmw_cyclonedds say in their USER_DATA:
// both carry the same "clientid=...;". (Clients of rmw_fastrtps name their reader in each request.)
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "components/ros/endpoint.h"

namespace goalnet::ros::detail {

// Thread-safe. Bounded: what comes beyond is not remembered.
class CycloneClients {
 public:
  // As endpoints are discovered; `client` is "" where the endpoint says nothing.
  void note_writer(const Gid& writer, const std::string& topic, const std::string& client);
  void note_reader(const Gid& reader, const std::string& topic, const std::string& client);
  void forget(const Gid& endpoint);

  // May this writer's request be answered, going by `matched`: is its client's reply reader matched? True for
  // a writer that does not say whose it is: then nothing can be waited for.
  bool can_be_answered(const Gid& writer, const std::function<bool(const Gid& reader)>& matched) const;

 private:
  void note(std::map<Gid, std::string>& where, const Gid& gid, const std::string& client);

  mutable std::mutex mutex_;
  std::map<Gid, std::string> writers_, readers_;  // by endpoint: service and client
};

}  // namespace goalnet::ros::detail
