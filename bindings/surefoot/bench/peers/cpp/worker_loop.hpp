// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <time.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Main loop of every C++ worker: read the problem, compute ticks on request, and write their times
/// and results. workers/worker_loop.py defines the protocol. This header does not use Surefoot,
/// because the workers of the peers include it too.
namespace peers {

/// Contents of the problem files.
class Problem {
 public:
  /// @param file path of problem.txt
  /// @throws std::runtime_error if states.bin is too short
  explicit Problem(const std::string& file) : folder(file.substr(0, file.find_last_of('/') + 1)) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string name, word;
      words >> name;
      while (words >> word) rows_[name].push_back(word);
    }
    const Eigen::VectorXd size = array("size");
    ticks = int(size[0]);
    nq = int(size[1]);
    nv = int(size[2]);
    states_.resize(nq + nv + 7, ticks);
    std::ifstream states(folder + "states.bin", std::ios::binary);
    if (!states.read(reinterpret_cast<char*>(states_.data()), states_.size() * sizeof(double))) {
      throw std::runtime_error(folder + "states.bin: too short");
    }
  }

  const std::vector<std::string>& names(const std::string& key) const { return rows_.at(key); }
  Eigen::VectorXd array(const std::string& key) const {
    const auto& words = names(key);
    Eigen::VectorXd values(words.size());
    for (std::size_t i = 0; i < words.size(); ++i) values[i] = std::stod(words[i]);
    return values;
  }
  double number(const std::string& key) const { return std::stod(names(key).at(0)); }

  Eigen::VectorXd q(int tick) const { return states_.col(tick).head(nq); }
  Eigen::VectorXd v(int tick) const { return states_.col(tick).segment(nq, nv); }
  Eigen::Vector3d com(int tick) const { return states_.col(tick).segment<3>(nq + nv); }
  Eigen::Quaterniond base(int tick) const {
    return Eigen::Quaterniond(Eigen::Vector4d(states_.col(tick).tail<4>()));  // x y z w
  }

  std::string folder;
  int ticks = 0, nq = 0, nv = 0;

 private:
  std::map<std::string, std::vector<std::string>> rows_;
  Eigen::MatrixXd states_;
};

/// Result of a tick.
struct TickResult {
  bool solved = false;
  Eigen::VectorXd forces;   ///< (12,) on the feet FR FL RR RL, world axes [N]
  Eigen::VectorXd torques;  ///< (nv - 6,) in Pinocchio's order [N.m]
};

inline double nanoseconds(clockid_t clock) {
  timespec now;
  clock_gettime(clock, &now);
  return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

/// Compute ticks on request until standard input ends.
/// @param peer implementation; only its tick() is timed, load(tick) and read_result() are not
/// @param versions versions of the libraries that the worker uses, JSON
template <typename Peer>
void serve(const Problem& problem, Peer& peer, const std::string& versions) {
  std::printf("{\"versions\": %s}\n", versions.c_str());
  std::fflush(stdout);
  TickResult result;
  result.forces = Eigen::VectorXd::Zero(12);
  result.torques = Eigen::VectorXd::Zero(problem.nv - 6);
  std::vector<double> reply;
  int first = 0, count = 0;
  while (std::scanf(" play %d %d", &first, &count) == 2) {
    reply.clear();
    for (int k = first; k < first + count; ++k) {
      peer.load(k);
      const double cpu = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
      const double wall = nanoseconds(CLOCK_MONOTONIC);
      peer.tick();
      const double wall_end = nanoseconds(CLOCK_MONOTONIC);
      const double cpu_end = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
      peer.read_result(result);
      reply.insert(reply.end(), {wall_end - wall, cpu_end - cpu, double(result.solved)});
      reply.insert(reply.end(), result.forces.data(), result.forces.data() + 12);
      reply.insert(reply.end(), result.torques.data(),
                   result.torques.data() + result.torques.size());
    }
    std::fwrite(reply.data(), sizeof(double), reply.size(), stdout);
    std::fflush(stdout);
  }
}

}  // namespace peers
