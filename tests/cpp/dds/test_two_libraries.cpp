// SPDX-License-Identifier: BSD-3-Clause
// Two libddsc in one process: copies of one file, and different versions.
#include <boost/test/unit_test.hpp>
#include <filesystem>

#include "dds/ddsc/library.hpp"
#include "dds/network/dds_config.hpp"
#include "dds_environment.hpp"
#include "robot_end.hpp"
#include "surefoot/dds_link.hpp"
#include "surefoot/error.hpp"

using namespace surefoot;

namespace {

std::shared_ptr<DdsNetwork> network_of(const std::string& library) {
  return std::make_shared<DdsNetwork>(
      DdsNetworkOptions{"lo", test_domain(), false, library, false});
}

// A link in one library finds a robot in another, and both exchange messages.
void check_exchange(const std::string& link_library, const std::string& robot_library) {
  DdsLink link(network_of(link_library), DdsLinkOptions{});
  // A DdsNetwork would refuse a domain that this process has joined.
  const DdsParticipant participant(load_dds_library(robot_library, false), test_domain(),
                                   dds_config(find_interface("lo")));
  RobotEnd robot(participant);
  LowCmd command = init_low_cmd();
  command.motorCmd[0].tau = 2.0F;
  std::uint32_t tick = 0;
  const bool arrived = wait_until([&] {
    robot.send_state(tick += 2);
    link.receive();
    link.send(command);
    return robot.tau() == 2.0;
  });
  BOOST_TEST(arrived);
  BOOST_TEST(link.counts().valid > 0U);
  BOOST_TEST(link.counts().corrupt == 0U);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(two_libraries, *boost::unit_test::precondition(has_libddsc))

BOOST_AUTO_TEST_CASE(second_copy_of_the_library_in_the_process_does_no_harm) {
  const std::string path = load_dds_library(test_library(), false).path;
  const auto folder =
      std::filesystem::temp_directory_path() / ("surefoot_copy_" + std::to_string(test_domain()));
  std::filesystem::create_directories(folder);
  const auto copy = folder / std::filesystem::canonical(path).filename();
  std::filesystem::copy_file(path, copy);
  check_exchange(path, copy.string());
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_CASE(domain_that_another_library_of_the_process_has_joined_is_refused,
                     *boost::unit_test::precondition(has_system_libddsc)) {
  const DdsParticipant participant(load_dds_library(kSystemLibrary, false), test_domain(),
                                   dds_config(find_interface("lo")));
  BOOST_CHECK_EXCEPTION(network_of(test_library()), Error, [](const Error& error) {
    return std::string(error.what()).find("joined already with ") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(version_of_the_system_and_that_under_test_exchange_messages_both_ways,
                     *boost::unit_test::precondition(has_system_libddsc)) {
  check_exchange(test_library(), kSystemLibrary);
  check_exchange(kSystemLibrary, test_library());
}

BOOST_AUTO_TEST_SUITE_END()
