// SPDX-License-Identifier: BSD-3-Clause
#include "dds/link/state_news.hpp"

#include "common/text.hpp"

namespace surefoot {

namespace {

// Number of LowStates with tick 0 that show that the tick stands still. Chosen: 0.1 s at 500 Hz.
constexpr std::uint64_t kStandingTicks = 50;
// Number of LowStates of a second robot that are reported. Chosen: 0.1 s at 500 Hz. A restarted
// robot sends some before its new writer is discovered.
constexpr std::uint64_t kSecondRobotStates = 50;
// [s] Silence that is reported. Equal to kRobotWatchdogTime. DDS itself notices a process that has
// crashed only after 10 s.
constexpr double kReportedSilence = 0.1;

// Add a sentence if it applies and was not added before.
void add_once(bool applies, bool& reported, const char* sentence, std::vector<std::string>& news) {
  if (!applies || reported) return;
  reported = true;
  news.emplace_back(sentence);
}

}  // namespace

void StateNews::on_valid(const DdsCounts& counts, double arrival) noexcept {
  last_valid_.store(arrival);
  crc_missing_.store(counts.without_crc > 0);
  head_missing_.store(counts.without_head > 0);
  tick_stands_.store(counts.without_tick >= kStandingTicks);
}

void StateNews::on_second_robot(std::uint64_t count) noexcept {
  second_robot_.store(count >= kSecondRobotStates);
}

void StateNews::add_to(std::vector<std::string>& news, const std::string& robot) {
  add_silence(news, robot);
  add_once(second_robot_.load(), second_robot_reported_,
           "LowStates of a second robot arrive: they are not used", news);
  add_once(crc_missing_.load(), crc_reported_, "LowStates carry crc 0: their CRC is not checked",
           news);
  add_once(head_missing_.load(), head_reported_,
           "LowStates have no head, as from unitree_mujoco: servo mode is assumed", news);
  add_once(tick_stands_.load(), tick_reported_,
           tick_ == TickSource::kArrival
               ? "the tick of the LowStates stands at 0: the tick is made from arrival"
               : "the tick of the LowStates stands at 0, so none is new; use --tick arrival "
                 "(TickSource::kArrival)",
           news);
}

// The time of the last receive() takes the place of the present time: a program that did not read
// LowStates does not know whether the robot is silent.
void StateNews::add_silence(std::vector<std::string>& news, const std::string& robot) {
  const double last_valid = last_valid_.load();
  const bool silent = last_valid > 0.0 && last_receive_.load() - last_valid > kReportedSilence;
  if (silent == silence_reported_) return;
  silence_reported_ = silent;
  news.push_back(silent ? "no valid LowState for " + to_text(kReportedSilence) + " s from " + robot
                        : "LowStates are back from " + robot);
}

}  // namespace surefoot
