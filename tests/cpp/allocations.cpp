// SPDX-License-Identifier: BSD-3-Clause
// Counts heap allocations and exceptions of the tick, by replacing malloc with its relatives and
// the throw itself for the whole program.
#include <dlfcn.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "surefoot/safety.hpp"
#include "surefoot/stand_controller.hpp"
#include "weather.hpp"

namespace {
std::atomic<bool> counting{false};
std::atomic<long> allocations{0}, exceptions{0};

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}
void count(std::atomic<long>& what) {
  if (counting) ++what;
}
}  // namespace

extern "C" {
void* malloc(std::size_t size) {
  static const auto real = next<void* (*)(std::size_t)>("malloc");
  count(allocations);
  return real(size);
}
void* realloc(void* old, std::size_t size) {
  static const auto real = next<void* (*)(void*, std::size_t)>("realloc");
  count(allocations);
  return real(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  static const auto real = next<void* (*)(std::size_t, std::size_t)>("aligned_alloc");
  count(allocations);
  return real(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  static const auto real = next<int (*)(void**, std::size_t, std::size_t)>("posix_memalign");
  count(allocations);
  return real(out, alignment, size);
}
void* __libc_calloc(std::size_t, std::size_t);  // dlsym() itself may call calloc()
void* calloc(std::size_t number, std::size_t size) {
  count(allocations);
  return __libc_calloc(number, size);
}
}

// By its label: compilers know __cxa_throw by heart and disagree on its second argument.
using Destructor = void (*)(void*);
[[noreturn]] void counted_throw(void* thrown, void* type, Destructor destructor) asm("__cxa_throw");
void counted_throw(void* thrown, void* type, Destructor destructor) {
  count(exceptions);
  next<void (*)(void*, void*, Destructor)>("__cxa_throw")(thrown, type, destructor);
  std::abort();
}

namespace {

using namespace surefoot;

/// A task as a user would write it: rows that change, and once in a while a failure.
struct UserTask : Task {
  int rows() const override { return 2; }
  bool write(const RobotState& state, TaskRows& rows) noexcept override {
    rows.A_a(0, 2) = 0.05;
    rows.A_a(1, 7) = 0.05;
    rows.A_f(0, 2) = 0.01;
    rows.b << -0.5 * state.v[2], -0.5 * state.v[7];
    return ++calls % 977 != 0;
  }
  long calls = 0;
};

struct Seen {
  long general = 0, condensed = 0, yielding = 0, stopped = 0, damping = 0, faults = 0, slowed = 0;
  long refused = 0;
};

Seen run(const Robot& robot, Form form, double delay, std::uint32_t ticks) {
  StandOptions options;
  options.form = form;
  options.delay = delay;
  options.power_limit = 150.0;
  Gains gains;
  gains.weight_momentum = gains.weight_posture = gains.weight_smooth = 0.01;
  StandController controller(robot, gains, options);
  controller.add_task(std::make_shared<UserTask>());
  Weather weather(robot);
  Safety safety(robot);
  Seen seen;
  counting = true;
  for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
    if (tick % 400 == 0) controller.set_body_reference(weather.reference());
    if (tick % 2100 == 0) controller.set_body_reference({0.0, std::nan(""), 0.0, 0.0, 0.0, 0.0});
    const LowState& report = weather.report(tick);
    LowCmd command = controller.update(report);
    safety.position_limit(command);
    const bool safe =
        safety.power_protect(command, report, 1) + safety.position_protect(command, report) == 2;
    seen.refused += !safe;
    seen.slowed += controller.power_scale() < 1.0;
    const Solution& s = controller.solution();
    (s.form == Form::kGeneral ? seen.general : seen.condensed) += 1;
    seen.yielding += s.torque_excess + s.joint_limit_excess + s.hold_down_missing > 1e-3;
    seen.stopped += controller.reach().limit != ReachLimit::kNone;
    seen.faults += !is_usable(controller.status());
    if (controller.status() != Status::kDamping) continue;
    ++seen.damping;
    controller.reset();
  }
  counting = false;
  return seen;
}

// The counters must see what they are there for.
bool counters_work() {
  counting = true;
  std::free(std::malloc(8));
  try {
    throw 1;
  } catch (int) {
  }
  counting = false;
  const bool work = allocations > 0 && exceptions == 1;
  allocations = exceptions = 0;
  return work;
}

}  // namespace

int main() {
  const Robot robot = quadruped();
  bool good = counters_work();
  for (const Form form : {Form::kAuto, Form::kGeneral}) {
    for (const double delay : {0.0, 0.01}) {
      const Seen s = run(robot, form, delay, 25000);
      std::printf(
          "%s, delay %.0f ms, 25000 ticks: %ld allocations, %ld exceptions; "
          "general %ld, condensed %ld, limits giving way %ld, reference stopped %ld, "
          "bad ticks %ld, damped %ld, power limited %ld, refused %ld\n",
          to_string(form), 1e3 * delay, allocations.load(), exceptions.load(), s.general,
          s.condensed, s.yielding, s.stopped, s.faults, s.damping, s.slowed, s.refused);
      good = good && s.yielding > 100 && s.stopped > 1000 && s.faults > 100 && s.damping >= 4 &&
             s.slowed > 100 && s.refused > 100 && s.general > 500 &&
             (form == Form::kGeneral || s.condensed > 1000);
    }
  }
  return good && allocations == 0 && exceptions == 0 ? 0 : 1;
}
