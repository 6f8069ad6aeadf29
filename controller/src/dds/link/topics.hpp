// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

constexpr const char* kCommandTopic = "rt/lowcmd";  ///< LowCmd of Go2 and B2; the host writes it
constexpr const char* kStateTopic = "rt/lowstate";  ///< LowState; the robot writes it

}  // namespace surefoot
