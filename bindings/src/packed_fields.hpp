// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/ndarray.h>

#include <array>
#include <cstring>

// Binds fields of packed structs. Array fields are numpy views of the struct, so that
// `state.imu.quaternion[0] = 1` writes to the struct and not to a copy.

namespace nb = nanobind;

template <typename T, std::size_t N>
using View = nb::ndarray<nb::numpy, T, nb::shape<static_cast<nb::ssize_t>(N)>>;

// Packed fields are not aligned, so references to them are invalid: use their addresses.
template <typename Struct, typename T, std::size_t N>
void def_array(nb::class_<Struct>& c, const char* name, std::array<T, N> Struct::* member,
               const char* doc) {
  c.def_prop_rw(
      name,
      [member](nb::handle self) {
        Struct& s = nb::cast<Struct&>(self);
        auto* data = reinterpret_cast<T*>(reinterpret_cast<char*>(&(s.*member)));
        return View<T, N>(data, {N}, self);
      },
      [member](Struct& s, const nb::ndarray<const T, nb::shape<static_cast<nb::ssize_t>(N)>,
                                            nb::c_contig, nb::device::cpu>& values) {
        std::memcpy(reinterpret_cast<char*>(&(s.*member)), values.data(), sizeof(T) * N);
      },
      doc);
}

template <typename Struct, typename T>
void def_number(nb::class_<Struct>& c, const char* name, T Struct::* member, const char* doc) {
  c.def_prop_rw(
      name, [member](const Struct& s) { return T(s.*member); },
      [member](Struct& s, T value) { s.*member = value; }, doc);
}
