// SPDX-License-Identifier: BSD-3-Clause
// A program for unitree_legged_sdk v3.5 - v3.8, with the structs, UDP class and loop of this SDK.
// One call of Surefoot computes the torques. The structs of both have the same layout.
#include <surefoot/surefoot.hpp>

#if __has_include("unitree_legged_sdk/unitree_legged_sdk.h")
#include <unistd.h>

#include <cstring>

#include "unitree_legged_sdk/unitree_legged_sdk.h"

namespace sdk = UNITREE_LEGGED_SDK;
static_assert(sizeof(sdk::LowState) == sizeof(surefoot::LowState), "not an SDK v3.5 - v3.8");
static_assert(sizeof(sdk::LowCmd) == sizeof(surefoot::LowCmd), "not an SDK v3.5 - v3.8");

int main() {
  const surefoot::Robot robot = surefoot::Robot::load("go1.robot");
  surefoot::StandController controller(robot);
  sdk::Safety safety(sdk::LeggedType::Go1);
  sdk::UDP udp(sdk::LOWLEVEL, 8090, "192.168.123.10", 8007);
  sdk::LowCmd cmd{};
  sdk::LowState state{};
  udp.InitCmdData(cmd);
  const surefoot::LowCmd damping = surefoot::damping_low_cmd(3.0);
  bool tripped = false;
  for (;; usleep(2000)) {
    udp.Recv();
    udp.GetRecv(state);
    surefoot::LowState ours;
    std::memcpy(&ours, &state, sizeof(ours));
    const surefoot::LowCmd command = controller.update(ours);  // damps if LowStates stop
    std::memcpy(&cmd, &command, sizeof(cmd));
    // The vendor's protection forgets a trip within five ticks, so this program latches damping.
    tripped = tripped || safety.PowerProtect(cmd, state, 1) < 0;
    if (tripped) std::memcpy(&cmd, &damping, sizeof(cmd));
    udp.SetSend(cmd);
    udp.Send();
  }
}
#else
int main() { return 0; }  // the vendor's headers are not installed
#endif
