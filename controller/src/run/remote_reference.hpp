// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/body_reference.hpp"
#include "surefoot/wireless_remote.hpp"

namespace surefoot {

/// Convert the remote's sticks and buttons to a body reference. The left stick shifts the body; the
/// right stick changes pitch and yaw. The buttons up and down change the height; the buttons left
/// and right change roll. With the remote at rest, the result is the latched pose. Real-time: yes.
BodyReference remote_reference(const WirelessRemote& remote) noexcept;

}  // namespace surefoot
