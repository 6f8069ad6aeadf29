// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "dds/ddsc/ddsc.hpp"

namespace surefoot {

/// A libddsc that was loaded into this process. It is never unloaded, because its threads may still
/// run.
struct DdsLibrary {
  ddsc::Functions functions;
  std::string path;     ///< file of the library
  std::string version;  ///< such as "11.0.1"; "unknown" if the file does not tell it
};

/// Load libddsc. Its symbols stay local, so that another libddsc in the process does no harm.
/// Real-time: no.
///
/// @param path file of the library. "": that of the Python package cyclonedds beside the package
/// surefoot, else that of the system
/// @param allow_untested true: load any version, not only tested_library_versions()
/// Throws surefoot::Error if there is no such library, if it lacks a function, or if its version is
/// not tested.
DdsLibrary load_dds_library(const std::string& path, bool allow_untested);

}  // namespace surefoot
