// SPDX-License-Identifier: BSD-3-Clause
// Conversion of Python objects to the values of fields, with errors that name class and field.
#pragma once

#include <nanobind/eigen/dense.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace nb = nanobind;

/// Field of a class, as messages name it: "RobotState.q".
struct FieldName {
  const char* type;
  const char* field;
};

/// Raise TypeError "<class>.<field>: got <value and its type>, expected <expected>".
[[noreturn]] void refuse_value(FieldName name, nb::handle value, const std::string& expected);

/// Numbers that were assigned to an array field, in row-major order.
using Numbers = nb::ndarray<const double, nb::numpy, nb::c_contig, nb::device::cpu>;

/// Convert anything that numpy converts to an array of numbers: arrays, lists, tuples, nested
/// lists.
///
/// @param shape expected shape; -1 is any length
/// Raises TypeError if `value` is no array of numbers, ValueError if it has another shape.
Numbers numbers_of(FieldName name, nb::handle value, const std::vector<long>& shape);

/// Raise ValueError, because a number of an array field is no integer or out of range.
[[noreturn]] void refuse_integer(FieldName name, double number, double minimum, double maximum);

/// Convert to the numbers of a packed array field. Integer fields accept only whole numbers in
/// their range.
template <typename T, std::size_t N>
std::array<T, N> field_numbers(FieldName name, nb::handle value,
                               const std::vector<long>& shape = {static_cast<long>(N)}) {
  const Numbers from = numbers_of(name, value, shape);
  std::array<T, N> converted;
  for (std::size_t k = 0; k < N; ++k) {
    const double number = from.data()[k];
    if constexpr (std::is_integral_v<T>) {
      using Limits = std::numeric_limits<T>;
      if (!(number >= Limits::min() && number <= Limits::max() && number == std::trunc(number))) {
        refuse_integer(name, number, Limits::min(), Limits::max());
      }
    }
    converted[k] = static_cast<T>(number);
  }
  return converted;
}

/// Return the names of an enumeration's members, as in "a Mode: PASSIVE, RISE".
std::string enum_text(nb::handle type);

template <typename M, typename = void>
struct ValueText {
  static std::string text() {
    const nb::handle type = nb::type<M>();
    if constexpr (std::is_enum_v<M>) return enum_text(type);
    return "a " + std::string(nb::type_name(type).c_str());
  }
};
template <typename M>
struct ValueText<M, std::enable_if_t<std::is_arithmetic_v<M>>> {
  static std::string text() {
    if (std::is_same_v<M, bool>) return "True or False";
    if (!std::is_integral_v<M>) return "a number";
    return "a whole number " + std::to_string(std::numeric_limits<M>::min()) + " .. " +
           std::to_string(std::numeric_limits<M>::max());
  }
};
template <>
struct ValueText<std::string> {
  static std::string text() { return "a text"; }
};
template <typename E, std::size_t N>
struct ValueText<std::array<E, N>> {
  static std::string text() {
    return "a list of " + std::to_string(N) + ", each " + ValueText<E>::text();
  }
};

/// Convert a Python object to the value of a field. Raises TypeError or ValueError, which name the
/// field, what was got and what is expected.
template <typename M>
M field_value(FieldName name, nb::handle value) {
  if constexpr (nb::detail::is_eigen_plain_v<M>) {
    constexpr long kRows = M::RowsAtCompileTime, kCols = M::ColsAtCompileTime;
    const bool is_vector = kCols == 1;
    const Numbers numbers = numbers_of(
        name, value, is_vector ? std::vector<long>{kRows} : std::vector<long>{kRows, kCols});
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(numbers.data(), numbers.shape(0),
                                      is_vector ? 1 : numbers.shape(1));
  } else {
    M converted{};
    if (!nb::try_cast(value, converted)) refuse_value(name, value, ValueText<M>::text());
    return converted;
  }
}

/// Return the Python type of a field, for the signature of its setter.
template <typename M>
std::string signature_of() {
  if constexpr (std::is_same_v<M, bool>) {
    return "bool";
  } else if constexpr (std::is_arithmetic_v<M>) {
    return std::is_integral_v<M> ? "int" : "float";
  } else if constexpr (std::is_same_v<M, std::string>) {
    return "str";
  } else if constexpr (nb::detail::is_eigen_plain_v<M>) {
    return "numpy.typing.ArrayLike";  // lists too
  } else if constexpr (nb::detail::is_base_caster_v<nb::detail::make_caster<M>> ||
                       std::is_enum_v<M>) {
    return nb::cast<std::string>(nb::type<M>().attr("__qualname__"));
  } else {
    return "collections.abc.Sequence[" + signature_of<typename M::value_type>() + "]";
  }
}

/// Argument of a constructor that is converted by field_value(), so that its error names the field.
/// Signatures show it as M.
template <typename M>
struct FieldArgument {
  nb::handle value;
  M to(const char* type, const char* field) const { return field_value<M>({type, field}, value); }
};

namespace nanobind::detail {
template <typename M>
struct type_caster<FieldArgument<M>> {
  NB_TYPE_CASTER(FieldArgument<M>, make_caster<M>::Name)
  bool from_python(handle source, uint32_t, cleanup_list*) noexcept {
    value.value = source;
    return true;
  }
};
}  // namespace nanobind::detail
