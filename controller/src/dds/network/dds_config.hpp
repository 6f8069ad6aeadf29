// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "dds/network/interface_check.hpp"

namespace surefoot {

/// Return the settings of Cyclone DDS for one network interface, as XML. Real-time: no.
std::string dds_config(const NetworkInterface& interface);

}  // namespace surefoot
