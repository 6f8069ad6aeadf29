// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Words for error messages. Not for the tick.
namespace surefoot {

/// Number as text, round-trip exact.
std::string to_text(double value);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, const char* separator = ", ");

/// " (did you mean 'x'?)" when a valid name is close to the wrong one, else "".
std::string suggestion(std::string_view wrong, const std::vector<std::string>& valid);

}  // namespace surefoot
