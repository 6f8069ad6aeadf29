// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace surefoot {

/// Thrown while building, loading or configuring; never inside a tick.
///
/// The message says what is wrong, what was got, what was expected, and the valid names.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace surefoot
