#include "tools/bench/ros_peer/plain_echo.h"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/dds/core/condition/GuardCondition.hpp>
#include <fastdds/dds/core/condition/StatusCondition.hpp>
#include <fastdds/dds/core/condition/WaitSet.hpp>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

#include <atomic>
#include <thread>

#include "std_msgs/msg/String.h"

namespace goalnet::tools {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using std_msgs::msg::String;

// What fastddsgen would write for std_msgs/String.
class StringType : public dds::TopicDataType {
 public:
  StringType() {
    setName("std_msgs::msg::dds_::String_");
    m_typeSize = 4 + 8 + 1024;
    m_isGetKeyDefined = false;
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    payload->encapsulation = CDR_LE;
    cdr.serialize_encapsulation();
    static_cast<String*>(data)->serialize(cdr);
    payload->length = static_cast<std::uint32_t>(cdr.getSerializedDataLength());
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    cdr.read_encapsulation();
    static_cast<String*>(data)->deserialize(cdr);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] {
      return static_cast<std::uint32_t>(String::getCdrSerializedSize(*static_cast<String*>(data))) + 4u;
    };
  }
  void* createData() override { return new String(); }
  void deleteData(void* data) override { delete static_cast<String*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

}  // namespace

struct PlainEndpoint::Impl : dds::DataReaderListener, dds::DataWriterListener {
  std::function<void(const std::string&)> on_message;
  std::atomic<int> readers{0}, writers{0};
  dds::DomainParticipant* participant = nullptr;
  dds::DataWriter* writer = nullptr;
  dds::GuardCondition end;
  std::thread waiting;

  void wait_for_messages(dds::DataReader* reader) {
    dds::WaitSet set;
    reader->get_statuscondition().set_enabled_statuses(dds::StatusMask::data_available());
    set.attach_condition(reader->get_statuscondition());
    set.attach_condition(end);
    while (!end.get_trigger_value()) {
      dds::ConditionSeq met;
      set.wait(met, eprosima::fastrtps::c_TimeInfinite);
      on_data_available(reader);
    }
  }
  void on_data_available(dds::DataReader* reader) override {
    String message;
    dds::SampleInfo info;
    while (reader->take_next_sample(&message, &info) == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) on_message(message.data());
    }
  }
  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    writers = status.current_count;
  }
  void on_publication_matched(dds::DataWriter*, const dds::PublicationMatchedStatus& status) override {
    readers = status.current_count;
  }
};

PlainEndpoint::PlainEndpoint(int domain, const std::string& read, const std::string& write,
                             std::function<void(const std::string&)> on_message, Hearing hearing)
    : impl_(std::make_unique<Impl>()) {
  impl_->on_message = std::move(on_message);
  auto qos = dds::PARTICIPANT_QOS_DEFAULT;
  qos.wire_protocol().builtin.discovery_config.initial_announcements = {40, {0, 50'000'000}};
  impl_->participant = dds::DomainParticipantFactory::get_instance()->create_participant(domain, qos);
  dds::TypeSupport type(new StringType());
  type.register_type(impl_->participant);
  auto* in = impl_->participant->create_topic(read, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  auto* out = impl_->participant->create_topic(write, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  auto writer_qos = dds::DATAWRITER_QOS_DEFAULT;
  writer_qos.history().depth = 10;
  writer_qos.data_sharing().off();
  writer_qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  auto reader_qos = dds::DATAREADER_QOS_DEFAULT;
  reader_qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  reader_qos.history().depth = 10;
  reader_qos.data_sharing().off();
  reader_qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  impl_->writer =
      impl_->participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT)
          ->create_datawriter(out, writer_qos, impl_.get(), dds::StatusMask::publication_matched());
  auto mask = dds::StatusMask::subscription_matched();
  if (hearing == Hearing::kListener) mask << dds::StatusMask::data_available();
  auto* reader = impl_->participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT)
                     ->create_datareader(in, reader_qos, impl_.get(), mask);
  if (hearing == Hearing::kWaitSet)
    impl_->waiting = std::thread([impl = impl_.get(), reader] { impl->wait_for_messages(reader); });
}

PlainEndpoint::~PlainEndpoint() {
  impl_->end.set_trigger_value(true);
  if (impl_->waiting.joinable()) impl_->waiting.join();
  impl_->participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(impl_->participant);
}

void PlainEndpoint::write(const std::string& text) {
  String message;
  message.data(text);
  impl_->writer->write(&message);
}

bool PlainEndpoint::matched() const { return impl_->readers > 0 && impl_->writers > 0; }

}  // namespace goalnet::tools
