// SPDX-License-Identifier: BSD-3-Clause
// Feed random and mutated datagrams to the decoders. Built with sanitizers, without Pinocchio.
// Usage: surefoot_fuzz [DATAGRAMS [SEED]]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#include "surefoot/frames.hpp"
#include "surefoot/wireless_remote.hpp"

using namespace surefoot;

namespace {

struct FuzzCounts {
  long datagrams = 0, recomputed_crcs = 0, accepted = 0, wrong = 0;
};

Generation random_generation(std::mt19937_64& random) {
  return static_cast<Generation>(random() % kGenerations);
}

Frame valid_frame(bool cmd, Generation g, std::mt19937_64& random) {
  Frame frame;
  if (cmd) {
    LowCmd c = init_low_cmd();
    c.motorCmd[random() % kMotorSlots].tau = static_cast<float>(random() % 200) - 100.0F;
    encode_low_cmd(c, {}, g, frame);
  } else {
    LowState s = init_low_state();
    s.tick = static_cast<std::uint32_t>(random());
    encode_low_state(s, {}, g, frame);
  }
  return frame;
}

// Make a valid frame and change bytes, cut or extend it; or make one of random bytes only.
std::vector<std::uint8_t> datagram(bool cmd, Generation g, std::mt19937_64& random) {
  const Frame frame = valid_frame(cmd, g, random);
  std::vector<std::uint8_t> bytes(frame.bytes.begin(), frame.bytes.begin() + frame.size);
  const auto kind = random() % 8;
  if (kind == 0) bytes.resize(random() % 1200);
  if (kind == 1) {
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  }
  for (auto changes = random() % 30; changes > 0 && !bytes.empty(); --changes) {
    bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
  }
  if (kind < 6 && bytes.size() > 3 && g >= Generation::kGo1v38) {
    bytes[0] = 0xFE, bytes[1] = 0xEF, bytes[2] = LOWLEVEL;
  }
  return bytes;
}

bool all_finite(const LowCmd& cmd) {
  for (const MotorCmd& m : cmd.motorCmd) {
    for (const float x : {float(m.q), float(m.dq), float(m.tau), float(m.Kp), float(m.Kd)}) {
      if (!std::isfinite(x)) return false;
    }
  }
  return true;
}

bool all_finite(const LowState& state) {
  const IMU imu = state.imu;
  for (const float x : imu.quaternion) {
    if (!std::isfinite(x)) return false;
  }
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(imu.gyroscope[k] + imu.accelerometer[k] + imu.rpy[k])) {
      if (!std::isfinite(imu.gyroscope[k]) || !std::isfinite(imu.accelerometer[k]) ||
          !std::isfinite(imu.rpy[k])) {
        return false;
      }
    }
  }
  for (const MotorState& m : state.motorState) {
    for (const float x : {float(m.q), float(m.dq), float(m.ddq), float(m.tauEst), float(m.q_raw),
                          float(m.dq_raw), float(m.ddq_raw)}) {
      if (!std::isfinite(x)) return false;
    }
  }
  return true;
}

// Check that an accepted datagram is finite and encodes to the same bytes.
template <typename Struct, typename Decode, typename Encode>
void check_datagram(const std::vector<std::uint8_t>& bytes, Generation g, Decode decode,
                    Encode encode, FuzzCounts& seen) {
  // A copy of exactly this size, so that the address sanitizer detects a read past the end.
  const std::vector<std::uint8_t> exact(bytes);
  Struct decoded{};
  FrameExtras extras;
  if (decode(exact.data(), exact.size(), g, decoded, extras).status != FrameStatus::kOk) return;
  ++seen.accepted;
  Frame back;
  const bool same = encode(decoded, extras, g, back).status == FrameStatus::kOk &&
                    back.size == exact.size() &&
                    std::memcmp(back.bytes.data(), exact.data(), exact.size()) == 0;
  if (!same || !all_finite(decoded)) ++seen.wrong;
  const WirelessRemote remote = decode_wireless_remote(decoded.wirelessRemote);
  if (!std::isfinite(remote.lx + remote.ly + remote.rx + remote.ry + remote.L2)) ++seen.wrong;
}

}  // namespace

int main(int argc, char** argv) {
  const long count = argc > 1 ? std::atol(argv[1]) : 100000;
  std::mt19937_64 random(argc > 2 ? std::atol(argv[2]) : 1);
  FuzzCounts seen;
  while (seen.datagrams < count) {
    const bool cmd = random() % 2 == 0;
    const Generation sent_generation = random_generation(random),
                     decoded_generation =
                         random() % 8 == 0 ? random_generation(random) : sent_generation;
    std::vector<std::uint8_t> bytes = datagram(cmd, sent_generation, random);
    if (random() % 4 != 0 && bytes.size() >= 4) {
      const std::uint32_t crc = crc32(bytes.data(), bytes.size() - 4);
      std::memcpy(bytes.data() + bytes.size() - 4, &crc, 4);
      ++seen.recomputed_crcs;
    }
    ++seen.datagrams;
    if (cmd) {
      check_datagram<LowCmd>(bytes, decoded_generation, decode_low_cmd, encode_low_cmd, seen);
    } else {
      check_datagram<LowState>(bytes, decoded_generation, decode_low_state, encode_low_state, seen);
    }
  }
  std::printf("%ld datagrams, %ld CRCs recomputed, %ld accepted, %ld accepted wrongly\n",
              seen.datagrams, seen.recomputed_crcs, seen.accepted, seen.wrong);
  const bool enough = 2 * seen.recomputed_crcs >= seen.datagrams && seen.accepted > count / 100;
  return seen.wrong == 0 && enough ? 0 : 1;
}
