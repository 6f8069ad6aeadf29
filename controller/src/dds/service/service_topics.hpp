// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "dds/generated/unitree_api.h"
#include "dds/network/endpoints.hpp"

namespace surefoot {

using DdsRequest = unitree_api_msg_dds__Request_;
using DdsResponse = unitree_api_msg_dds__Response_;

/// Return the name of the topic of requests to a service.
inline std::string request_topic(const std::string& service) {
  return "rt/api/" + service + "/request";
}
/// Return the name of the topic of replies of a service.
inline std::string response_topic(const std::string& service) {
  return "rt/api/" + service + "/response";
}

/// Take the oldest sample in memory of libddsc, call use(sample), and return the memory.
/// @return false if no sample waits
template <typename Sample, typename Use>
bool take_loan(const DdsReader& reader, Use&& use) {
  void* sample = nullptr;
  ddsc::SampleInfo info{};
  if (reader.functions().take(reader.handle(), &sample, &info, 1, 1) <= 0) return false;
  if (info.valid_data) use(*static_cast<const Sample*>(sample));
  reader.functions().return_loan(reader.handle(), &sample, 1);
  return true;
}

}  // namespace surefoot
