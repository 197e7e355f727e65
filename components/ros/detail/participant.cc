#include "components/ros/detail/participant.h"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include <algorithm>
#include <cstdlib>

#include "components/ros/detail/held_reception.h"
#include "components/ros/detail/lease_checks.h"
#include "components/ros/detail/local_writer.h"
#include "components/ros/detail/message_type.h"
#include "components/ros/names.h"

namespace goalnet::ros::detail {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::types::ReturnCode_t;
using Range = ParticipantSettings::Range;

constexpr const char* kGraphTopic = "ros_discovery_info";
constexpr const char* kGraphType = "rmw_dds_common/msg/ParticipantEntitiesInfo";

rtps::Locator_t udp_locator(const std::string& host, std::uint32_t port) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = port;
  rtps::IPLocator::setIPv4(locator, host);
  return locator;
}

// Where everybody of a domain listens. With port 0 Fast DDS 2.9 would try the ports of single participants
// there.
rtps::Locator_t multicast_locator(int domain_id) {
  return udp_locator("239.255.0.1",
                     rtps::PortParameters().getMulticastPort(static_cast<std::uint32_t>(domain_id)));
}

// Host names are looked up; one that cannot be found is left out, so that a robot starts while a laptop is
// away.
void add_static_peers(const std::string& peers, rtps::LocatorList_t& list) {
  std::size_t at = 0;
  while (at < peers.size()) {
    const auto end = std::min(peers.find(';', at), peers.size());
    const std::string host = peers.substr(at, end - at);
    at = end + 1;
    if (host.empty()) continue;
    const auto addresses = rtps::IPLocator::resolveNameDNS(host);
    for (const auto& address : addresses.first) list.push_back(udp_locator(address, 0));
    if (addresses.first.empty())
      Logger("ros_graph").warn("ROS_STATIC_PEERS: '{}' cannot be looked up and is left out", host);
  }
}

void set_discovery(const ParticipantSettings& settings, dds::DomainParticipantQos& qos) {
  auto& builtin = qos.wire_protocol().builtin;
  // The default announces once in three seconds after the first moment: matching then takes 3 s now and then.
  builtin.discovery_config.initial_announcements.count = 40;
  builtin.discovery_config.initial_announcements.period = eprosima::fastrtps::Duration_t(0, 50'000'000);
  builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  if (settings.process_only) {
    builtin.discovery_config.ignoreParticipantFlags = static_cast<rtps::ParticipantFilteringFlags_t>(
        rtps::ParticipantFilteringFlags::FILTER_DIFFERENT_HOST |
        rtps::ParticipantFilteringFlags::FILTER_DIFFERENT_PROCESS);
  }
  if (settings.range == Range::kLocalhost || settings.range == Range::kOff) {
    // An empty locator means: the usual unicast port, and no multicast.
    builtin.metatrafficUnicastLocatorList.push_back(rtps::Locator_t());
  }
  if (settings.range == Range::kLocalhost) builtin.initialPeersList.push_back(udp_locator("127.0.0.1", 0));
  if (settings.range == Range::kLoopback) {
    // Participants on Fast DDS hear the multicast address; those on Cyclone DDS use none on the loopback
    // interface, and would find us when they announce themselves again, up to half a minute later.
    builtin.initialPeersList.push_back(multicast_locator(settings.domain_id));
    builtin.initialPeersList.push_back(udp_locator("127.0.0.1", 0));
  }
  if (settings.range == Range::kSubnet && !settings.static_peers.empty()) {
    builtin.initialPeersList.push_back(multicast_locator(settings.domain_id));
  }
  if (settings.range != Range::kSystemDefault)
    add_static_peers(settings.static_peers, builtin.initialPeersList);
}

// Peers without a port are tried on the ports of this many participants per host.
constexpr std::uint32_t kPeersPerHost = 32;

constexpr std::uint32_t kReceiveBuffer = 1 << 20;

// What the user's XML names; else UDP only, unless shared memory is asked for: a peer that is killed leaves
// its shared-memory port behind, and a new one on that port is not heard for seconds, sometimes never
// (docs/design/020-udp-only.md).
void set_transports(const ParticipantSettings& settings, dds::DomainParticipantQos& qos) {
  if (!qos.transport().user_transports.empty()) return;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  // The kernel gives no more than net.core.rmem_max. Where many participants start at once on few processors
  // a socket's default buffer overflows.
  udp->receiveBufferSize = kReceiveBuffer;
  if (settings.range == Range::kLoopback) udp->interfaceWhiteList.emplace_back("127.0.0.1");
  auto shared_memory = std::make_shared<eprosima::fastdds::rtps::SharedMemTransportDescriptor>();
  if (settings.range == Range::kLocalhost || settings.range == Range::kLoopback ||
      !settings.static_peers.empty()) {
    udp->maxInitialPeersRange = kPeersPerHost;
    shared_memory->maxInitialPeersRange = kPeersPerHost;
  }
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {udp};
  if (settings.shared_memory) qos.transport().user_transports.push_back(shared_memory);
}

// The default participant of the XML file of profiles that the environment names, as for every node on
// rmw_fastrtps; Fast DDS's defaults where there is none.
dds::DomainParticipantQos profile_of_user() {
  // Fast DDS 2.12 has renamed the variable. Both are read once in a process.
  if (const char* file = std::getenv("FASTDDS_DEFAULT_PROFILES_FILE"))
    setenv("FASTRTPS_DEFAULT_PROFILES_FILE", file, 0);
  auto* factory = dds::DomainParticipantFactory::get_instance();
  factory->load_profiles();
  return factory->get_default_participant_qos();
}

// Of the writers that tell of our endpoints: once everybody knows that one is gone they forget it.
std::vector<std::unique_ptr<QueuedChanges>> keep_queued_changes(const rtps::GUID_t& participant) {
  std::vector<std::unique_ptr<QueuedChanges>> kept;
  for (const rtps::EntityId_t& writer : {rtps::c_EntityId_SEDPPubWriter, rtps::c_EntityId_SEDPSubWriter})
    kept.push_back(QueuedChanges::keep({participant.guidPrefix, writer}));
  return kept;
}

}  // namespace

dds::DomainParticipantQos participant_qos(const ParticipantSettings& settings) {
  dds::DomainParticipantQos qos = profile_of_user();
  qos.name(settings.enclave);
  std::string user_data = "enclave=" + settings.enclave + ";";
  user_data.push_back('\0');
  qos.user_data().data_vec({user_data.begin(), user_data.end()});
  set_discovery(settings, qos);
  set_transports(settings, qos);
  // Data goes to each peer by unicast, never to a multicast address that its endpoints announce. Where
  // several Cyclone DDS peers announce one multicast address, Fast DDS 2.9 opens that one only, then answers
  // a single peer by unicast and aborts, because that address was never opened
  // (tests/interoperability/abort_test.cc).
  qos.allocation().locators.max_multicast_locators = 0;
  return qos;
}

Expected<std::shared_ptr<Participant>> Participant::create(const ParticipantSettings& settings) {
  std::shared_ptr<Participant> self(new Participant(settings));
  if (!lease_checks_are_ours())
    self->log_.warn(
        "Fast DDS checks leases itself here and may end this process when another one leaves "
        "(docs/design/076): link components/ros into the program, not into a library it loads");
  dds::DomainParticipantQos qos = participant_qos(settings);
  const auto reception = hold_reception(qos);
  self->participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
      settings.domain_id, qos, &self->listener_, dds::StatusMask::none());
  if (self->participant_ != nullptr) {
    self->queued_changes_ = keep_queued_changes(self->participant_->guid());
    tell_of_endpoints_again_soon(self->participant_->guid());
  }
  reception->open();
  if (self->participant_ == nullptr) {
    return fail(Outcome::kInternal, "Fast DDS cannot make a participant on domain " +
                                        std::to_string(settings.domain_id) +
                                        "; is a network interface up, and /dev/shm writable?");
  }
  self->publisher_ = self->participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  self->subscriber_ = self->participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  if (self->publisher_ == nullptr || self->subscriber_ == nullptr) {
    return fail(Outcome::kInternal, "Fast DDS cannot make a publisher and a subscriber");
  }
  if (auto opened = self->open_graph(); !opened) return tl::unexpected(opened.error());
  return self;
}

Participant::~Participant() {
  if (participant_ == nullptr) return;
  std::size_t dropped = 0;
  if (graph_writer_ != nullptr) graph_writer_->clear_history(&dropped);  // as in ~Writer
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

Expected<dds::Topic*> Participant::acquire_topic(const std::string& name, const std::string& dds_type) {
  std::lock_guard lock(mutex_);
  SharedTopic& shared = topics_[name];
  if (shared.topic != nullptr) {
    if (shared.dds_type != dds_type) {
      return fail(Outcome::kInvalidRequest,
                  "topic " + name + " has the type " + shared.dds_type + " already, not " + dds_type);
    }
    ++shared.users;
    return shared.topic;
  }
  dds::TypeSupport type(new MessageType(dds_type));
  if (participant_->find_type(dds_type).empty()) type.register_type(participant_);
  shared.topic = participant_->create_topic(name, dds_type, dds::TOPIC_QOS_DEFAULT);
  if (shared.topic == nullptr) {
    topics_.erase(name);
    return fail(Outcome::kInternal, "Fast DDS cannot make the topic " + name + " of type " + dds_type);
  }
  shared.dds_type = dds_type;
  shared.users = 1;
  return shared.topic;
}

void Participant::release_topic(const std::string& name) {
  std::lock_guard lock(mutex_);
  const auto found = topics_.find(name);
  if (found == topics_.end() || --found->second.users > 0) return;
  participant_->delete_topic(found->second.topic);
  topics_.erase(found);
}

Expected<void> Participant::open_graph() {
  graph_ = std::make_unique<Graph>(to_gid(participant_->guid()));
  auto topic = acquire_topic(kGraphTopic, idl::dds_type_name(kGraphType));
  if (!topic) return tl::unexpected(topic.error());
  const std::string user_data = endpoint_user_data(settings_.distro, idl::find_type(kGraphType)->hash);
  graph_writer_ = publisher_->create_datawriter(*topic, writer_qos(Qos::latched(), user_data));
  if (graph_writer_ == nullptr) return fail(Outcome::kInternal, "Fast DDS cannot write ros_discovery_info");
  Qos qos = Qos::latched();
  qos.keep_all = true;  // as rmw reads it: one message of each participant counts
  graph_reader_ = subscriber_->create_datareader(*topic, reader_qos(qos, user_data), &graph_listener_,
                                                 dds::StatusMask::data_available());
  if (graph_reader_ == nullptr) return fail(Outcome::kInternal, "Fast DDS cannot read ros_discovery_info");
  return {};
}

void Participant::publish_graph() {
  // Called with mutex_ held, so that the last message written is the newest.
  const std::vector<std::uint8_t> payload = graph_->encode(settings_.distro);
  Outgoing out;
  out.payload = payload;
  graph_writer_->write(&out);
}

void Participant::add_node(const std::string& node_namespace, const std::string& name) {
  std::lock_guard lock(mutex_);
  peers_.add_own(full_name(node_namespace, name));
  graph_->add_node(node_namespace, name);
  publish_graph();
}

void Participant::remove_node(const std::string& full_name) {
  std::lock_guard lock(mutex_);
  peers_.remove_own(full_name);
  graph_->remove_node(full_name);
  publish_graph();
}

void Participant::add_endpoint(const std::string& node_full_name, const Gid& gid, bool is_writer) {
  std::lock_guard lock(mutex_);
  if (graph_->add(node_full_name, gid, is_writer)) publish_graph();
}

void Participant::remove_endpoint(const Gid& gid) {
  std::lock_guard lock(mutex_);
  if (graph_->remove(gid)) publish_graph();
}

// Takes no lock of the participant: in one process, another participant's publish_graph() ends up here.
void Participant::GraphListener::on_data_available(dds::DataReader* reader) {
  Incoming in;
  dds::SampleInfo info;
  while (reader->take_next_sample(&in, &info) == ReturnCode_t::RETCODE_OK) {
    if (!info.valid_data || info.sample_identity.writer_guid().guidPrefix == reader->guid().guidPrefix)
      continue;
    if (const auto report = participant.peers_.take(in.payload)) participant.log_.warn("{}", *report);
  }
}

void Participant::DiscoveryListener::on_participant_discovery(dds::DomainParticipant*,
                                                              rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    participant.peers_.forget(to_gid(info.info.m_guid));
  }
}

void Participant::DiscoveryListener::on_publisher_discovery(dds::DomainParticipant*,
                                                            rtps::WriterDiscoveryInfo&& info) {
  const std::string topic = info.info.topicName().to_string();
  const Gid writer = to_gid(info.info.guid());
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) {
    participant.written_.forget(topic, writer);
    participant.cyclone_clients_.forget(writer);
    return;
  }
  const auto& user_data = info.info.m_qos.m_userData;
  participant.check_type_hash(info.info.typeName().to_string(), user_data);
  participant.written_.note(
      topic, writer,
      {info.info.typeName().to_string(), type_hash_of(user_data), offered_qos(info.info.m_qos)});
  participant.cyclone_clients_.note_writer(writer, topic, user_data_value(user_data, "clientid"));
}

void Participant::DiscoveryListener::on_subscriber_discovery(dds::DomainParticipant*,
                                                             rtps::ReaderDiscoveryInfo&& info) {
  const Gid reader = to_gid(info.info.guid());
  if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER) participant.cyclone_clients_.forget(reader);
  if (info.status != rtps::ReaderDiscoveryInfo::DISCOVERED_READER) return;
  const auto& user_data = info.info.m_qos.m_userData;
  participant.check_type_hash(info.info.typeName().to_string(), user_data);
  participant.cyclone_clients_.note_reader(reader, info.info.topicName().to_string(),
                                           user_data_value(user_data, "clientid"));
}

void Participant::check_type_hash(const std::string& dds_type, std::span<const std::uint8_t> user_data) {
  const std::string hash = type_hash_of(user_data);
  if (hash.empty()) return;
  const auto* type = idl::find_type(idl::ros_type_name(dds_type));
  if (type == nullptr || hash == type->hash) return;
  {
    std::lock_guard lock(foreign_types_mutex_);
    if (!foreign_types_.insert(type->name).second) return;
  }
  log_.warn(
      "another participant has a different definition of {} ({}; here {}): its messages may be misread or "
      "dropped; "
      "build both sides from the same definition",
      type->name, hash, type->hash);
}

Gid Participant::gid() const { return to_gid(participant_->guid()); }

Graph Participant::graph() const {
  std::lock_guard lock(mutex_);
  return *graph_;
}

}  // namespace goalnet::ros::detail

namespace goalnet::ros {

Context::Context(std::shared_ptr<detail::Participant> participant) : participant_(std::move(participant)) {}
Context::~Context() = default;

Expected<std::unique_ptr<Context>> Context::create(const ContextOptions& options) {
  auto settings = detail::read_settings(options);
  if (!settings) return tl::unexpected(settings.error());
  auto participant = detail::Participant::create(*settings);
  if (!participant) return tl::unexpected(participant.error());
  return std::unique_ptr<Context>(new Context(std::move(*participant)));
}

int Context::domain_id() const { return participant_->settings().domain_id; }
Distro Context::distro() const { return participant_->settings().distro; }
const std::string& Context::enclave() const { return participant_->settings().enclave; }
std::vector<std::string> Context::other_nodes() const { return participant_->other_nodes(); }

}  // namespace goalnet::ros
