// The DDS participant behind a Context: transports, types, topics and the ROS graph.
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/context.h"
#include "components/ros/detail/cyclone_clients.h"
#include "components/ros/detail/graph.h"
#include "components/ros/detail/graph_peers.h"
#include "components/ros/detail/queued_changes.h"
#include "components/ros/detail/user_data.h"
#include "components/ros/detail/written_topics.h"
#include "components/ros/endpoint.h"
#include "components/ros/logger.h"

namespace goalnet::ros::detail {

// Where and how a participant talks, after options and environment.
struct ParticipantSettings {
  int domain_id = 0;
  std::string enclave = "/";
  Distro distro = Distro::kJazzy;
  // kLoopback: the loopback interface alone, multicast included, as ROS_LOCALHOST_ONLY means it in Humble.
  enum class Range { kOff, kLoopback, kLocalhost, kSubnet, kSystemDefault } range = Range::kSubnet;
  bool process_only = false;
  bool shared_memory = false;
  std::string static_peers;      // host;host
  std::string discovery_server;  // host:port;host:port
};

// Options completed from the environment. kInvalidRequest names the variable that makes no sense.
Expected<ParticipantSettings> read_settings(const ContextOptions& options);

// How such a participant is set up in Fast DDS, on top of the user's XML profile.
eprosima::fastdds::dds::DomainParticipantQos participant_qos(const ParticipantSettings& settings);

// Thread-safe.
class Participant : public std::enable_shared_from_this<Participant> {
 public:
  static Expected<std::shared_ptr<Participant>> create(const ParticipantSettings& settings);
  ~Participant();

  const ParticipantSettings& settings() const { return settings_; }
  Gid gid() const;
  eprosima::fastdds::dds::Publisher& publisher() { return *publisher_; }
  eprosima::fastdds::dds::Subscriber& subscriber() { return *subscriber_; }

  // A topic with its type registered; give it back with release_topic(). Fails if the topic has another type.
  Expected<eprosima::fastdds::dds::Topic*> acquire_topic(const std::string& name,
                                                         const std::string& dds_type);
  void release_topic(const std::string& name);

  // The ROS graph. Each call publishes ros_discovery_info again.
  void add_node(const std::string& node_namespace, const std::string& name);
  void remove_node(const std::string& full_name);
  void add_endpoint(const std::string& node_full_name, const Gid& gid, bool is_writer);
  void remove_endpoint(const Gid& gid);
  Graph graph() const;
  // Nodes of other participants, as their ros_discovery_info has it: full names, sorted.
  std::vector<std::string> other_nodes() const { return peers_.names(); }

  // Who writes what, of this process and of others.
  WrittenTopics& written() { return written_; }
  CycloneClients& cyclone_clients() { return cyclone_clients_; }

 private:
  // Hears of endpoints elsewhere, and of participants that leave.
  struct DiscoveryListener : eprosima::fastdds::dds::DomainParticipantListener {
    explicit DiscoveryListener(Participant& owner) : participant(owner) {}
    void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant*,
                                  eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
    void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant*,
                                eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
    void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant*,
                                 eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
    Participant& participant;
  };

  // Hears what other participants say about their nodes.
  struct GraphListener : eprosima::fastdds::dds::DataReaderListener {
    explicit GraphListener(Participant& owner) : participant(owner) {}
    void on_data_available(eprosima::fastdds::dds::DataReader* reader) override;
    Participant& participant;
  };

  explicit Participant(const ParticipantSettings& settings) : settings_(settings), peers_(settings.distro) {}
  Expected<void> open_graph();
  // Warns, once a type, where somebody has another definition of a type of ours.
  void check_type_hash(const std::string& dds_type, std::span<const std::uint8_t> user_data);
  void publish_graph();

  struct SharedTopic {
    eprosima::fastdds::dds::Topic* topic = nullptr;
    std::string dds_type;
    int users = 0;
  };

  const ParticipantSettings settings_;
  GraphPeers peers_;
  GraphListener graph_listener_{*this};
  Logger log_{"ros_graph"};
  std::vector<std::unique_ptr<QueuedChanges>> queued_changes_;  // of discovery's own writers
  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
  mutable std::mutex mutex_;
  DiscoveryListener listener_{*this};
  WrittenTopics written_;
  CycloneClients cyclone_clients_;
  std::mutex foreign_types_mutex_;
  std::set<std::string> foreign_types_;  // of ours, that were announced with another hash
  std::map<std::string, SharedTopic> topics_;
  std::unique_ptr<Graph> graph_;
  eprosima::fastdds::dds::DataWriter* graph_writer_ = nullptr;
  eprosima::fastdds::dds::DataReader* graph_reader_ = nullptr;
};

Gid to_gid(const eprosima::fastrtps::rtps::GUID_t& guid);
eprosima::fastrtps::rtps::GUID_t to_guid(const Gid& gid);

// QoS of ROS endpoints in Fast DDS terms; data sharing off.
eprosima::fastdds::dds::DataWriterQos writer_qos(
    const Qos& qos, const std::string& user_data,
    std::chrono::milliseconds heartbeat = EndpointOptions().heartbeat);
eprosima::fastdds::dds::DataReaderQos reader_qos(const Qos& qos, const std::string& user_data);

// What a discovered writer offers.
OfferedQos offered_qos(const eprosima::fastdds::dds::WriterQos& qos);

}  // namespace goalnet::ros::detail
