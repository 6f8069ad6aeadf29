// SPDX-License-Identifier: BSD-3-Clause
// A DdsLink beside other commanders, other robots and writers of other types.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dds/link/topics.hpp"
#include "dds/wire/wire_types.hpp"
#include "link_fixture.hpp"
#include "surefoot/error.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(dds_conflict, *boost::unit_test::precondition(has_libddsc))

BOOST_FIXTURE_TEST_CASE(other_writer_of_commands_is_named_and_commands_alone_after_10_dampings,
                        LinkFixture) {
  robot.send_state(1);
  BOOST_TEST(receive());
  BOOST_TEST(sent_tau() == 1.0);
  {
    DdsWriter other(network->participant(), unitree_go_msg_dds__LowCmd__desc, kCommandTopic);
    BOOST_TEST(wait_until([this] { return link.receive() || link.status().conflict; }));
    for (int k = 0; k < 10; ++k) BOOST_TEST(std::isnan(sent_tau()));
    for (int k = 0; k < 5; ++k) BOOST_TEST(std::isinf(sent_tau()));  // nothing arrives
    BOOST_TEST(link.dds_counts().conflicts == 15U);
    BOOST_TEST(link.dds_counts().withheld == 5U);
    BOOST_TEST(link.counts().sent == 11U);
    BOOST_TEST(contains(all(link.take_news()), "writer of rt/lowcmd found: process "));
    DdsLinkOptions options = LinkFixture::options();
    BOOST_CHECK_EXCEPTION(DdsLink(network, options), Error, [](const Error& error) {
      return contains(error.what(), "rt/lowcmd: got 2 other writer(s) (process ") &&
             contains(error.what(), "listed for up to 10 s: wait, then try again");
    });
  }
  BOOST_TEST(wait_until([this] { return !link.receive() && !link.status().conflict; }));
  BOOST_TEST(contains(all(link.take_news()), "writer of rt/lowcmd has gone"));
  BOOST_TEST(sent_tau() == 1.0);
}

BOOST_FIXTURE_TEST_CASE(link_that_has_sent_no_command_is_silent_beside_another_commander,
                        LinkFixture) {
  BOOST_TEST(std::isnan(sent_tau()));
  const DdsWriter other(network->participant(), unitree_go_msg_dds__LowCmd__desc, kCommandTopic);
  BOOST_TEST(wait_until([this] { return link.receive() || link.status().conflict; }));
  robot.send_state(1);
  BOOST_TEST(receive());
  BOOST_TEST(std::isinf(sent_tau()));
  BOOST_TEST(link.dds_counts().withheld == 1U);
}

BOOST_FIXTURE_TEST_CASE(second_robot_makes_the_link_damp, LinkFixture) {
  robot.send_state(1);
  BOOST_TEST(receive());
  const RobotEnd second(network->participant());
  BOOST_TEST(wait_until([this] { return link.receive() || link.status().conflict; }));
  for (int k = 0; k < 12; ++k) BOOST_TEST(std::isnan(sent_tau()));
  BOOST_TEST(link.dds_counts().withheld == 0U);
}

BOOST_FIXTURE_TEST_CASE(states_of_a_second_robot_are_not_used_and_are_a_conflict_at_once,
                        LinkFixture) {
  robot.send_state(1);
  BOOST_TEST(receive());
  RobotEnd second(network->participant());
  second.send_state(500);
  BOOST_TEST(wait_until([this] { return link.receive() || link.dds_counts().second_robot > 0; }));
  BOOST_TEST(std::uint32_t(link.state().tick) == 1U);
  BOOST_TEST(link.status().conflict);
  BOOST_TEST(link.dds_counts().second_robot == 1U);
  BOOST_TEST(std::isnan(sent_tau()));
  robot.send_state(3);
  BOOST_TEST(receive());
  BOOST_TEST(std::uint32_t(link.state().tick) == 3U);
  for (std::uint32_t k = 0; k < 60; ++k) {
    second.send_state(600 + k);
    link.receive();
  }
  BOOST_TEST(wait_until([this] { return link.receive() || link.dds_counts().second_robot > 50; }));
  BOOST_TEST(contains(all(link.take_news()), "LowStates of a second robot arrive"));
}

BOOST_FIXTURE_TEST_CASE(robot_whose_writer_was_replaced_has_restarted, LinkFixture) {
  robot.send_state(1000);
  BOOST_TEST(receive());
  robot.writer = DdsWriter(network->participant(), unitree_go_msg_dds__LowState__desc, kStateTopic);
  std::uint32_t tick = 1;
  BOOST_TEST(wait_until([&] {
    robot.send_state(tick += 2);
    return link.receive();
  }));
  BOOST_TEST(std::uint32_t(link.state().tick) < 1000U);
  BOOST_TEST(link.counts().restarts == 1U);
  BOOST_TEST(wait_until([this] { return !link.receive() && !link.status().conflict; }));
}

BOOST_AUTO_TEST_CASE(writer_of_another_type_is_refused_by_name) {
  const auto network = test_network();
  // A type of another name. The layout does not matter, because nothing is written.
  const dds_topic_descriptor_t humanoid{sizeof(DdsLowState),
                                        alignof(DdsLowState),
                                        DDS_TOPIC_FIXED_SIZE,
                                        0,
                                        "unitree_hg::msg::dds_::LowState_",
                                        nullptr,
                                        unitree_go_msg_dds__LowState__desc.m_nops,
                                        unitree_go_msg_dds__LowState__desc.m_ops,
                                        "",
                                        {nullptr, 0},
                                        {nullptr, 0},
                                        0};
  const DdsWriter writer(network->participant(), humanoid, kStateTopic);
  BOOST_CHECK_EXCEPTION(DdsLink(network, LinkFixture::options()), Error, [](const Error& error) {
    return contains(error.what(), "got a writer of type unitree_hg::msg::dds_::LowState_");
  });
}

BOOST_AUTO_TEST_SUITE_END()
