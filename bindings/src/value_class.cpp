// SPDX-License-Identifier: BSD-3-Clause
#include "value_class.hpp"

#include <cstring>

#include "surefoot/error.hpp"

namespace {

// Largest number of elements that repr() prints of an array; of a larger one it prints the shape.
constexpr std::size_t kMaxReprSize = 24;

bool is_array(nb::handle value) { return nb::hasattr(value, "dtype"); }

bool same(nb::handle a, nb::handle b) {
  if (PyFloat_Check(a.ptr()) && PyFloat_Check(b.ptr())) {
    const double x = PyFloat_AS_DOUBLE(a.ptr()), y = PyFloat_AS_DOUBLE(b.ptr());
    return x == y || (std::isnan(x) && std::isnan(y));
  }
  if (is_array(a) && is_array(b)) {
    return nb::cast<bool>(nb::module_::import_("numpy").attr("array_equal")(
        a, b, nb::arg("equal_nan") = nb::str(a.attr("dtype").attr("kind")).equal(nb::str("f"))));
  }
  if (nb::isinstance<nb::list>(a) && nb::isinstance<nb::list>(b)) {
    const std::size_t size = nb::len(a);
    if (size != nb::len(b)) return false;
    for (std::size_t k = 0; k < size; ++k) {
      if (!same(nb::object(a[k]), nb::object(b[k]))) return false;
    }
    return true;
  }
  return a.equal(b);
}

std::uint8_t* bytes_of(nb::handle self) { return nb::inst_ptr<std::uint8_t>(self); }

}  // namespace

nb::object value_state(const ValueType& type, nb::handle self) {
  if (type.packed_size > 0) return nb::bytes(bytes_of(self), type.packed_size);
  nb::dict state;
  for (const ValueField& field : type.fields) state[field.name.c_str()] = field.get(self);
  return state;
}

void set_value_state(const ValueType& type, nb::handle self, nb::handle state) {
  const std::string pickled = std::string(type.name) + ": got a pickle of another version: ";
  const std::string remedy = "; unpickle it with the version of Surefoot that pickled it";
  if (type.packed_size > 0) {
    const nb::bytes bytes = nb::cast<nb::bytes>(state);
    if (bytes.size() != type.packed_size) {
      throw surefoot::Error(pickled + std::to_string(bytes.size()) + " bytes, expected " +
                            std::to_string(type.packed_size) + remedy);
    }
    std::memcpy(bytes_of(self), bytes.c_str(), bytes.size());
    return;
  }
  const nb::dict values = nb::cast<nb::dict>(state);
  for (const ValueField& field : type.fields) {
    if (!values.contains(field.name.c_str())) {
      throw surefoot::Error(pickled + "expected field " + field.name + remedy);
    }
  }
  if (values.size() != type.fields.size()) {
    throw surefoot::Error(pickled + std::to_string(values.size()) + " fields, expected " +
                          std::to_string(type.fields.size()) + remedy);
  }
  for (const ValueField& field : type.fields) {
    field.set(self, nb::object(values[field.name.c_str()]));
  }
}

bool equal_values(const ValueType& type, nb::handle a, nb::handle b) {
  if (!added_attributes(a).equal(added_attributes(b))) return false;
  if (type.packed_size > 0) return std::memcmp(bytes_of(a), bytes_of(b), type.packed_size) == 0;
  for (const ValueField& field : type.fields) {
    if (!same(field.get(a), field.get(b))) return false;
  }
  return true;
}

std::string value_text(nb::handle value) {
  if (nb::hasattr(value, "name") && nb::hasattr(value.type(), "__members__")) {
    return nb::cast<std::string>(value.type().attr("__name__")) + "." +
           nb::cast<std::string>(value.attr("name"));
  }
  if (is_array(value)) {
    if (nb::cast<std::size_t>(value.attr("size")) > kMaxReprSize) {
      return std::string("<array of shape ") + nb::repr(value.attr("shape")).c_str() + ">";
    }
    return value_text(value.attr("tolist")());
  }
  if (!nb::isinstance<nb::list>(value)) return nb::repr(value).c_str();
  std::string text = "[";
  for (const nb::handle element : value) {
    text += (text.size() > 1 ? ", " : "") + value_text(element);
  }
  return text + "]";
}

std::string value_repr(const ValueType& type, nb::handle self) {
  if (type.repr) return type.repr(self);
  std::string text = std::string(type.name) + "(";
  for (const ValueField& field : type.fields) {
    if (text.back() != '(') text += ", ";
    text += field.name + "=" + value_text(field.get(self));
  }
  return text + ")";
}

nb::object copy_value(nb::handle self, nb::handle memo) {
  nb::object copy = nb::inst_alloc(self.type());
  nb::inst_copy(copy, self);
  nb::object added = added_attributes(self);
  if (added.is_none()) return copy;
  if (!memo.is_none()) added = nb::module_::import_("copy").attr("deepcopy")(added, memo);
  copy.attr("__dict__").attr("update")(added);
  return copy;
}

nb::object added_attributes(nb::handle self) { return nb::getattr(self, "__dict__", nb::none()); }
