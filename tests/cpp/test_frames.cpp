// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include "surefoot/error.hpp"
#include "surefoot/frames.hpp"

using namespace surefoot;

namespace {

using G = Generation;
constexpr G kAll[] = {G::kA1v33, G::kGo1v34, G::kGo1v38, G::kB1v38};

std::uint32_t crc_of(G generation, const std::function<void(LowCmd&)>& change) {
  LowCmd cmd = init_low_cmd();
  change(cmd);
  Frame frame;
  BOOST_REQUIRE((encode_low_cmd(cmd, {}, generation, frame).status == FrameStatus::kOk));
  std::uint32_t crc;
  std::memcpy(&crc, frame.bytes.data() + frame.size - 4, 4);
  return crc;
}

// CRCs that the vendor's libraries send, for one change each of the initial command.
struct CrcCase {
  std::function<void(LowCmd&)> change;
  std::uint32_t a1, go1, b1;
};
const CrcCase kCrcCases[] = {
    {[](LowCmd&) {}, 0x1359692f, 0x347ff0e2, 0x347ff0e2},
    {[](LowCmd& c) { c.motorCmd[0].tau = -0.65F; }, 0xccd8b716, 0x9e3eac09, 0x252512c1},
    {[](LowCmd& c) { c.motorCmd[0].tau = 5.0F; }, 0xe35728e6, 0x138ccdb9, 0x1000619f},
    {[](LowCmd& c) { c.motorCmd[0].Kp = 20.0F; }, 0xd6063b01, 0x6319b924, 0x6319b924},
    {[](LowCmd& c) { c.motorCmd[0].Kd = 4.0F; }, 0x9b6c92f7, 0xdeb92e8f, 0xdeb92e8f},
    {[](LowCmd& c) { c.motorCmd[0].q = 1.5F; }, 0x31b7bf75, 0x9cf2bd92, 0x9cf2bd92},
    {[](LowCmd& c) { c.motorCmd[0].dq = -2.5F; }, 0xaee9f926, 0x9baad35f, 0x9baad35f},
    {[](LowCmd& c) { c.motorCmd[0].mode = 0; }, 0x27b24527, 0xb017ef4f, 0xb017ef4f},
    {[](LowCmd& c) { c.motorCmd[11].q = 1.5F; }, 0x9bf78374, 0xce20e26d, 0xce20e26d},
    {[](LowCmd& c) { c.wirelessRemote[0] = 0xAB; }, 0x23d713d2, 0x04f18a1f, 0x04f18a1f},
};

void write_crc(std::vector<std::uint8_t>& bytes) {
  const std::uint32_t crc = crc32(bytes.data(), bytes.size() - 4);
  std::memcpy(bytes.data() + bytes.size() - 4, &crc, 4);
}

// Make a frame of random bytes with a valid envelope and finite floats.
std::vector<std::uint8_t> random_valid_frame(std::size_t size, bool head, int first_motor,
                                             int motor_size, int imu, std::mt19937& random) {
  std::vector<std::uint8_t> bytes(size);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  if (head) bytes[0] = 0xFE, bytes[1] = 0xEF, bytes[2] = LOWLEVEL;
  const auto put = [&](int at) {
    const float value = std::uniform_real_distribution<float>(-9.0F, 9.0F)(random);
    std::memcpy(bytes.data() + at, &value, 4);
  };
  for (int k = 0; imu >= 0 && k < 13; ++k) put(imu + 4 * k);
  for (int m = 0; m < kMotorSlots; ++m) {
    const int motor = first_motor + m * motor_size;
    for (const int at : {1, 5}) put(motor + at);
    for (const int at : {13, 17}) {
      if (motor_size == 32) put(motor + at);
    }
  }
  write_crc(bytes);
  return bytes;
}

int header_size(G g) { return g == G::kA1v33 || g == G::kGo1v34 ? 10 : 22; }

}  // namespace

BOOST_AUTO_TEST_SUITE(frames)

BOOST_AUTO_TEST_CASE(crcs_match_the_vendor_libraries) {
  for (const CrcCase& v : kCrcCases) {
    BOOST_TEST(crc_of(G::kA1v33, v.change) == v.a1);
    BOOST_TEST(crc_of(G::kGo1v38, v.change) == v.go1);
    BOOST_TEST(crc_of(G::kB1v38, v.change) == v.b1);
  }
  const auto battery = [](LowCmd& c) { c.bms.off = 0xA5; };
  BOOST_TEST(crc_of(G::kGo1v38, battery) == 0xfa432f03);
  BOOST_TEST(crc_of(G::kB1v38, battery) == 0xfa432f03);
  const std::uint8_t zeros[8] = {};
  BOOST_TEST(crc32(zeros, 8) == 0x6904bb59);
  BOOST_TEST(crc32(reinterpret_cast<const std::uint8_t*>("12345678"), 8) == 0xfefc54f9);
}

BOOST_AUTO_TEST_CASE(valid_frames_round_trip_bit_for_bit) {
  std::mt19937 random(1);
  for (const G g : kAll) {
    for (int round = 0; round < 200; ++round) {
      const bool head = header_size(g) == 22;
      const auto cmd_bytes =
          random_valid_frame(low_cmd_size(g), head, header_size(g), 27, -1, random);
      LowCmd cmd;
      FrameExtras extras;
      Frame frame;
      BOOST_REQUIRE((decode_low_cmd(cmd_bytes.data(), cmd_bytes.size(), g, cmd, extras).status ==
                     FrameStatus::kOk));
      BOOST_REQUIRE((encode_low_cmd(cmd, extras, g, frame).status == FrameStatus::kOk));
      BOOST_REQUIRE(std::equal(cmd_bytes.begin(), cmd_bytes.end(), frame.bytes.begin()));
      const auto state_bytes = random_valid_frame(low_state_size(g), head, header_size(g) + 53, 32,
                                                  header_size(g), random);
      LowState state;
      BOOST_REQUIRE(
          (decode_low_state(state_bytes.data(), state_bytes.size(), g, state, extras).status ==
           FrameStatus::kOk));
      BOOST_REQUIRE((encode_low_state(state, extras, g, frame).status == FrameStatus::kOk));
      BOOST_REQUIRE(std::equal(state_bytes.begin(), state_bytes.end(), frame.bytes.begin()));
    }
  }
}

BOOST_AUTO_TEST_CASE(out_of_range_values_saturate_and_are_reported) {
  const struct {
    float MotorCmd::* field;
    float value, go1, b1;
  } cases[] = {{&MotorCmd::tau, 128.0F, 127.99609375F, 128.0F},
               {&MotorCmd::tau, -1e9F, -128.0F, -256.0F},
               {&MotorCmd::Kp, 1e6F, 2047.96875F, 2047.96875F},
               {&MotorCmd::Kp, -1.0F, 0.0F, 0.0F},
               {&MotorCmd::Kd, 5000.0F, 4095.9375F, 4095.9375F}};
  for (const auto& c : cases) {
    for (const G g : kAll) {
      LowCmd cmd = init_low_cmd(), back;
      FrameExtras extras;
      Frame frame;
      cmd.motorCmd[7].*c.field = c.value;
      const FrameReport report = encode_low_cmd(cmd, {}, g, frame);
      const float expected = g == G::kB1v38 ? c.b1 : c.go1;
      const bool fits = expected == c.value;
      BOOST_TEST((report.status == (fits ? FrameStatus::kOk : FrameStatus::kSaturated)));
      if (!fits) BOOST_TEST(report.motor == 7);
      decode_low_cmd(frame.bytes.data(), frame.size, g, back, extras);
      BOOST_TEST(float(back.motorCmd[7].*c.field) == expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(fixed_point_values_are_truncated_toward_zero) {
  LowCmd cmd = init_low_cmd(), back;
  FrameExtras extras;
  Frame frame;
  cmd.motorCmd[0].tau = 0.0039F;
  cmd.motorCmd[1].tau = -0.65F;
  cmd.motorCmd[2].Kd = 0.0624F;
  encode_low_cmd(cmd, {}, G::kGo1v38, frame);
  decode_low_cmd(frame.bytes.data(), frame.size, G::kGo1v38, back, extras);
  BOOST_TEST(float(back.motorCmd[0].tau) == 0.0F);
  BOOST_TEST(float(back.motorCmd[1].tau) == -166.0F / 256.0F);
  BOOST_TEST(float(back.motorCmd[2].Kd) == 0.0F);
}

BOOST_AUTO_TEST_CASE(non_finite_command_is_refused_and_the_frame_is_unchanged) {
  for (const float bad : {std::nanf(""), INFINITY, -INFINITY}) {
    for (float MotorCmd::* field :
         {&MotorCmd::q, &MotorCmd::dq, &MotorCmd::tau, &MotorCmd::Kp, &MotorCmd::Kd}) {
      LowCmd cmd = init_low_cmd();
      cmd.motorCmd[19].*field = bad;
      Frame frame;
      frame.size = 77;
      const FrameReport report = encode_low_cmd(cmd, {}, G::kGo1v38, frame);
      BOOST_TEST((report.status == FrameStatus::kNotFinite));
      BOOST_TEST(report.motor == 19);
      BOOST_TEST(frame.size == 77U);
    }
  }
}

BOOST_AUTO_TEST_CASE(invalid_frame_is_refused_with_its_reason_and_state_is_unchanged) {
  Frame good;
  encode_low_state(init_low_state(), {}, G::kGo1v38, good);
  const auto verdict = [&](std::vector<std::uint8_t> bytes, G g = G::kGo1v38) {
    LowState state = init_low_state();
    state.tick = 42;
    FrameExtras extras;
    const FrameStatus status =
        decode_low_state(bytes.data(), bytes.size(), g, state, extras).status;
    BOOST_TEST((status == FrameStatus::kOk || state.tick == 42U));
    return status;
  };
  std::vector<std::uint8_t> bytes(good.bytes.begin(), good.bytes.begin() + good.size);
  BOOST_TEST((verdict(bytes) == FrameStatus::kOk));
  BOOST_TEST((verdict({}) == FrameStatus::kWrongLength));
  BOOST_TEST((verdict(std::vector<std::uint8_t>(807, 0)) == FrameStatus::kBlank));
  for (const G g : {G::kA1v33, G::kGo1v34, G::kB1v38}) {
    BOOST_TEST((verdict(bytes, g) == FrameStatus::kWrongGeneration));
  }
  const auto changed = [&](int at, std::uint8_t to, bool recompute_crc) {
    auto other = bytes;
    other[at] = to;
    if (recompute_crc) write_crc(other);
    return verdict(other);
  };
  BOOST_TEST((changed(0, 0x12, true) == FrameStatus::kWrongHead));
  BOOST_TEST((changed(2, 0xEE, true) == FrameStatus::kWrongLevel));
  BOOST_TEST((changed(30, 1, false) == FrameStatus::kWrongCrc));
  auto nan = bytes;
  const float bad = std::nanf("");
  std::memcpy(nan.data() + 22, &bad, 4);
  write_crc(nan);
  BOOST_TEST((verdict(nan) == FrameStatus::kNotFinite));
}

BOOST_AUTO_TEST_CASE(frame_report_names_both_generations_and_names_parse_back) {
  FrameReport report;
  report.status = FrameStatus::kWrongGeneration;
  report.size = 795;
  report.expected = G::kGo1v38;
  report.detected = G::kGo1v34;
  report.expected_size = 807;
  BOOST_TEST(to_text(report) ==
             "got 795 bytes, a frame of go1-v3.4, expected 807 bytes, a frame of go1-v3.8");
  for (const G g : kAll) BOOST_TEST((to_generation(to_string(g)) == g));
  BOOST_CHECK_EXCEPTION(to_generation("go1"), Error, [](const Error& e) {
    return std::string(e.what()).find("b1-v3.8") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
