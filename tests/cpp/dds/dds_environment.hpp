// SPDX-License-Identifier: BSD-3-Clause
// What the tests over DDS need of this machine.
#pragma once

#include <boost/test/unit_test.hpp>
#include <memory>
#include <string>

#include "surefoot/dds_network.hpp"

namespace surefoot {

/// Return the file of libddsc: that of SUREFOOT_LIBDDSC, else "", which means to search for it.
std::string test_library();

/// Return a domain that no other test process uses at the same time.
int test_domain();

/// Join test_domain() on lo.
std::shared_ptr<DdsNetwork> test_network();

/// Enables a test only if libddsc can be loaded; otherwise the report names the skipped test.
boost::test_tools::assertion_result has_libddsc(boost::unit_test::test_unit_id);

/// libddsc of Debian 12, version 0.10.2, package libddsc0debian.
constexpr const char* kSystemLibrary = "libddsc.so.0debian";
/// Enables a test only if kSystemLibrary can be loaded and is not test_library().
boost::test_tools::assertion_result has_system_libddsc(boost::unit_test::test_unit_id);

}  // namespace surefoot
