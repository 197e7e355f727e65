#include "tests/interoperability/replay/captured_client.h"

#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include <atomic>
#include <thread>

#include "components/ros/detail/message_type.h"
#include "components/ros/detail/participant.h"

namespace goalnet::ros {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

std::string reply_topic(const std::string& request_topic) {
  const std::string name = request_topic.substr(3, request_topic.size() - 3 - std::string("Request").size());
  return "rr/" + name + "Reply";
}

std::string reply_type(const std::string& request_type) {
  return request_type.substr(0, request_type.rfind("_Request")) + "_Response";
}

// Of the entity ids 00 00 NN kk only NN is ours to choose.
int entity_number(const Gid& gid) { return gid[14]; }

// Where nothing was captured about the reply reader (rmw_cyclonedds) it gets the number after the writer's.
int reader_number(const CapturedSample& request) {
  return request.related ? entity_number(request.related->writer) : entity_number(request.id.writer) + 1;
}

}  // namespace

struct CapturedClient::Impl {
  struct Out : dds::DataWriterListener {
    std::atomic<int> matched{0};
    dds::DataWriter* writer = nullptr;
    void on_publication_matched(dds::DataWriter*, const dds::PublicationMatchedStatus& status) override {
      matched = status.current_count;
    }
  };
  struct In : dds::DataReaderListener {
    std::atomic<int> matched{0};
    dds::DataReader* reader = nullptr;
    std::mutex mutex;
    std::vector<Reply> replies;
    void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
      matched = status.current_count;
    }
    void on_data_available(dds::DataReader* source) override {
      detail::Incoming in;
      dds::SampleInfo info;
      while (source->take_next_sample(&in, &info) == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
        if (!info.valid_data) continue;
        std::lock_guard lock(mutex);
        replies.push_back(
            {{detail::to_gid(info.related_sample_identity.writer_guid()),
              static_cast<std::int64_t>(info.related_sample_identity.sequence_number().to64long())},
             in.payload});
      }
    }
  };

  dds::DomainParticipant* participant = nullptr;
  dds::Publisher* publisher = nullptr;
  dds::Subscriber* subscriber = nullptr;
  std::map<std::string, dds::Topic*> topics;
  std::map<int, std::unique_ptr<Out>>
      outs;  // by entity number: one client may ask one service through several
  std::map<int, std::unique_ptr<In>> ins;

  dds::Topic* topic(const std::string& name, const std::string& ros_type) {
    const std::string type_name = idl::dds_type_name(ros_type);
    if (participant->find_type(type_name).empty()) {
      dds::TypeSupport(new detail::MessageType(type_name)).register_type(participant);
    }
    auto& made = topics[name];
    if (made == nullptr) made = participant->create_topic(name, type_name, dds::TOPIC_QOS_DEFAULT);
    return made;
  }
  Out& out(const std::string& name, const std::string& ros_type, const Qos& profile, int number,
           const std::string& user_data = "") {
    auto& slot = outs[number];
    if (slot) return *slot;
    slot = std::make_unique<Out>();
    auto qos = detail::writer_qos(profile, user_data);
    qos.endpoint().entity_id = static_cast<std::int16_t>(number);
    slot->writer = publisher->create_datawriter(topic(name, ros_type), qos, slot.get(),
                                                dds::StatusMask::publication_matched());
    return *slot;
  }
  In& in(const std::string& name, const std::string& ros_type, int number, const std::string& user_data) {
    auto& slot = ins[number];
    if (slot) return *slot;
    slot = std::make_unique<In>();
    auto qos = detail::reader_qos(Qos::services(), user_data);
    qos.endpoint().entity_id = static_cast<std::int16_t>(number);
    slot->reader = subscriber->create_datareader(topic(name, ros_type), qos, slot.get(),
                                                 dds::StatusMask::data_available()
                                                     << dds::StatusMask::subscription_matched());
    return *slot;
  }
};

CapturedClient::CapturedClient(int domain, const Gid& any_endpoint) : impl_(std::make_unique<Impl>()) {
  auto qos = dds::PARTICIPANT_QOS_DEFAULT;
  qos.wire_protocol().prefix = detail::to_guid(any_endpoint).guidPrefix;
  qos.wire_protocol().builtin.discovery_config.initial_announcements = {40, {0, 20'000'000}};
  impl_->participant = dds::DomainParticipantFactory::get_instance()->create_participant(domain, qos);
  impl_->publisher = impl_->participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  impl_->subscriber = impl_->participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
}

CapturedClient::~CapturedClient() {
  impl_->participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(impl_->participant);
}

bool CapturedClient::send(const CapturedSample& request) {
  const int number = entity_number(request.id.writer);
  // By this rmw_cyclonedds says which reader and writer belong together.
  const std::string client = request.header.empty() ? "" : "clientid= 1.10." + std::to_string(number) + ";";
  auto& in = impl_->in(reply_topic(request.topic), reply_type(request.type), reader_number(request), client);
  auto& out = impl_->out(request.topic, request.type, Qos::services(), number, client);
  for (int i = 0; i < 500 && (in.matched == 0 || out.matched == 0); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  if (in.matched == 0 || out.matched == 0) return false;
  detail::Outgoing sample;
  const Bytes payload = request.as_sent();
  sample.payload = payload;
  if (!request.header.empty()) return out.writer->write(&sample);
  rtps::WriteParams identity;
  identity.related_sample_identity().writer_guid(in.reader->guid());
  identity.related_sample_identity().sequence_number() = rtps::SequenceNumber_t(-1, 0);
  return out.writer->write(&sample, identity);
}

std::vector<CapturedClient::Reply> CapturedClient::replies_to(const CapturedSample& request) const {
  const auto found = impl_->ins.find(reader_number(request));
  if (found == impl_->ins.end()) return {};
  std::lock_guard lock(found->second->mutex);
  return found->second->replies;
}

bool CapturedClient::publish(const CapturedSample& message) {
  auto& out = impl_->out(message.topic, message.type,
                         message.topic == "ros_discovery_info" ? Qos::latched() : Qos::standard(),
                         entity_number(message.id.writer));
  for (int i = 0; i < 500 && out.matched == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  detail::Outgoing sample;
  sample.payload = message.payload;
  return out.matched > 0 && out.writer->write(&sample);
}

}  // namespace goalnet::ros
