// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot {

/// Return the file of a libddsc in this process that has already joined a domain; "" if none has.
///
/// Other packages, such as rclpy and cyclonedds, may have loaded a libddsc of their own.
/// Real-time: no.
std::string library_in_domain(int domain);

}  // namespace surefoot
