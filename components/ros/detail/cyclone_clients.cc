#include "components/ros/detail/cyclone_clients.h"

#include <algorithm>
#include <string_view>

namespace goalnet::ros::detail {
namespace {

// The service of a topic rq/SERVICERequest or rr/SERVICEReply; "" for any other topic.
std::string_view service_of(std::string_view topic, std::string_view prefix, std::string_view suffix) {
  if (!topic.starts_with(prefix) || !topic.ends_with(suffix)) return "";
  return topic.substr(prefix.size(), topic.size() - prefix.size() - suffix.size());
}

}  // namespace

void CycloneClients::note_writer(const Gid& writer, const std::string& topic, const std::string& client) {
  const auto service = service_of(topic, "rq/", "Request");
  if (!service.empty() && !client.empty()) note(writers_, writer, client + " " + std::string(service));
}

void CycloneClients::note_reader(const Gid& reader, const std::string& topic, const std::string& client) {
  const auto service = service_of(topic, "rr/", "Reply");
  if (!service.empty() && !client.empty()) note(readers_, reader, client + " " + std::string(service));
}

void CycloneClients::note(std::map<Gid, std::string>& where, const Gid& gid, const std::string& client) {
  constexpr std::size_t kMostEndpoints = 10'000;  // what hostile peers can make us remember
  std::lock_guard lock(mutex_);
  if (where.size() < kMostEndpoints) where.insert_or_assign(gid, client);
}

void CycloneClients::forget(const Gid& endpoint) {
  std::lock_guard lock(mutex_);
  writers_.erase(endpoint);
  readers_.erase(endpoint);
}

bool CycloneClients::can_be_answered(const Gid& writer,
                                     const std::function<bool(const Gid& reader)>& matched) const {
  std::lock_guard lock(mutex_);
  const auto client = writers_.find(writer);
  if (client == writers_.end()) return true;
  return std::any_of(readers_.begin(), readers_.end(), [&](const auto& reader) {
    return reader.second == client->second && matched(reader.first);
  });
}

}  // namespace goalnet::ros::detail
