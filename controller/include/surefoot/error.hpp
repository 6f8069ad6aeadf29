// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace surefoot {

/// Error while a robot or a controller is built, loaded or configured. A tick never throws this
/// error.
///
/// The message says what is wrong, what was got, what was expected, and which names are valid.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace surefoot
