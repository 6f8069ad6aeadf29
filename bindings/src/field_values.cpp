// SPDX-License-Identifier: BSD-3-Clause
#include "field_values.hpp"

namespace {

// [characters] Longest text of a value in a message; the rest is cut off.
constexpr std::size_t kMaxValueText = 60;

std::string prefix(FieldName name) { return std::string(name.type) + "." + name.field + ": got "; }

std::string shape_text(const std::vector<long>& shape) {
  std::string text = "(";
  for (const long length : shape) {
    text += (length < 0 ? "n" : std::to_string(length)) + (shape.size() == 1 ? "," : ", ");
  }
  if (shape.size() > 1) text.resize(text.size() - 2);
  return text + ")";
}

// Return the value as an array; an invalid object if it is a single number or no numbers.
nb::object number_array(const nb::module_& numpy, nb::handle value) {
  try {
    const nb::object array = numpy.attr("asarray")(value);
    const auto kind = nb::cast<char>(array.attr("dtype").attr("kind"));
    const bool is_number = kind == 'b' || kind == 'i' || kind == 'u' || kind == 'f';
    return is_number && nb::cast<int>(array.attr("ndim")) > 0 ? array : nb::object();
  } catch (const nb::python_error&) {  // numpy refuses lists of unequal lengths
    return nb::object();
  }
}

}  // namespace

void refuse_value(FieldName name, nb::handle value, const std::string& expected) {
  std::string text = nb::repr(value).c_str();
  if (text.size() > kMaxValueText) text = text.substr(0, kMaxValueText) + "...";
  const nb::str type = nb::type_name(value.type());
  throw nb::type_error(
      (prefix(name) + text + " (" + type.c_str() + "), expected " + expected).c_str());
}

Numbers numbers_of(FieldName name, nb::handle value, const std::vector<long>& shape) {
  const nb::module_ numpy = nb::module_::import_("numpy");
  const nb::object array = number_array(numpy, value);
  if (!array.is_valid()) refuse_value(name, value, "numbers of shape " + shape_text(shape));
  auto numbers = nb::cast<Numbers>(numpy.attr("ascontiguousarray")(array, "float64"));
  std::vector<long> got;
  for (std::size_t k = 0; k < numbers.ndim(); ++k)
    got.push_back(static_cast<long>(numbers.shape(k)));
  bool fits = got.size() == shape.size();
  for (std::size_t k = 0; fits && k < shape.size(); ++k) fits = shape[k] < 0 || got[k] == shape[k];
  if (fits) return numbers;
  throw nb::value_error(
      (prefix(name) + "shape " + shape_text(got) + ", expected " + shape_text(shape)).c_str());
}

void refuse_integer(FieldName name, double number, double minimum, double maximum) {
  const auto text = [](double value) { return std::string(nb::repr(nb::float_(value)).c_str()); };
  const auto integer = [](double value) { return std::to_string(static_cast<long long>(value)); };
  throw nb::value_error((prefix(name) + text(number) + ", expected whole numbers " +
                         integer(minimum) + " .. " + integer(maximum))
                            .c_str());
}

std::string enum_text(nb::handle type) {
  std::string text;
  for (const nb::handle member : type) {
    text += (text.empty() ? "" : ", ") + nb::cast<std::string>(member.attr("name"));
  }
  return "a " + std::string(nb::type_name(type).c_str()) + ": " + text;
}
