// SPDX-License-Identifier: BSD-3-Clause
// Format of a .robot file: one line with a magic word and the version, the configuration in lines
// of a key and its values, the serialised Pinocchio model, and a CRC-32 checksum of all that
// precedes. Names with spaces are quoted. All streams have the classic locale, because a global
// locale may have a decimal comma.
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <locale>
#include <sstream>
#include <system_error>
#include <vector>

#include "common/text.hpp"
#include "surefoot/error.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

namespace {

constexpr char kMagic[] = "surefoot-robot";
constexpr int kVersion = 1;
// Chosen: a thousand times the size of a robot with twelve joints. If larger: a wrong path reads a
// file that fills the memory.
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20;

// A field of the configuration, with the functions that write and read it. Saving and loading use
// the same table of fields, so both always agree.
struct Field {
  std::string key;
  std::function<void(std::ostream&)> write;
  std::function<void(std::istream&)> read;
};

Field number_field(const std::string& key, double& value) {
  return {key, [&value](std::ostream& out) { out << to_text(value); },
          [&value](std::istream& in) { in >> value; }};
}

template <typename Vector>
Field vector_field(const std::string& key, Vector& values) {
  return {key,
          [&values](std::ostream& out) {
            for (int i = 0; i < values.size(); ++i) out << (i ? " " : "") << to_text(values[i]);
          },
          [&values](std::istream& in) {
            for (int i = 0; i < values.size(); ++i) in >> values[i];
          }};
}

void write_name(std::ostream& out, const std::string& name) {
  if (name.find_first_of(" \"\\") == std::string::npos) {
    out << name;
  } else {
    out << std::quoted(name);
  }
}

template <std::size_t N>
Field names_field(const std::string& key, std::array<std::string, N>& names) {
  return {key,
          [&names](std::ostream& out) {
            for (std::size_t i = 0; i < N; ++i) {
              out << (i ? " " : "");
              write_name(out, names[i]);
            }
          },
          [&names](std::istream& in) {
            for (std::string& name : names) in >> std::quoted(name);
          }};
}

std::vector<Field> fields_of(RobotConfig& config) {
  std::vector<Field> fields = {
      {"name", [&config](std::ostream& out) { out << config.name; },
       [&config](std::istream& in) { in >> config.name; }},
      names_field("joint_names", config.joint_names),
      names_field("foot_frames", config.foot_frames),
      number_field("foot_radius", config.foot_radius),
      vector_field("p_base_imu", config.p_base_imu),
      vector_field("quat_base_imu", config.quat_base_imu),
      vector_field("q_lower", config.q_lower),
      vector_field("q_upper", config.q_upper),
      number_field("hip_inward", config.hip_inward),
      vector_field("dq_max", config.dq_max),
      vector_field("tau_max", config.tau_max),
      vector_field("corner_speed", config.corner_speed),
      vector_field("no_load_speed", config.no_load_speed),
      vector_field("armature", config.armature),
      vector_field("q_standing", config.q_standing),
      number_field("friction", config.friction),
  };
  for (const GainInfo& info : gain_table()) {
    fields.push_back(number_field("gain." + std::string(info.name), config.gains.*info.member));
  }
  return fields;
}

std::uint32_t checksum(const std::string& text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  return crc.checksum();
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw Error("robot file '" + path + "': " + what);
}

std::string read_all(const std::string& path) {
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (problem && status.type() != std::filesystem::file_type::not_found) {
    fail(path, "cannot be opened: " + problem.message());
  }
  if (std::filesystem::is_directory(status)) fail(path, "got a folder, expected a file");
  // Reading a pipe or a device could block or never end.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    fail(path, "got a pipe or a device, expected a file");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, std::string("cannot be opened: ") + std::strerror(errno));
  const auto size = std::filesystem::file_size(path, problem);
  if (problem || size > kMaxBytes) {
    fail(path, "got " + std::to_string(size >> 20) + " MB, expected at most " +
                   std::to_string(kMaxBytes >> 20) + " MB; not a robot file");
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

void read_header(const std::string& path, std::istream& in) {
  std::string magic;
  int version = -1;
  in >> magic >> version;
  in.ignore();
  if (magic != kMagic) fail(path, "not a robot file; expected one that 'surefoot export' wrote");
  if (version != kVersion) {
    fail(path, "got version " + std::to_string(version) + ", expected version " +
                   std::to_string(kVersion) + "; write it again with 'surefoot export'");
  }
}

void read_config(const std::string& path, std::istream& in, RobotConfig& config) {
  for (const Field& field : fields_of(config)) {
    std::string line, key;
    std::getline(in, line);
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    words >> key;
    if (key != field.key) {
      fail(path, "got field '" + key + "', expected '" + field.key +
                     "'; write a file of another version again with 'surefoot export'");
    }
    field.read(words);
    if (words.fail()) fail(path, "field '" + key + "' cannot be read: '" + line + "'");
  }
}

// Remove the checksum line from the end of `content`, and compare its checksum with that of the
// rest.
void check_integrity(const std::string& path, std::string& content) {
  const std::size_t cut = content.rfind("\nchecksum ");
  if (cut == std::string::npos) fail(path, "the end is missing (no checksum line)");
  const std::string stated = content.substr(cut + 10);
  content.resize(cut);
  if (stated != std::to_string(checksum(content)) + "\n") {
    fail(path, "the checksum does not match; the file is damaged");
  }
}

}  // namespace

void Robot::save(const std::string& path) const {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  RobotConfig copy = config();
  out << kMagic << " " << kVersion << "\n";
  for (const Field& field : fields_of(copy)) {
    out << field.key << " ";
    field.write(out);
    out << "\n";
  }
  out << serialized_model();
  std::ofstream file(path, std::ios::binary);
  file << out.str() << "\nchecksum " << std::to_string(checksum(out.str())) << "\n";
  file.close();
  if (!file) fail(path, "cannot be written");
}

Robot Robot::load(const std::string& path) {
  std::string content = read_all(path);
  std::istringstream header(content);
  header.imbue(std::locale::classic());
  read_header(path, header);
  check_integrity(path, content);
  std::istringstream in(content);
  in.imbue(std::locale::classic());
  read_header(path, in);
  RobotConfig config;
  read_config(path, in, config);
  return from_serialized_model(content.substr(static_cast<std::size_t>(in.tellg())), config);
}

}  // namespace surefoot
