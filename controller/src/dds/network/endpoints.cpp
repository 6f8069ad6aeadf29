// SPDX-License-Identifier: BSD-3-Clause
#include "dds/network/endpoints.hpp"

#include "common/clock.hpp"

namespace surefoot {

namespace {

// [ns] Longest time for which a slow reliable reader may block a write. Chosen: half a period at
// 500 Hz. If larger: the reader delays the control loop.
constexpr std::int64_t kMaxBlockingTime = 1000000;

// Quality of service of an endpoint.
class EndpointQos {
 public:
  EndpointQos(const ddsc::Functions& functions, ddsc::Reliability reliability, int depth)
      : functions_(functions), qos_(functions.create_qos()) {
    functions_.qset_reliability(qos_, reliability, kMaxBlockingTime);
    functions_.qset_history(qos_, ddsc::History::kKeepLast, depth);
  }
  ~EndpointQos() { functions_.delete_qos(qos_); }
  EndpointQos(const EndpointQos&) = delete;
  EndpointQos& operator=(const EndpointQos&) = delete;
  const ddsc::Qos* get() const noexcept { return qos_; }

 private:
  const ddsc::Functions& functions_;
  ddsc::Qos* qos_;
};

DdsEntity create_topic(const DdsParticipant& participant, const dds_topic_descriptor_t& type,
                       const char* topic) {
  const ddsc::Functions& f = participant.functions();
  return DdsEntity(f, f.create_topic(participant.handle(), &type, topic, nullptr, nullptr),
                   std::string("DDS topic ") + topic);
}

void store_arrival(ddsc::Entity, void* last_arrival) {
  static_cast<std::atomic<double>*>(last_arrival)->store(monotonic_time());
}

DdsEntity create_reader(const DdsParticipant& participant, ddsc::Entity topic, const char* name,
                        std::atomic<double>* last_arrival) {
  const ddsc::Functions& f = participant.functions();
  const EndpointQos qos(f, ddsc::Reliability::kBestEffort, DdsReader::kDepth);
  ddsc::Listener* const listener = f.create_listener(last_arrival);
  f.lset_data_available_arg(listener, &store_arrival, last_arrival, true);
  const ddsc::Entity created = f.create_reader(participant.handle(), topic, qos.get(), listener);
  f.delete_listener(listener);  // the reader has a copy
  return DdsEntity(f, created, std::string("DDS reader of ") + name);
}

}  // namespace

DdsWriter::DdsWriter(const DdsParticipant& participant, const dds_topic_descriptor_t& type,
                     const char* topic)
    : functions_(&participant.functions()), topic_(create_topic(participant, type, topic)) {
  const EndpointQos qos(*functions_, ddsc::Reliability::kReliable, 1);
  writer_ = DdsEntity(
      *functions_,
      functions_->create_writer(participant.handle(), topic_.handle(), qos.get(), nullptr),
      std::string("DDS writer of ") + topic);
  functions_->get_guid(writer_.handle(), &guid_);
}

DdsReader::DdsReader(const DdsParticipant& participant, const dds_topic_descriptor_t& type,
                     const char* topic)
    : functions_(&participant.functions()),
      last_arrival_(std::make_unique<std::atomic<double>>(0.0)),
      topic_(create_topic(participant, type, topic)),
      reader_(create_reader(participant, topic_.handle(), topic, last_arrival_.get())) {}

bool DdsReader::take(void* sample, std::uint64_t* writer) noexcept {
  ddsc::SampleInfo info{};
  while (functions_->take(reader_.handle(), &sample, &info, 1, 1) > 0) {
    if (!info.valid_data) continue;  // a writer has gone
    if (writer != nullptr) *writer = info.publication_handle;
    return true;
  }
  return false;
}

}  // namespace surefoot
