// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "run/remote_reference.hpp"
#include "surefoot/wireless_remote.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(wireless_remote)

BOOST_AUTO_TEST_CASE(encoded_remote_decodes_to_the_same_values) {
  WirelessRemote remote;
  remote.buttons = static_cast<std::uint16_t>(Button::kB);
  remote.lx = -1.0F;
  remote.ly = 0.5F;
  remote.rx = 0.25F;
  remote.ry = 1.0F;
  remote.L2 = 0.75F;
  const WirelessRemote read = decode_wireless_remote(encode_wireless_remote(remote));
  BOOST_TEST(read.pressed(Button::kB));
  BOOST_TEST(!read.pressed(Button::kA));
  for (float WirelessRemote::* stick :
       {&WirelessRemote::lx, &WirelessRemote::ly, &WirelessRemote::rx, &WirelessRemote::ry,
        &WirelessRemote::L2}) {
    BOOST_TEST((read.*stick) == (remote.*stick));
  }
}

BOOST_AUTO_TEST_CASE(invalid_stick_value_centres_all_sticks_and_keeps_buttons) {
  for (const float broken : {NAN, INFINITY, 1.2F, -3.0F}) {
    WirelessRemote remote;
    remote.buttons = static_cast<std::uint16_t>(Button::kB);
    remote.ly = 0.5F;
    remote.rx = broken;
    const WirelessRemote read = decode_wireless_remote(encode_wireless_remote(remote));
    BOOST_TEST(read.pressed(Button::kB));
    BOOST_TEST(read.ly == 0.0F);
    BOOST_TEST(read.rx == 0.0F);
  }
}

BOOST_AUTO_TEST_CASE(sticks_and_arrows_move_the_body) {
  WirelessRemote remote;
  remote.ly = 1.0F;
  remote.lx = 0.04F;  // not exactly at rest
  remote.buttons = static_cast<std::uint16_t>(Button::kUp);
  const BodyReference r = remote_reference(remote);
  BOOST_TEST(r.x > 0.0);
  BOOST_TEST(r.y == 0.0);
  BOOST_TEST(r.height > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
