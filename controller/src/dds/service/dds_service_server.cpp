// SPDX-License-Identifier: BSD-3-Clause
#include "dds/service/service_topics.hpp"
#include "surefoot/dds_service.hpp"

namespace surefoot {

struct DdsServiceServer::Impl {
  Impl(std::shared_ptr<DdsNetwork> n, const std::string& service)
      : network(std::move(n)),
        reader(participant_of(network), unitree_api_msg_dds__Request__desc,
               request_topic(service).c_str()),
        writer(network->participant(), unitree_api_msg_dds__Response__desc,
               response_topic(service).c_str()) {}

  std::shared_ptr<DdsNetwork> network;
  DdsReader reader;
  DdsWriter writer;
};

DdsServiceServer::DdsServiceServer(std::shared_ptr<DdsNetwork> network, const std::string& service)
    : impl_(std::make_unique<Impl>(std::move(network), service)) {}
DdsServiceServer::~DdsServiceServer() = default;

std::optional<ServiceRequest> DdsServiceServer::take() {
  std::optional<ServiceRequest> taken;
  const auto read = [&](const DdsRequest& request) {
    taken = ServiceRequest{request.header.identity.id, request.header.identity.api_id,
                           request.parameter == nullptr ? "" : request.parameter,
                           request.header.policy.noreply};
  };
  while (!taken && take_loan<DdsRequest>(impl_->reader, read)) {
  }
  return taken;
}

void DdsServiceServer::reply(const ServiceRequest& request, const ServiceReply& reply) {
  if (request.no_reply) return;
  std::string text = reply.data;
  DdsResponse response{};
  response.header.identity = {request.id, request.api_id};
  response.header.status.code = reply.code;
  response.data = text.data();
  impl_->writer.write(&response);
}

}  // namespace surefoot
