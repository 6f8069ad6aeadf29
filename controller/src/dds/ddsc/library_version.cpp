// SPDX-License-Identifier: BSD-3-Clause
#include "dds/ddsc/library_version.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <vector>

#include "common/text.hpp"

namespace surefoot {

namespace {

const std::vector<std::string>& tested_versions() {
  static const std::vector<std::string> versions = {"0.10.2", "0.11.0", "11.0.1"};
  return versions;
}

std::string version_in_name(const std::string& path) {
  std::error_code problem;
  const std::string name = std::filesystem::canonical(path, problem).filename().string();
  std::smatch match;
  static const std::regex ending(R"(\.so\.(\d+\.\d+\.\d+)$)");
  return std::regex_search(name, match, ending) ? match[1].str() : "";
}

bool is_version(const char* begin, const char* end) {
  return std::count(begin, end, '.') == 2 && std::isdigit(*begin) && std::isdigit(end[-1]) &&
         std::all_of(begin, end, [](unsigned char c) { return std::isdigit(c) || c == '.'; });
}

// Return the first text between two zero bytes that is a version.
std::string version_in_content(const std::string& path) {
  constexpr std::ptrdiff_t kShortest = 5, kLongest = 11;  // 0.0.0 .. 999.999.999
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  const char *begin = bytes.data(), *const end = begin + bytes.size();
  while (begin < end) {
    const char* const zero = std::find(begin, end, '\0');
    const std::ptrdiff_t length = zero - begin;
    if (length >= kShortest && length <= kLongest && is_version(begin, zero)) return {begin, zero};
    begin = zero == end ? end : zero + 1;
  }
  return "";
}

}  // namespace

std::string library_version(const std::string& path) {
  const std::string version = version_in_name(path);
  return version.empty() ? version_in_content(path) : version;
}

std::string tested_library_versions() { return join(tested_versions()); }

bool is_tested_library_version(const std::string& version) {
  const auto& tested = tested_versions();
  return std::find(tested.begin(), tested.end(), version) != tested.end();
}

}  // namespace surefoot
