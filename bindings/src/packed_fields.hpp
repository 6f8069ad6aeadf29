// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstring>

#include "value_class.hpp"

// Binds fields of packed structs. Array fields are numpy views of the struct, so that
// `state.imu.quaternion[0] = 1` writes to the struct and not to a copy.

template <typename T, std::size_t N>
using View = nb::ndarray<nb::numpy, T, nb::shape<static_cast<nb::ssize_t>(N)>>;

// Packed fields are not aligned, so references to them are invalid: use their addresses.
template <typename Struct, typename T, std::size_t N>
void def_array(ValueClass<Struct>& c, const char* name, std::array<T, N> Struct::* member,
               const char* doc) {
  c.template def_field<Eigen::VectorXd>(
      name,
      [member](nb::handle self) {
        Struct& s = nb::cast<Struct&>(self);
        auto* data = reinterpret_cast<T*>(reinterpret_cast<char*>(&(s.*member)));
        return View<T, N>(data, {N}, self);
      },
      [member](Struct& s, FieldName field, nb::handle value) {
        const auto numbers = field_numbers<T, N>(field, value);
        std::memcpy(reinterpret_cast<char*>(&(s.*member)), numbers.data(), sizeof(T) * N);
      },
      doc);
}

template <typename Struct, typename T>
void def_number(ValueClass<Struct>& c, const char* name, T Struct::* member, const char* doc) {
  c.template def_field<T>(
      name, [member](const Struct& s) { return T(s.*member); },
      [member](Struct& s, FieldName field, nb::handle value) {
        s.*member = field_value<T>(field, value);
      },
      doc);
}
