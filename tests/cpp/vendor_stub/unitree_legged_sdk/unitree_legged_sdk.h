// SPDX-License-Identifier: BSD-3-Clause
// What examples/vendor_sdk.cpp uses of the vendor's header, with its names; so that the example is
// compiled where that header is not. The structs are ours: the vendor's are checked by the example.
#pragma once

#include "surefoot/low_level.hpp"

namespace UNITREE_LEGGED_SDK {

constexpr std::uint8_t LOWLEVEL = 0xFF;
enum class LeggedType { Aliengo, A1, Go1, B1 };
using LowCmd = surefoot::LowCmd;
using LowState = surefoot::LowState;

class Safety {
 public:
  explicit Safety(LeggedType) {}
  int PowerProtect(LowCmd&, LowState&, int) { return 1; }
};

class UDP {
 public:
  UDP(std::uint8_t, std::uint16_t, const char*, std::uint16_t) {}
  void InitCmdData(LowCmd& cmd) { cmd = surefoot::init_low_cmd(); }
  int Recv() { return 0; }
  int Send() { return 0; }
  void GetRecv(LowState&) {}
  void SetSend(LowCmd&) {}
};

}  // namespace UNITREE_LEGGED_SDK
