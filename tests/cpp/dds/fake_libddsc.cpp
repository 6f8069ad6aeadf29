// SPDX-License-Identifier: BSD-3-Clause
// A libddsc without a network and without allocations: each reader of rt/lowstate gets one LowState
// per take() that follows fake_arrival(), and write() returns what fake_write_result() has set.
#include <atomic>
#include <cstdint>
#include <cstring>

#include "dds/ddsc/ddsc.hpp"
#include "dds/generated/unitree_go.h"

using namespace surefoot::ddsc;

namespace {
// A name of three numbers, by which library_version() recognises a tested library.
const char kVersion[] =
    "\0"
    "11.0.1";
unitree_go_msg_dds__LowState_ state;
int waiting = 0;
std::uint64_t writer = 1;
Return write_result = 0;
Entity next_entity = 1;
std::atomic<int> reads{0};
}  // namespace

extern "C" {
const char* fake_version() { return kVersion + 1; }
void fake_arrival(const void* sample) {
  std::memcpy(&state, sample, sizeof(state));
  waiting = 1;
}
int fake_reads() { return reads.load(); }
void fake_writer(std::uint64_t handle) { writer = handle; }
void fake_write_result(Return result) { write_result = result; }

Entity dds_create_domain(std::uint32_t, const char*) { return next_entity++; }
Entity dds_create_participant(std::uint32_t, const Qos*, const Listener*) { return next_entity++; }
Entity dds_create_topic(Entity, const dds_topic_descriptor_t*, const char*, const Qos*,
                        const Listener*) {
  return next_entity++;
}
Entity dds_create_reader(Entity, Entity, const Qos*, const Listener*) { return next_entity++; }
Entity dds_create_writer(Entity, Entity, const Qos*, const Listener*) { return next_entity++; }
Return dds_delete(Entity) { return 0; }
Return dds_get_guid(Entity, Guid*) { return 0; }
Return dds_write(Entity, const void*) { return write_result; }
Return dds_take(Entity, void** samples, SampleInfo* infos, std::size_t, std::uint32_t) {
  if (waiting == 0) return 0;
  waiting = 0;
  std::memcpy(samples[0], &state, sizeof(state));
  infos[0].valid_data = true;
  infos[0].publication_handle = writer;
  return 1;
}
Return dds_read(Entity, void**, SampleInfo*, std::size_t, std::uint32_t) {
  ++reads;
  return 0;
}
Return dds_return_loan(Entity, void**, std::int32_t) { return 0; }
Qos* dds_create_qos() { return nullptr; }
void dds_delete_qos(Qos*) {}
void dds_qset_reliability(Qos*, Reliability, std::int64_t) {}
void dds_qset_history(Qos*, History, std::int32_t) {}
bool dds_qget_reliability(const Qos*, Reliability*, std::int64_t*) { return false; }
bool dds_qget_prop(const Qos*, const char*, char**) { return false; }
Listener* dds_create_listener(void*) { return nullptr; }
void dds_delete_listener(Listener*) {}
Return dds_lset_data_available_arg(Listener*, void (*)(Entity, void*), void*, bool) { return 0; }
const char* dds_strretcode(Return) { return "fake"; }
void dds_free(void*) {}
}
