// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "link/udp_socket.hpp"
#include "surefoot/error.hpp"
#include "surefoot/udp_link.hpp"

using namespace surefoot;

namespace {

// The robot's end of the link: a plain socket with its own port.
struct Peer {
  int fd = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0);
  int port = 0;
  Peer() {
    sockaddr_in me = address(0);
    BOOST_REQUIRE(bind(fd, reinterpret_cast<sockaddr*>(&me), sizeof(me)) == 0);
    socklen_t size = sizeof(me);
    getsockname(fd, reinterpret_cast<sockaddr*>(&me), &size);
    port = ntohs(me.sin_port);
  }
  ~Peer() { close(fd); }
  static sockaddr_in address(int port) {
    sockaddr_in a{};
    a.sin_family = AF_INET;
    a.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    a.sin_port = htons(static_cast<std::uint16_t>(port));
    return a;
  }
  void send(const UdpLink& link, const std::uint8_t* data, std::size_t size) const {
    const sockaddr_in to = address(link.local_port());
    sendto(fd, data, size, 0, reinterpret_cast<const sockaddr*>(&to), sizeof(to));
  }
  void send_state(const UdpLink& link, std::uint32_t tick, Generation g = Generation::kGo1v38) {
    LowState state = init_low_state();
    state.tick = tick;
    Frame frame;
    encode_low_state(state, {}, g, frame);
    send(link, frame.bytes.data(), frame.size);
  }
  // Return tau of motor 0 in the newest command; NaN: damping, infinity: no command arrived.
  double tau() {
    LowCmd cmd;
    FrameExtras extras;
    std::uint8_t data[1000];
    double tau = INFINITY;
    for (ssize_t n; (n = recv(fd, data, sizeof(data), 0)) > 0;) {
      const auto size = static_cast<std::size_t>(n);
      BOOST_REQUIRE(is_usable(decode_low_cmd(data, size, Generation::kGo1v38, cmd, extras).status));
      const MotorCmd motor = cmd.motorCmd[0];
      tau = motor.Kd > 0.0F ? NAN : motor.tau;
    }
    return tau;
  }
};

struct LinkFixture {
  Peer robot;
  UdpLink link{{"127.0.0.1", robot.port, 0, Generation::kGo1v38, 3.0}};
  LowCmd torque_command = init_low_cmd();
  LinkFixture() { torque_command.motorCmd[0].tau = 1.0F; }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(udp_link)

BOOST_FIXTURE_TEST_CASE(link_sends_only_damping_before_the_first_valid_state, LinkFixture) {
  BOOST_TEST(std::isinf(link.state_age()));
  link.send(torque_command);
  BOOST_TEST(std::isnan(robot.tau()));
  robot.send_state(link, 1, Generation::kGo1v34);
  BOOST_TEST(!link.receive());
  BOOST_TEST(!link.has_state());
  BOOST_TEST(link.counts().wrong_generation == 1U);
  link.send(torque_command);
  BOOST_TEST(std::isnan(robot.tau()));
  robot.send_state(link, 1);
  BOOST_TEST(link.receive());
  link.send(torque_command);
  BOOST_TEST(robot.tau() == 1.0);
  torque_command.motorCmd[0].tau = NAN;
  BOOST_TEST((link.send(torque_command).status == FrameStatus::kNotFinite));
  BOOST_TEST(std::isnan(robot.tau()));
  BOOST_TEST(link.counts().refused == 1U);
}

BOOST_FIXTURE_TEST_CASE(newest_state_is_used_and_other_datagrams_are_counted, LinkFixture) {
  for (const std::uint32_t tick : {1, 2, 3, 6, 5, 6, 7, 5}) robot.send_state(link, tick);
  BOOST_TEST(link.receive());
  BOOST_TEST(std::uint32_t(link.state().tick) == 7U);
  BOOST_TEST(link.counts().valid == 8U);
  BOOST_TEST(link.counts().lost == 1U);
  BOOST_TEST(link.counts().reordered == 1U);
  BOOST_TEST(link.counts().duplicate == 2U);
  BOOST_TEST(!link.receive());
  BOOST_TEST(link.state_age() < 1.0);
  const std::vector<std::uint8_t> junk(807, 7), shorter(100, 7);
  robot.send(link, junk.data(), junk.size());
  robot.send(link, shorter.data(), shorter.size());
  BOOST_TEST(!link.receive());
  BOOST_TEST(link.counts().corrupt == 1U);
  BOOST_TEST(link.counts().wrong_length == 1U);
  BOOST_TEST(std::uint32_t(link.state().tick) == 7U);
}

BOOST_FIXTURE_TEST_CASE(restarted_robot_is_accepted_and_counted, LinkFixture) {
  robot.send_state(link, 50000);
  BOOST_TEST(link.receive());
  for (const std::uint32_t tick : {3, 5, 7, 9}) robot.send_state(link, tick);
  BOOST_TEST(!link.receive());  // may still be old samples that were delayed
  robot.send_state(link, 11);
  BOOST_TEST(link.receive());
  BOOST_TEST(std::uint32_t(link.state().tick) == 11U);
  BOOST_TEST(link.counts().restarts == 1U);
}

BOOST_FIXTURE_TEST_CASE(state_age_includes_the_time_in_the_socket_buffer, LinkFixture) {
  // The kernel starts to stamp datagrams some time after the first socket has requested it.
  std::uint32_t tick = 1;
  for (int attempt = 0; attempt < 20; ++attempt, tick += 2) {
    robot.send_state(link, tick);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    BOOST_TEST(link.receive());
    if (link.state_age() > 0.055) break;
  }
  BOOST_TEST(link.state_age() > 0.055);
  const auto sent = std::chrono::steady_clock::now();
  robot.send_state(link, tick + 2);
  BOOST_TEST(link.receive());
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - sent;
  BOOST_TEST(link.state_age() < since.count() + 0.005);
}

BOOST_AUTO_TEST_CASE(wall_clock_step_makes_no_datagram_older_than_the_last_receive) {
  BOOST_TEST(arrival_time(100.0, 0.25, 99.0) == 99.75);
  BOOST_TEST(arrival_time(100.0, 3600.0, 99.998) == 99.998);  // an hour forward
  BOOST_TEST(arrival_time(100.0, -3600.0, 99.998) == 100.0);  // and back
}

BOOST_FIXTURE_TEST_CASE(other_senders_are_ignored_and_a_flood_is_cut_off, LinkFixture) {
  Peer stranger;
  stranger.send_state(link, 99);
  BOOST_TEST(!link.receive());
  BOOST_TEST(!link.has_state());
  BOOST_TEST(link.counts().strangers == 1U);
  BOOST_TEST(link.counts().received == 0U);
  for (int k = 0; k < UdpLink::kMaxDatagramsPerReceive + 5; ++k) stranger.send(link, nullptr, 0);
  link.receive();
  BOOST_TEST(link.counts().floods == 1U);
  BOOST_TEST(link.counts().strangers == 1U + UdpLink::kMaxDatagramsPerReceive);
}

BOOST_FIXTURE_TEST_CASE(link_open_error_states_the_reason, LinkFixture) {
  const auto contains_text = [](const std::string& word) {
    return [word](const Error& e) { return std::string(e.what()).find(word) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(UdpLink({"10.1.2.3"}), Error, contains_text("beyond this machine"));
  BOOST_CHECK_EXCEPTION(UdpLink({"no such host"}), Error, contains_text("no such host"));
  BOOST_CHECK_EXCEPTION(UdpLink({"127.0.0.1", 70000}), Error, contains_text("70000"));
  BOOST_CHECK_EXCEPTION(UdpLink({"127.0.0.1", 8007, link.local_port()}), Error,
                        contains_text("in use"));
  for (const double kd : {0.0, 51.0, -1.0, double(NAN)}) {
    BOOST_CHECK_EXCEPTION(UdpLink({"127.0.0.1", 8007, 0, Generation::kGo1v38, kd}), Error,
                          contains_text("damping_kd"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
