// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot {

/// Return the version of the libddsc in a file, such as "11.0.1"; "" if the file does not tell it.
///
/// The version is the ending of the real file name, as in libddsc.so.0.10.2, or a text of three
/// numbers inside the file: libddsc has no function that returns it. Real-time: no.
std::string library_version(const std::string& path);

/// Versions of libddsc that the tests of Surefoot have run with, separated by ", ". The wheel
/// cyclonedds 0.10.2 holds a libddsc that names itself 0.11.0.
std::string tested_library_versions();

/// Return whether a version is one of tested_library_versions().
bool is_tested_library_version(const std::string& version);

}  // namespace surefoot
