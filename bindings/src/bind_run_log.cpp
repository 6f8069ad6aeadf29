// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/ndarray.h>

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

/// One number of every tick.
template <typename T, typename Get>
Column<T> column(const RunLog& log, Get get) {
  auto* data = new T[log.size()];
  const nb::capsule owner = owner_of(data);
  for (std::size_t k = 0; k < log.size(); ++k) data[k] = static_cast<T>(get(log[k]));
  return Column<T>(data, {log.size()}, owner);
}

/// The bytes of a packed struct of every tick.
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
                     "The last ticks of a run: what a StandRunner knew, and what it sent.\n\n"
                     "Every array is a copy, made when it is asked for.")
      .def("__len__", &RunLog::size)
      .def_prop_ro(
          "time",
          [](const RunLog& log) {
            return column<double>(log, [](const RunTick& t) { return t.time; });
          },
          nb::rv_policy::automatic, "(n,) [s] since run() began.")
      .def_prop_ro(
          "has_new_state",
          [](const RunLog& log) {
            return column<bool>(log, [](const RunTick& t) { return t.has_new_state; });
          },
          nb::rv_policy::automatic, "(n,) did the LowState come with this tick?")
      .def_prop_ro(
          "mode",
          [](const RunLog& log) {
            return column<std::int64_t>(log, [](const RunTick& t) { return t.mode; });
          },
          nb::rv_policy::automatic, "(n,) values of Mode: the supervisor's, after the tick.")
      .def_prop_ro(
          "damping_fault",
          [](const RunLog& log) {
            return column<std::int64_t>(log, [](const RunTick& t) { return t.damping_fault; });
          },
          nb::rv_policy::automatic, "(n,) values of FaultId: why the supervisor damped last.")
      .def_prop_ro(
          "reports", [](const RunLog& log) { return bytes(log, &RunTick::state); },
          nb::rv_policy::automatic, "(n, 937) bytes of the newest LowStates.")
      .def_prop_ro(
          "commands", [](const RunLog& log) { return bytes(log, &RunTick::command); },
          nb::rv_policy::automatic, "(n, 734) bytes of the LowCmds that the link was given.");
}
