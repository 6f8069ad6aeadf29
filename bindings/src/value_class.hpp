// SPDX-License-Identifier: BSD-3-Clause
// Classes of plain values: copy, deepcopy, pickle, == and repr() from the list of bound fields.
#pragma once

#include <functional>

#include "field_values.hpp"

/// Field of a value class, without the C++ type of the class.
struct ValueField {
  std::string name;
  std::function<nb::object(nb::handle self)> get;              ///< read the field
  std::function<void(nb::handle self, nb::handle value)> set;  ///< write the field, for pickle
};

/// Name and fields of a value class, in the order of their binding.
struct ValueType {
  const char* name = "";
  std::vector<ValueField> fields;
  std::function<std::string(nb::handle self)> repr;  ///< instead of that of all fields
  /// [bytes] Size of a packed struct, which is compared and pickled as bytes; 0: not packed.
  std::size_t packed_size = 0;
};

/// Return the state for pickle: the bytes of a packed struct, else a dict of all fields.
nb::object value_state(const ValueType& type, nb::handle self);
/// Write a state. Raises Error if it was pickled by a version with other fields.
void set_value_state(const ValueType& type, nb::handle self, nb::handle state);
/// Return whether two values of one class are equal: all bytes of packed structs, else all fields.
/// NaN equals NaN, so that a copy equals its original.
bool equal_values(const ValueType& type, nb::handle a, nb::handle b);
/// Return the text of a field's value for repr(): enumerators by name, large arrays by shape.
std::string value_text(nb::handle value);
/// Return "Name(field=value, ...)".
std::string value_repr(const ValueType& type, nb::handle self);
/// Return a copy, also of a Python subclass. `memo`: that of deepcopy, or None.
nb::object copy_value(nb::handle self, nb::handle memo);
/// Return the attributes that a Python subclass adds, as a dict; None for a bound class.
nb::object added_attributes(nb::handle self);

/// Binding of a class of plain values.
///
/// Fields bound with def_rw(), def_ro(), def_field() and def_part() make copy, deepcopy, pickle,
/// == and repr(). Values are mutable, so they have no hash. A Python subclass keeps its attributes.
template <typename T>
class ValueClass : public nb::class_<T> {
  using Base = nb::class_<T>;

 public:
  ValueClass(nb::handle scope, const char* name, const char* doc) : Base(scope, name, doc) {
    type().name = name;
    if (std::is_trivially_copyable_v<T> && alignof(T) == 1) type().packed_size = sizeof(T);
    using Copy = nb::typed<nb::object, T>;
    Base::def("__copy__",
              [](nb::handle self) { return Copy(copy_value(checked(self), nb::none())); });
    Base::def(
        "__deepcopy__",
        [](nb::handle self, const nb::dict& memo) { return Copy(copy_value(checked(self), memo)); },
        nb::arg("memo"));
    Base::def("__getstate__", [](nb::handle self) {
      return nb::make_tuple(value_state(type(), checked(self)), added_attributes(self));
    });
    Base::def("__setstate__", &ValueClass::set_state, nb::arg("state"));
    Base::def(
        "__eq__",
        [](nb::handle self, nb::handle other) -> nb::object {
          if (!self.type().is(other.type())) return nb::borrow(Py_NotImplemented);
          return nb::bool_(equal_values(type(), checked(self), other));
        },
        nb::sig("def __eq__(self, other: object, /) -> bool"));
    Base::attr("__hash__") = nb::none();
    Base::def("__repr__", [](nb::handle self) { return value_repr(type(), checked(self)); });
  }

  template <typename... Args>
  ValueClass& def(Args&&... args) {
    Base::def(std::forward<Args>(args)...);
    return *this;
  }
  template <typename... Args>
  ValueClass& def_prop_ro(Args&&... args) {
    Base::def_prop_ro(std::forward<Args>(args)...);
    return *this;
  }
  /// Bind a field of type M: `set` gets the struct, the name of the field and the assigned value.
  template <typename M, typename Get, typename Set>
  ValueClass& def_field(const char* name, Get get, Set set, const char* doc) {
    const std::string signature =
        std::string("def ") + name + "(self, value: " + signature_of<M>() + ", /) -> None";
    // nanobind would refuse None itself, without the name of the field.
    Base::def_prop_rw(
        name, get,
        [set, key = std::string(name)](T& self, nb::handle value) {
          set(self, FieldName{type().name, key.c_str()}, value);
        },
        nb::for_setter(nb::sig(signature.c_str())), nb::for_setter(nb::arg("value").none()), doc);
    return def_part(name, read_attribute(name),
                    [key = std::string(name)](nb::handle self, nb::handle value) {
                      nb::setattr(self, key.c_str(), value);
                    });
  }
  /// Bind a writable member.
  template <typename M>
  ValueClass& def_rw(const char* name, M T::* member, const char* doc) {
    return def_field<M>(
        name, [member](const T& self) -> const M& { return self.*member; },
        [member](T& self, FieldName field, nb::handle value) {
          self.*member = field_value<M>(field, value);
        },
        doc);
  }
  /// Bind a member that only pickle writes.
  template <typename M, typename... Extra>
  ValueClass& def_ro(const char* name, M T::* member, const Extra&... extra) {
    Base::def_ro(name, member, extra...);
    return def_part(name, read_attribute(name),
                    [member, key = std::string(name)](nb::handle self, nb::handle value) {
                      nb::cast<T&>(self).*member =
                          field_value<M>({type().name, key.c_str()}, value);
                    });
  }
  /// Replace repr(), for values whose fields are many.
  template <typename Repr>
  ValueClass& def_repr(Repr repr) {
    type().repr = [repr](nb::handle self) { return repr(nb::cast<const T&>(self)); };
    return *this;
  }
  /// Add a field that is not an attribute, or whose attribute cannot be assigned.
  template <typename Get, typename Set>
  ValueClass& def_part(const char* name, Get get, Set set) {
    type().fields.push_back({name, std::move(get), std::move(set)});
    return *this;
  }

 private:
  static ValueType& type() {
    static ValueType type;
    return type;
  }
  static auto read_attribute(const char* name) {
    return [key = std::string(name)](nb::handle self) -> nb::object {
      return nb::getattr(self, key.c_str());
    };
  }
  // The methods take handles, so that they keep the type of a Python subclass. nanobind checks no
  // handle: a call through the class, as in Gains.__copy__(5), may pass anything.
  static nb::handle checked(nb::handle self) {
    if (!nb::isinstance<T>(self)) refuse_value({type().name, "self"}, self, ValueText<T>::text());
    return self;
  }
  static void set_state(nb::handle self, const nb::tuple& state) {
    checked(self);
    if (!nb::inst_ready(self)) {
      new (nb::inst_ptr<T>(self)) T();
      nb::inst_mark_ready(self);
    }
    set_value_state(type(), self, state[0]);
    if (!state[1].is_none()) self.attr("__dict__").attr("update")(state[1]);
  }
};
