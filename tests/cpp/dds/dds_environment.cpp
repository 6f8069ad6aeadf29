// SPDX-License-Identifier: BSD-3-Clause
#include "dds_environment.hpp"

#include <unistd.h>

#include <cstdlib>

#include "dds/ddsc/library.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

std::string test_library() {
  const char* const path = std::getenv("SUREFOOT_LIBDDSC");
  return path == nullptr ? "" : path;
}

int test_domain() { return 20 + static_cast<int>(getpid() % 200); }

std::shared_ptr<DdsNetwork> test_network() {
  return std::make_shared<DdsNetwork>(
      DdsNetworkOptions{"lo", test_domain(), false, test_library(), false});
}

namespace {

boost::test_tools::assertion_result loads(const std::string& library) {
  try {
    load_dds_library(library, false);
    return true;
  } catch (const Error& error) {
    boost::test_tools::assertion_result skipped(false);
    skipped.message() << error.what();
    return skipped;
  }
}

}  // namespace

boost::test_tools::assertion_result has_libddsc(boost::unit_test::test_unit_id) {
  return loads(test_library());
}
boost::test_tools::assertion_result has_system_libddsc(boost::unit_test::test_unit_id) {
  const boost::test_tools::assertion_result result = loads(kSystemLibrary);
  if (!result || !loads(test_library())) return result;
  const bool same =
      load_dds_library(kSystemLibrary, false).path == load_dds_library(test_library(), false).path;
  boost::test_tools::assertion_result other(!same);
  other.message() << "libddsc of the system is the one under test";
  return other;
}

}  // namespace surefoot
