// SPDX-License-Identifier: BSD-3-Clause
#include "dds/network/discovery.hpp"

#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// Number of samples of the first read; it is doubled until all fit. Chosen: more endpoints than a
// robot and ROS 2 have. Endpoints that have gone leave samples too.
constexpr std::uint32_t kSamples = 512;

void set_flag(ddsc::Entity, void* flag) { static_cast<std::atomic<bool>*>(flag)->store(true); }

// @param changed set to true at every change of what the reader holds; or nullptr
DdsEntity built_in_reader(const DdsParticipant& participant, ddsc::Entity topic,
                          std::atomic<bool>* changed = nullptr) {
  const ddsc::Functions& f = participant.functions();
  ddsc::Listener* listener = nullptr;
  if (changed != nullptr) {
    listener = f.create_listener(changed);
    f.lset_data_available_arg(listener, &set_flag, changed, true);
  }
  const ddsc::Entity created = f.create_reader(participant.handle(), topic, nullptr, listener);
  if (listener != nullptr) f.delete_listener(listener);  // the reader has a copy
  return DdsEntity(f, created, "DDS reader of a built-in topic");
}

// Call use(sample, handle) for every participant or endpoint that is alive. Throws surefoot::Error
// if they cannot be read.
template <typename Sample, typename Use>
void for_each_alive(const ddsc::Functions& f, const DdsEntity& reader, Use&& use) {
  for (std::uint32_t size = kSamples;; size *= 2) {
    std::vector<void*> samples(size, nullptr);  // nullptr: libddsc lends its memory
    std::vector<ddsc::SampleInfo> infos(size);
    const ddsc::Return count = f.read(reader.handle(), samples.data(), infos.data(), size, size);
    if (count < 0) throw Error("DDS: discovered participants cannot be read: " + to_text(f, count));
    const bool all = static_cast<std::uint32_t>(count) < size;
    for (ddsc::Return k = 0; all && k < count; ++k) {
      const ddsc::SampleInfo& info = infos[static_cast<std::size_t>(k)];
      if (info.valid_data && info.instance_state == ddsc::kInstanceAlive)
        use(*static_cast<const Sample*>(samples[static_cast<std::size_t>(k)]),
            info.instance_handle);
    }
    if (count > 0) f.return_loan(reader.handle(), samples.data(), count);
    if (all) return;
  }
}

std::string hex(const ddsc::Guid& guid) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : guid) {
    text += kDigits[byte / 16];
    text += kDigits[byte % 16];
  }
  return text;
}

}  // namespace

DdsDiscovery::DdsDiscovery(const DdsParticipant& participant)
    : functions_(participant.functions()),
      writers_changed_(std::make_unique<std::atomic<bool>>(true)),
      participants_(built_in_reader(participant, ddsc::kTopicOfParticipants)),
      writers_(built_in_reader(participant, ddsc::kTopicOfWriters, writers_changed_.get())),
      readers_(built_in_reader(participant, ddsc::kTopicOfReaders)) {}

std::vector<DiscoveredEndpoint> DdsDiscovery::writers(const std::string& topic) const {
  return endpoints(writers_, topic);
}
std::vector<DiscoveredEndpoint> DdsDiscovery::readers(const std::string& topic) const {
  return endpoints(readers_, topic);
}

std::vector<DiscoveredEndpoint> DdsDiscovery::endpoints(const DdsEntity& reader,
                                                        const std::string& topic) const {
  const std::map<ddsc::Guid, std::string> names = owners();
  std::vector<DiscoveredEndpoint> found;
  for_each_alive<ddsc::EndpointSample>(
      functions_, reader, [&](const ddsc::EndpointSample& endpoint, std::uint64_t handle) {
        if (topic != endpoint.topic_name) return;
        const auto owner = names.find(endpoint.participant_key);
        found.push_back({endpoint.key, handle, endpoint.type_name, is_reliable(endpoint),
                         owner == names.end() ? "participant " + hex(endpoint.participant_key)
                                              : owner->second});
      });
  return found;
}

bool DdsDiscovery::is_reliable(const ddsc::EndpointSample& endpoint) const {
  ddsc::Reliability reliability = ddsc::Reliability::kBestEffort;
  return functions_.qget_reliability(endpoint.qos, &reliability, nullptr) &&
         reliability == ddsc::Reliability::kReliable;
}

std::map<ddsc::Guid, std::string> DdsDiscovery::owners() const {
  std::map<ddsc::Guid, std::string> names;
  for_each_alive<ddsc::ParticipantSample>(
      functions_, participants_,
      [&](const ddsc::ParticipantSample& p, std::uint64_t) { names[p.key] = owner_text(p); });
  return names;
}

// Cyclone DDS tells the process in properties of the participant; other DDS libraries do not.
std::string DdsDiscovery::owner_text(const ddsc::ParticipantSample& participant) const {
  const auto property = [&](const char* name) {
    char* value = nullptr;
    if (!functions_.qget_prop(participant.qos, name, &value) || value == nullptr)
      return std::string();
    const std::string text = value;
    functions_.free(value);
    return text;
  };
  const std::string process = property("__ProcessName");
  if (process.empty()) return "participant " + hex(participant.key);
  return "process " + process + " (pid " + property("__Pid") + ") on " + property("__Hostname");
}

}  // namespace surefoot
