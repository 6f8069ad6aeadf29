// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/ndarray.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "bindings.hpp"
#include "surefoot/run_log.hpp"

namespace nb = nanobind;
using namespace surefoot;

namespace {

template <typename T>
using Column = nb::ndarray<nb::numpy, T, nb::ndim<1>>;
using Bytes = nb::ndarray<nb::numpy, std::uint8_t, nb::ndim<2>>;

template <typename T>
nb::capsule owner_of(T* data) {
  return nb::capsule(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
}

/// Return an array of one number per tick. The array owns its data.
template <typename T, typename Get>
Column<T> column(const RunLog& log, Get get) {
  auto* data = new T[log.size()];
  const nb::capsule owner = owner_of(data);
  for (std::size_t k = 0; k < log.size(); ++k) data[k] = static_cast<T>(get(log[k]));
  return Column<T>(data, {log.size()}, owner);
}

/// Return the bytes of a packed struct, one row per tick.
template <typename Struct>
Bytes bytes(const RunLog& log, Struct RunTick::* member) {
  constexpr std::size_t kWidth = sizeof(Struct);
  auto* data = new std::uint8_t[log.size() * kWidth];
  const nb::capsule owner = owner_of(data);
  for (std::size_t k = 0; k < log.size(); ++k) {
    std::memcpy(data + k * kWidth, &(log[k].*member), kWidth);
  }
  return Bytes(data, {log.size(), kWidth}, owner);
}

}  // namespace

void bind_run_log(nb::module_& m) {
  nb::class_<RunLog>(m, "RunLog",
                     "Last ticks of a run of a Runner, oldest first; n = len(log).\n\n"
                     "Every array is a copy, made when the attribute is read.")
      .def("__len__", &RunLog::size)
      .def_prop_ro(
          "time",
          [](const RunLog& log) {
            return column<double>(log, [](const RunTick& t) { return t.time; });
          },
          nb::rv_policy::automatic, "Time since run() began [s], shape (n,).")
      .def_prop_ro(
          "has_new_state",
          [](const RunLog& log) {
            return column<bool>(log, [](const RunTick& t) { return t.has_new_state; });
          },
          nb::rv_policy::automatic,
          "Whether a new LowState arrived in the tick, booleans, shape (n,).")
      .def_prop_ro(
          "mode",
          [](const RunLog& log) {
            return column<std::int64_t>(log, [](const RunTick& t) { return t.mode; });
          },
          nb::rv_policy::automatic,
          "Mode of the supervisor after the tick, as an integer, shape (n,).")
      .def_prop_ro(
          "damping_fault",
          [](const RunLog& log) {
            return column<std::int64_t>(log, [](const RunTick& t) { return t.damping_fault; });
          },
          nb::rv_policy::automatic,
          "FaultId for which damping was last latched, as an integer, shape (n,).")
      .def_prop_ro(
          "velocity",
          [](const RunLog& log) {
            auto* data = new double[3 * log.size()];
            const nb::capsule owner = owner_of(data);
            for (std::size_t k = 0; k < log.size(); ++k) {
              const WalkVelocity v =
                  log[k].has_velocity ? log[k].velocity : WalkVelocity{NAN, NAN, NAN};
              data[3 * k] = v.vx, data[3 * k + 1] = v.vy, data[3 * k + 2] = v.yaw_rate;
            }
            return nb::ndarray<nb::numpy, double, nb::ndim<2>>(data, {log.size(), 3}, owner);
          },
          nb::rv_policy::automatic,
          "Argument of Supervisor.set_velocity() before the tick: vx, vy [m/s], yaw rate [rad/s],\n"
          "shape (n, 3); NaN: no call.")
      .def_prop_ro(
          "gait",
          [](const RunLog& log) {
            return column<std::int64_t>(log, [](const RunTick& t) { return t.gait; });
          },
          nb::rv_policy::automatic, "Gait of the mode WALK, as an integer, shape (n,).")
      .def_prop_ro(
          "samples", [](const RunLog& log) { return bytes(log, &RunTick::state); },
          nb::rv_policy::automatic,
          "Bytes of the newest LowState, shape (n, 937); see LowState.from_bytes().")
      .def_prop_ro(
          "commands", [](const RunLog& log) { return bytes(log, &RunTick::command); },
          nb::rv_policy::automatic,
          "Bytes of the LowCmd passed to the link, shape (n, 734); see LowCmd.from_bytes().");
}
