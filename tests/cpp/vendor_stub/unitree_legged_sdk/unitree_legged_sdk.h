// SPDX-License-Identifier: BSD-3-Clause
// The part of the vendor's header that examples/vendor_sdk.cpp uses, with the vendor's names. It
// allows the example to compile without that header. The structs are Surefoot's; the example itself
// checks the vendor's.
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
