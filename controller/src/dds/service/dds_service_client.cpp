// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <limits>
#include <thread>

#include "common/clock.hpp"
#include "dds/network/discovery.hpp"
#include "dds/service/service_topics.hpp"
#include "surefoot/dds_service.hpp"

namespace surefoot {

namespace {

constexpr auto kPollPeriod = std::chrono::milliseconds(2);  // chosen; a person waits anyway
// [s] Time after which a request is sent again. Chosen: longer than a server needs to answer.
constexpr double kRepeatTime = 0.5;

// Call done() until it returns true, for at most `timeout` [s]; return whether it did.
template <typename Done>
bool poll_until(double timeout, Done&& done) {
  for (const double end = monotonic_time() + timeout; !done();) {
    if (monotonic_time() > end) return false;
    std::this_thread::sleep_for(kPollPeriod);
  }
  return true;
}

}  // namespace

struct DdsServiceClient::Impl {
  Impl(std::shared_ptr<DdsNetwork> n, const std::string& s)
      : service(s),
        network(std::move(n)),
        reader(participant_of(network), unitree_api_msg_dds__Response__desc,
               response_topic(s).c_str()),
        writer(network->participant(), unitree_api_msg_dds__Request__desc,
               request_topic(s).c_str()),
        discovery(network->participant()) {}

  std::string service;
  std::shared_ptr<DdsNetwork> network;
  DdsReader reader;
  DdsWriter writer;
  DdsDiscovery discovery;
};

DdsServiceClient::DdsServiceClient(std::shared_ptr<DdsNetwork> network, const std::string& service)
    : impl_(std::make_unique<Impl>(std::move(network), service)) {}
DdsServiceClient::~DdsServiceClient() = default;

// A server reads requests and writes responses. Both must be discovered, or the reply would be
// lost.
bool DdsServiceClient::wait_for_server(double timeout) {
  return poll_until(timeout, [this] {
    return !impl_->discovery.readers(request_topic(impl_->service)).empty() &&
           !impl_->discovery.writers(response_topic(impl_->service)).empty();
  });
}

ServiceReply DdsServiceClient::call(std::int64_t api_id, const std::string& parameter,
                                    double timeout, bool repeat) {
  Impl& s = *impl_;
  const double start = monotonic_time();
  if (!wait_for_server(timeout)) return {kServiceNotFound, ""};
  const std::int64_t id = std::chrono::steady_clock::now().time_since_epoch().count();
  std::string text = parameter;
  DdsRequest request{};
  request.header.identity = {id, api_id};
  request.parameter = text.data();
  ServiceReply reply{kServiceTimeout, ""};
  double send_time = monotonic_time();
  poll_until(timeout - (monotonic_time() - start), [&] {
    if (monotonic_time() >= send_time) {
      s.writer.write(&request);
      send_time = repeat ? send_time + kRepeatTime : std::numeric_limits<double>::infinity();
    }
    bool answered = false;
    const auto read = [&](const DdsResponse& response) {
      const auto& identity = response.header.identity;
      if (identity.id != id || identity.api_id != api_id) return;
      reply = {response.header.status.code, response.data == nullptr ? "" : response.data};
      answered = true;
    };
    while (!answered && take_loan<DdsResponse>(s.reader, read)) {
    }
    return answered;
  });
  return reply;
}

}  // namespace surefoot
