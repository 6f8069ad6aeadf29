// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "dds/ddsc/library.hpp"
#include "dds/ddsc/library_version.hpp"
#include "dds_environment.hpp"
#include "surefoot/error.hpp"

using namespace surefoot;

namespace {

// Return the message of the error that a function throws; "" if it throws none.
template <typename Function>
std::string error_of(Function&& function) {
  try {
    function();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string join_error(const std::string& interface, int domain = 1) {
  DdsNetworkOptions options;
  options.interface = interface;
  options.domain = domain;
  return error_of([&] { DdsNetwork network(options); });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(dds_network)

BOOST_AUTO_TEST_CASE(interface_that_does_not_exist_is_refused_with_those_that_do) {
  const std::string error = join_error("nosuch0");
  BOOST_TEST(
      contains(error, "network interface 'nosuch0': got no such interface, expected one of"));
  BOOST_TEST(contains(error, "lo"));
  BOOST_TEST(contains(join_error(""), "got no name"));
}

BOOST_AUTO_TEST_CASE(domain_out_of_range_is_refused) {
  BOOST_TEST(contains(join_error("lo", 231), "got 231, expected 0 .. 230"));
}

BOOST_AUTO_TEST_CASE(missing_library_is_refused_in_one_line_with_the_remedy) {
  const std::string error = error_of([] { load_dds_library("/nowhere/libddsc.so", false); });
  BOOST_TEST(contains(error, "/nowhere/libddsc.so"));
  BOOST_TEST(contains(error, "pip install 'surefoot[dds]'"));
  BOOST_TEST(!contains(error, "\n"));
}

BOOST_AUTO_TEST_CASE(library_that_is_no_libddsc_is_refused) {
  const std::string error = error_of([] { load_dds_library("libm.so.6", false); });
  BOOST_TEST(contains(error, "expected a tested one, 0.10.2, 0.11.0, 11.0.1"));
  BOOST_TEST(
      contains(error_of([] { load_dds_library("libm.so.6", true); }), "without dds_create_domain"));
}

BOOST_AUTO_TEST_CASE(version_is_found_in_the_name_and_in_the_content_of_a_file) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("surefoot_version_" + std::to_string(test_domain()));
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const std::string& content) {
    const auto path = (folder / name).string();
    std::ofstream(path) << content;
    return path;
  };
  BOOST_TEST(library_version(write("libddsc.so.9.8.7", "")) == "9.8.7");
  const std::string content(
      "\x7f"
      "ELF\0"
      "1.2\0"
      "a.b.c\0"
      "10.20.30\0",
      25);
  BOOST_TEST(library_version(write("libddsc.so", content)) == "10.20.30");
  BOOST_TEST(library_version(write("empty.so", "")) == "");
  BOOST_TEST(library_version("/nowhere") == "");
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_CASE(domain_is_joined_once_in_a_process,
                     *boost::unit_test::precondition(has_libddsc)) {
  const auto network = test_network();
  BOOST_TEST(contains(network->notices().front(), "on lo, libddsc "));
  const std::string error = error_of([] { test_network(); });
  BOOST_TEST(contains(error, "got a domain that this process has joined already"));
}

BOOST_AUTO_TEST_CASE(domain_can_be_joined_again_after_it_was_left,
                     *boost::unit_test::precondition(has_libddsc)) {
  test_network();
  test_network();
}

BOOST_AUTO_TEST_CASE(settings_of_the_environment_are_not_used_and_a_notice_says_so,
                     *boost::unit_test::precondition(has_libddsc)) {
  // An interface that does not exist: with these settings the domain could not be joined.
  setenv("CYCLONEDDS_URI",
         "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name=\"nosuch0\"/>"
         "</Interfaces></General></Domain></CycloneDDS>",
         1);
  const auto network = test_network();
  unsetenv("CYCLONEDDS_URI");
  BOOST_REQUIRE(network->notices().size() == 2U);
  BOOST_TEST(contains(network->notices()[1], "CYCLONEDDS_URI is set, but not used"));
}

BOOST_AUTO_TEST_SUITE_END()
