// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <thread>

#include "dds_environment.hpp"
#include "robot_end.hpp"
#include "surefoot/dds_service.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(dds_service, *boost::unit_test::precondition(has_libddsc))

BOOST_AUTO_TEST_CASE(missing_server_is_reported_as_code_3102) {
  DdsServiceClient client(test_network(), "motion_switcher");
  BOOST_TEST(!client.wait_for_server(0.05));
  BOOST_TEST(client.call(1001, "{}", 0.05, false).code == kServiceNotFound);
}

BOOST_AUTO_TEST_CASE(server_that_does_not_answer_is_reported_as_code_3104) {
  const auto network = test_network();
  DdsServiceServer server(network, "motion_switcher");
  DdsServiceClient client(network, "motion_switcher");
  BOOST_TEST(client.call(1001, "{}", 0.7, false).code == kServiceTimeout);
  BOOST_TEST(server.take().has_value());
  BOOST_TEST(!server.take().has_value());
}

BOOST_AUTO_TEST_CASE(reply_has_the_code_and_the_data_of_the_server) {
  const auto network = test_network();
  DdsServiceServer server(network, "motion_switcher");
  DdsServiceClient client(network, "motion_switcher");
  std::atomic<bool> ended{false};
  std::thread thread([&] {
    while (!ended.load()) {
      if (const auto request = server.take()) {
        server.reply({request->id + 1, request->api_id, "", false}, {1, "of another request"});
        server.reply(*request, {7002, request->parameter + "!"});
      }
      pause(1);
    }
  });
  const ServiceReply reply = client.call(1003, "{\"name\": \"normal\"}", 2.0, true);
  ended.store(true);
  thread.join();
  BOOST_TEST(reply.code == 7002);
  BOOST_TEST(reply.data == "{\"name\": \"normal\"}!");
}

BOOST_AUTO_TEST_SUITE_END()
