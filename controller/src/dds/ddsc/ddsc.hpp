// SPDX-License-Identifier: BSD-3-Clause
// The part of the C API of Cyclone DDS that Surefoot uses. libddsc 0.10.2 and 11.0.1 have the same
// functions and layouts. Names follow dds.h without the prefix dds_.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "dds/ddsc/dds_public_impl.h"

namespace surefoot::ddsc {

using Entity = std::int32_t;  ///< handle of an entity; negative: a return code
using Return = std::int32_t;  ///< 0 or a count; negative: an error
constexpr Return kTimeout = -10;

/// Topics of the participants and endpoints that were discovered.
constexpr Entity kTopicOfParticipants = 0x7fff0001, kTopicOfWriters = 0x7fff0003,
                 kTopicOfReaders = 0x7fff0004;

using Guid = std::array<std::uint8_t, 16>;
struct Qos;       // opaque
struct Listener;  // opaque

constexpr int kInstanceAlive = 16;

/// Information about a sample, as dds_take() returns it.
struct SampleInfo {
  int sample_state, view_state, instance_state;
  bool valid_data;
  std::int64_t source_timestamp;  // [ns] clock of the sender
  std::uint64_t instance_handle, publication_handle;
  std::uint32_t disposed_generation_count, no_writers_generation_count;
  std::uint32_t sample_rank, generation_rank, absolute_generation_rank;
};

/// Sample of kTopicOfParticipants.
struct ParticipantSample {
  Guid key;
  Qos* qos;
};

/// Sample of kTopicOfWriters and kTopicOfReaders.
struct EndpointSample {
  Guid key, participant_key;
  std::uint64_t participant_instance_handle;
  char *topic_name, *type_name;
  Qos* qos;
};

enum class Reliability : int { kBestEffort, kReliable };
enum class History : int { kKeepLast, kKeepAll };

/// Functions of a loaded libddsc.
struct Functions {
  Entity (*create_domain)(std::uint32_t id, const char* config);
  Entity (*create_participant)(std::uint32_t domain, const Qos*, const Listener*);
  Entity (*create_topic)(Entity participant, const dds_topic_descriptor_t*, const char* name,
                         const Qos*, const Listener*);
  Entity (*create_reader)(Entity participant, Entity topic, const Qos*, const Listener*);
  Entity (*create_writer)(Entity participant, Entity topic, const Qos*, const Listener*);
  Return (*delete_)(Entity);
  Return (*get_guid)(Entity, Guid*);
  Return (*write)(Entity writer, const void* sample);
  Return (*take)(Entity reader, void** samples, SampleInfo*, std::size_t size, std::uint32_t max);
  Return (*read)(Entity reader, void** samples, SampleInfo*, std::size_t size, std::uint32_t max);
  Return (*return_loan)(Entity reader, void** samples, std::int32_t count);
  Qos* (*create_qos)();
  void (*delete_qos)(Qos*);
  void (*qset_reliability)(Qos*, Reliability, std::int64_t max_blocking_time);
  void (*qset_history)(Qos*, History, std::int32_t depth);
  bool (*qget_reliability)(const Qos*, Reliability*, std::int64_t* max_blocking_time);
  bool (*qget_prop)(const Qos*, const char* name, char** value);
  Listener* (*create_listener)(void* argument);
  void (*delete_listener)(Listener*);
  Return (*lset_data_available_arg)(Listener*, void (*)(Entity reader, void* argument),
                                    void* argument, bool reset_on_invoke);
  const char* (*strretcode)(Return);
  void (*free)(void*);
};

}  // namespace surefoot::ddsc
