// A bare Fast DDS participant that notes every endpoint it discovers, as ROS 2 tools see it.
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "components/ros/endpoint.h"

namespace goalnet::ros {

struct SeenEndpoint {
  Gid gid{};
  bool is_writer = false;
  std::string topic, type;
  bool reliable = false;
  bool transient_local = false;
  double lifespan = 0;  // [s]; 0: without end
  std::string user_data;

  // As *_endpoints_table.txt has it, single spaces between the columns.
  std::string row() const;
  // Without entity id and history, and of USER_DATA only the type hash: what must be equal across vendors.
  std::string vendor_free_row() const;
};

// The same of a row of the table. Cyclone leaves QoS that have DDS's default value out.
std::string vendor_free_row(const std::string& table_row);

class EndpointWatcher : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  explicit EndpointWatcher(int domain);
  ~EndpointWatcher() override;

  // Endpoints of one participant, by entity id. Waits until there are `count`, at most five seconds.
  std::vector<SeenEndpoint> endpoints_of(const Gid& any_endpoint, std::size_t count) const;
  // Readers of all participants but that of `own`, now.
  std::vector<SeenEndpoint> readers_of_others(const Gid& own) const;
  // Endpoints on a topic now.
  std::size_t count_on(const std::string& topic) const;

 private:
  using Participant = eprosima::fastdds::dds::DomainParticipant;
  void on_publisher_discovery(Participant*, eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  void on_subscriber_discovery(Participant*, eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
  template <class Info>
  void note(const Info& info, bool is_writer, bool gone);

  mutable std::mutex mutex_;
  std::map<Gid, SeenEndpoint> seen_;
  Participant* participant_ = nullptr;
};

}  // namespace goalnet::ros
