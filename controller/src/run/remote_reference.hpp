// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/body_reference.hpp"
#include "surefoot/wireless_remote.hpp"

namespace surefoot {

/// Where the remote asks the body to be: the left stick shifts it, the right one pitches and turns
/// it, up and down raise and lower it, left and right roll it. At rest it asks for the latched
/// pose. Real-time: yes.
BodyReference remote_reference(const WirelessRemote& remote) noexcept;

}  // namespace surefoot
