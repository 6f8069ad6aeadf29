// SPDX-License-Identifier: BSD-3-Clause
// Counts heap allocations of the tick by replacing malloc and its relatives for the whole program.
#include <dlfcn.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "scenes.hpp"
#include "surefoot/stand_controller.hpp"

namespace {
std::atomic<bool> counting{false};
std::atomic<long> allocations{0};

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}
void count() {
  if (counting) ++allocations;
}
}  // namespace

extern "C" {
void* malloc(std::size_t size) {
  static const auto real = next<void* (*)(std::size_t)>("malloc");
  count();
  return real(size);
}
void* realloc(void* old, std::size_t size) {
  static const auto real = next<void* (*)(void*, std::size_t)>("realloc");
  count();
  return real(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  static const auto real = next<void* (*)(std::size_t, std::size_t)>("aligned_alloc");
  count();
  return real(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  static const auto real = next<int (*)(void**, std::size_t, std::size_t)>("posix_memalign");
  count();
  return real(out, alignment, size);
}
}

int main() {
  using namespace surefoot;
  const Robot robot = quadruped();
  StandController controller(robot);
  LowState report = resting_report(robot, 0);
  controller.update(report);
  // Vibrate the report so that limits become active, contacts open and close, and faults occur.
  counting = true;
  std::free(std::malloc(8));  // the counter must see this one
  for (std::uint32_t tick = 1; tick <= 50000; ++tick) {
    report.tick = 2 * tick;
    const float wave = static_cast<float>(std::sin(0.05 * tick));
    report.imu.gyroscope[0] = 2.0F * wave;
    report.imu.accelerometer[1] = 3.0F * wave;
    for (int i = 0; i < kMotors; ++i) report.motorState[i].dq = 3.0F * wave * (i % 2 ? 1 : -1);
    report.footForceEst = {30, 30, 30, static_cast<std::int16_t>(wave > 0.5F ? 0 : 30)};
    if (tick % 1000 == 0) report.tick -= 2;
    controller.update(report);
    if (controller.status() == Status::kDamping) controller.reset();
  }
  counting = false;
  std::printf("%ld allocations in 50000 ticks\n", allocations - 1);
  return allocations == 1 ? 0 : 1;
}
