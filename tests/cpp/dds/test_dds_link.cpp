// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>

#include "dds/link/blocked_writes.hpp"
#include "dds/link/topics.hpp"
#include "dds/wire/wire_types.hpp"
#include "link_fixture.hpp"
#include "surefoot/error.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(dds_link, *boost::unit_test::precondition(has_libddsc))

BOOST_FIXTURE_TEST_CASE(link_sends_only_damping_before_the_first_valid_state, LinkFixture) {
  BOOST_TEST(std::isinf(link.state_age()));
  BOOST_TEST(std::isnan(sent_tau()));
  DdsLowState blank;
  std::memset(&blank, 0, sizeof(blank));
  robot.writer.write(&blank);
  pause(20);
  BOOST_TEST(!link.receive());
  BOOST_TEST(link.counts().corrupt == 1U);
  BOOST_TEST(std::isnan(sent_tau()));
  robot.send_state(1);
  BOOST_TEST(receive());
  BOOST_TEST(sent_tau() == 1.0);
  torque_command.motorCmd[0].tau = NAN;
  BOOST_TEST(std::isnan(sent_tau()));
  BOOST_TEST(link.counts().refused == 1U);
}

BOOST_FIXTURE_TEST_CASE(newest_state_is_used_and_others_are_counted, LinkFixture) {
  for (const std::uint32_t tick : {1, 2, 3, 6, 5, 6, 7}) robot.send_state(tick);
  pause(20);
  BOOST_TEST(receive());
  BOOST_TEST(std::uint32_t(link.state().tick) == 7U);
  BOOST_TEST(link.counts().valid == 7U);
  BOOST_TEST(link.counts().reordered == 1U);
  BOOST_TEST(link.counts().duplicate == 1U);
  BOOST_TEST(link.counts().lost == 1U);
  BOOST_TEST(!link.receive());
}

BOOST_FIXTURE_TEST_CASE(age_includes_the_time_that_a_state_waited, LinkFixture) {
  link.receive();
  robot.send_state(1);
  pause(100);
  BOOST_TEST(link.receive());
  BOOST_TEST(link.state_age() > 0.08);
  BOOST_TEST(link.state_age() < 0.5);
}

BOOST_FIXTURE_TEST_CASE(missing_crc_is_accepted_and_said, LinkFixture) {
  link.take_news();
  robot.send_state(1, false);
  BOOST_TEST(receive());
  BOOST_TEST(link.dds_counts().without_crc == 1U);
  BOOST_TEST(contains(all(link.take_news()), "their CRC is not checked"));
  BOOST_TEST(link.take_news().empty());
}

BOOST_FIXTURE_TEST_CASE(tick_that_stands_at_0_is_said_with_the_remedy, LinkFixture) {
  for (int k = 0; k < 60; ++k) {
    robot.send_state(0);
    if (k % 20 == 19) pause(20), link.receive();
  }
  BOOST_TEST(link.counts().duplicate == 59U);
  BOOST_TEST(contains(all(link.take_news()), "--tick arrival"));
}

BOOST_FIXTURE_TEST_CASE(robot_that_sends_only_invalid_states_is_reported_as_silent, LinkFixture) {
  robot.send_state(1);
  BOOST_TEST(receive());
  link.take_news();
  DdsLowState blank;
  std::memset(&blank, 0, sizeof(blank));
  for (int k = 0; k < 12; ++k) {
    robot.writer.write(&blank);
    pause(10);
    link.receive();
  }
  BOOST_TEST(contains(all(link.take_news()), "no valid LowState for 0.1 s from process "));
  robot.send_state(3);
  BOOST_TEST(receive());
  BOOST_TEST(contains(all(link.take_news()), "LowStates are back from process "));
}

BOOST_FIXTURE_TEST_CASE(commands_that_timed_out_are_reported_with_the_reliable_readers,
                        LinkFixture) {
  const DdsParticipant& participant = network->participant();
  const auto reported = [&] {
    BlockedWrites blocked(participant, kCommandTopic);
    std::vector<std::string> news;
    blocked.on_write(0);
    blocked.add_to(news);
    BOOST_TEST(news.empty());
    blocked.on_write(ddsc::kTimeout);
    blocked.add_to(news);
    blocked.on_write(ddsc::kTimeout);
    blocked.add_to(news);  // too early for another sentence
    BOOST_TEST(news.size() == 1U);
    return all(news);
  };
  // The reader of the fixture is best effort, so it cannot block a writer.
  BOOST_TEST(contains(reported(), "rt/lowcmd: 1 message(s) timed out after 1 ms"));
  BOOST_TEST(contains(reported(), "reliable readers: none at present"));
  const ReliableReader reader(participant, unitree_go_msg_dds__LowCmd__desc, kCommandTopic);
  BOOST_TEST(contains(reported(), "reliable readers: process "));
}

BOOST_AUTO_TEST_CASE(tick_is_made_from_arrival_on_request) {
  const auto network = test_network();
  RobotEnd robot(network->participant());
  DdsLinkOptions options = LinkFixture::options();
  options.tick = TickSource::kArrival;
  DdsLink link(network, options);
  robot.send_state(0);
  BOOST_TEST(wait_until([&] { return link.receive(); }));
  const std::uint32_t first = link.state().tick;
  pause(50);
  robot.send_state(0);
  BOOST_TEST(wait_until([&] { return link.receive(); }));
  const double elapsed = link.state().tick - first;
  BOOST_TEST(elapsed >= 50.0);
  BOOST_TEST(elapsed < 150.0);
}

BOOST_AUTO_TEST_CASE(options_out_of_range_are_refused) {
  const auto network = test_network();
  DdsLinkOptions options;
  options.damping_kd = 0.01;
  BOOST_CHECK_THROW(DdsLink(network, options), Error);
  options = {};
  options.discovery_time = NAN;
  BOOST_CHECK_THROW(DdsLink(network, options), Error);
  BOOST_CHECK_THROW(DdsLink(nullptr, {}), Error);
}

BOOST_AUTO_TEST_SUITE_END()
