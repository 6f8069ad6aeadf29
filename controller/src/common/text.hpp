// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Helpers for the text of error messages. Real-time: no.
namespace surefoot {

/// Return a number as text that converts back to the same number.
std::string to_text(double value);

/// Join words to one text, such as "a, b, c".
std::string join(const std::vector<std::string>& words, const char* separator = ", ");

/// Return " (did you mean 'x'?)" if a valid name x is similar to the wrong name, otherwise "".
std::string suggestion(std::string_view wrong, const std::vector<std::string>& valid);

}  // namespace surefoot
