#include "tests/support/endpoint_watcher.h"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include <sstream>
#include <thread>

#include "components/ros/detail/participant.h"

namespace goalnet::ros {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

std::string SeenEndpoint::row() const {
  char entity[9];
  std::snprintf(entity, sizeof entity, "%02x%02x%02x%02x", gid[12], gid[13], gid[14], gid[15]);
  std::ostringstream out;
  out << entity << (is_writer ? " WRITER " : " READER ") << topic << " " << type
      << (reliable ? " RELIABLE" : " BEST_EFFORT") << (transient_local ? " TRANSIENT_LOCAL" : " VOLATILE");
  if (lifespan > 0) out << " LIFESPAN=" << lifespan << "s+0/2^32 (" << lifespan << "s)";
  out << " USER_DATA=b'" << user_data << "' (" << user_data.size() << " bytes)";
  return out.str();
}

std::string SeenEndpoint::vendor_free_row() const { return ros::vendor_free_row(row()); }

std::string vendor_free_row(const std::string& table_row) {
  std::istringstream words(table_row);
  std::string entity, kind, topic, type, reliability, durability, out;
  words >> entity >> kind >> topic >> type >> reliability >> durability;
  if (reliability == "(default)") reliability = kind == "WRITER" ? "RELIABLE" : "BEST_EFFORT";
  if (durability == "(default)") durability = "VOLATILE";
  out = kind + " " + topic + " " + type + " " + reliability + " " + durability;
  for (std::string word; words >> word;) {
    if (word.starts_with("LIFESPAN=")) out += " " + word;
  }
  const auto hash = table_row.find("typehash=");
  if (hash != std::string::npos) out += " " + table_row.substr(hash, table_row.find(';', hash) - hash);
  return out;
}

EndpointWatcher::EndpointWatcher(int domain) {
  participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
      domain, dds::PARTICIPANT_QOS_DEFAULT, this, dds::StatusMask::none());
}

EndpointWatcher::~EndpointWatcher() {
  participant_->set_listener(nullptr);
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

template <class Info>
void EndpointWatcher::note(const Info& info, bool is_writer, bool gone) {
  SeenEndpoint one;
  one.gid = detail::to_gid(info.guid());
  one.is_writer = is_writer;
  one.topic = info.topicName().to_string();
  one.type = info.typeName().to_string();
  one.reliable = info.m_qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  one.transient_local = info.m_qos.m_durability.kind == dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  if (info.m_qos.m_lifespan.duration != eprosima::fastrtps::c_TimeInfinite) {
    one.lifespan = static_cast<double>(info.m_qos.m_lifespan.duration.to_ns()) / 1e9;
  }
  one.user_data.assign(info.m_qos.m_userData.begin(), info.m_qos.m_userData.end());
  std::lock_guard lock(mutex_);
  seen_.erase(one.gid);
  if (!gone) seen_[one.gid] = one;
}

void EndpointWatcher::on_publisher_discovery(Participant*, rtps::WriterDiscoveryInfo&& info) {
  note(info.info, true, info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER);
}

void EndpointWatcher::on_subscriber_discovery(Participant*, rtps::ReaderDiscoveryInfo&& info) {
  note(info.info, false, info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER);
}

std::vector<SeenEndpoint> EndpointWatcher::endpoints_of(const Gid& any_endpoint, std::size_t count) const {
  std::vector<SeenEndpoint> found;
  for (int i = 0; i < 500 && found.size() < count; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    found.clear();
    std::lock_guard lock(mutex_);
    for (const auto& [gid, one] : seen_) {
      if (std::equal(gid.begin(), gid.begin() + 12, any_endpoint.begin())) found.push_back(one);
    }
  }
  return found;
}

std::vector<SeenEndpoint> EndpointWatcher::readers_of_others(const Gid& own) const {
  std::vector<SeenEndpoint> found;
  std::lock_guard lock(mutex_);
  for (const auto& [gid, one] : seen_) {
    if (!one.is_writer && !std::equal(gid.begin(), gid.begin() + 12, own.begin())) found.push_back(one);
  }
  return found;
}

std::size_t EndpointWatcher::count_on(const std::string& topic) const {
  std::lock_guard lock(mutex_);
  std::size_t count = 0;
  for (const auto& [gid, one] : seen_) count += one.topic == topic;
  return count;
}

}  // namespace goalnet::ros
