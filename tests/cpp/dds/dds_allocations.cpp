// SPDX-License-Identifier: BSD-3-Clause
// Count the heap allocations and exceptions of DdsLink::receive() and send() with a libddsc that
// has none. malloc and its relatives (benchmarks/ticks/memory_counters.cpp) are replaced.
// Usage: surefoot_dds_allocations FAKE_LIBDDSC
#include <dlfcn.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "dds/wire/low_state_conversion.hpp"
#include "surefoot/dds_link.hpp"
#include "ticks/memory_counters.hpp"

using namespace surefoot;

namespace {

constexpr int kTicks = 1000;
constexpr int kTimeouts = 100;
constexpr std::int32_t kTimeout = -10;

int failures = 0;
void expect(bool condition, const char* text) {
  std::printf("%s: %s\n", condition ? "ok" : "FAILED", text);
  failures += condition ? 0 : 1;
}

// Run ticks with new LowStates, some of which have a wrong CRC, and count allocations.
int ticks_with_allocations(DdsLink& link, void (*arrive)(const void*), int ticks) {
  LowState state = init_low_state();
  LowCmd command = init_low_cmd();
  int count = 0;
  for (int k = 0; k < ticks; ++k) {
    state.tick += 2;
    DdsLowState wire;
    to_dds(state, DdsRobot::kGo2, wire);
    if (k % 10 == 9) wire.crc ^= 1U;
    arrive(&wire);
    const long before = bench::heap_allocations();
    link.receive();
    link.send(command);
    count += bench::heap_allocations() != before;
  }
  return count;
}

// Functions with which the test controls the fake libddsc.
struct Fake {
  explicit Fake(void* library)
      : arrive(reinterpret_cast<void (*)(const void*)>(dlsym(library, "fake_arrival"))),
        reads(reinterpret_cast<int (*)()>(dlsym(library, "fake_reads"))),
        set_writer(reinterpret_cast<void (*)(std::uint64_t)>(dlsym(library, "fake_writer"))),
        set_result(reinterpret_cast<void (*)(std::int32_t)>(dlsym(library, "fake_write_result"))) {}
  void (*arrive)(const void*);
  int (*reads)();
  void (*set_writer)(std::uint64_t);
  void (*set_result)(std::int32_t);
};

// The thread of the link reads the writers once, and then only if one comes or goes.
void check_reads(const Fake& fake) {
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(120)); };
  pause();
  const int first_reads = fake.reads();
  pause();
  expect(first_reads > 0 && fake.reads() == first_reads, "writers are read only after a change");
}

void check_ticks(DdsLink& link, const Fake& fake) {
  expect(ticks_with_allocations(link, fake.arrive, kTicks) == 0,
         "receive() and send() do not allocate");
  expect(link.counts().valid == kTicks * 9 / 10, "LowStates with a right CRC are valid");
  expect(link.counts().corrupt == kTicks / 10, "LowStates with a wrong CRC are counted");
  fake.set_writer(2);
  expect(ticks_with_allocations(link, fake.arrive, kTicks) == 0,
         "receive() and send() do not allocate in a conflict");
  expect(link.dds_counts().second_robot == kTicks, "LowStates of a second robot are counted");
}

void check_timeouts(DdsLink& link, const Fake& fake) {
  fake.set_result(kTimeout);
  ticks_with_allocations(link, fake.arrive, kTimeouts);
  expect(link.dds_counts().timeouts == kTimeouts, "writes that time out are counted");
  expect(link.counts().send_failed == kTimeouts, "they count as not sent");
  const std::vector<std::string> news = link.take_news();
  expect(!news.empty() && news.back().rfind("rt/lowcmd: 100 message(s) timed out", 0) == 0,
         "they are reported with their topic");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  void* const library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return 2;
  const Fake fake(library);
  const auto network =
      std::make_shared<DdsNetwork>(DdsNetworkOptions{"lo", 1, false, argv[1], false});
  DdsLinkOptions options;
  options.discovery_time = 0.0;
  DdsLink link(network, options);
  check_reads(fake);
  check_ticks(link, fake);
  check_timeouts(link, fake);
  return failures == 0 ? 0 : 1;
}
