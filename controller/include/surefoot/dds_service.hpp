// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "surefoot/dds_network.hpp"

namespace surefoot {

/// Codes of a reply that a client makes itself. Source: unitree_sdk2.
constexpr int kServiceNotFound = 3102;  ///< no server has been discovered
constexpr int kServiceTimeout = 3104;   ///< the server has not answered in time

/// Reply of a service, such as motion_switcher.
struct ServiceReply {
  int code = 0;      ///< 0: done; otherwise an error, see also kServiceNotFound, kServiceTimeout
  std::string data;  ///< result, usually JSON
};

/// Request to a service.
struct ServiceRequest {
  std::int64_t id = 0;      ///< number of the request; the reply has the same
  std::int64_t api_id = 0;  ///< number of the function, such as 1001
  std::string parameter;    ///< argument, usually JSON
  bool no_reply = false;    ///< true: the client expects no reply
};

/// Client of a service of unitree_sdk2: topics rt/api/SERVICE/request and /response.
/// Not thread-safe. Real-time: no.
class DdsServiceClient {
 public:
  /// Open the client. Throws surefoot::Error if libddsc cannot.
  /// @param network network of the server
  /// @param service name of the service, such as "motion_switcher"
  DdsServiceClient(std::shared_ptr<DdsNetwork> network, const std::string& service);
  ~DdsServiceClient();
  DdsServiceClient(const DdsServiceClient&) = delete;
  DdsServiceClient& operator=(const DdsServiceClient&) = delete;

  /// Wait for a server; return whether one has been discovered. @param timeout [s]
  bool wait_for_server(double timeout);
  /// Send a request and wait for its reply.
  /// @param api_id number of the function, such as 1001
  /// @param parameter argument, usually JSON
  /// @param timeout longest wait [s]
  /// @param repeat true: send it again every 0.5 s until the reply arrives. The first request of a
  ///   client is lost if the server has not discovered the client yet. Only for requests that
  ///   change nothing, because the server executes each.
  ServiceReply call(std::int64_t api_id, const std::string& parameter, double timeout, bool repeat);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Server of a service of unitree_sdk2. Not thread-safe. Real-time: no.
class DdsServiceServer {
 public:
  /// Open the server. Throws surefoot::Error if libddsc cannot.
  DdsServiceServer(std::shared_ptr<DdsNetwork> network, const std::string& service);
  ~DdsServiceServer();
  DdsServiceServer(const DdsServiceServer&) = delete;
  DdsServiceServer& operator=(const DdsServiceServer&) = delete;

  /// Return the oldest request that waits, if there is one. Never blocks.
  std::optional<ServiceRequest> take();
  /// Send the reply to a request, unless its client expects none.
  void reply(const ServiceRequest& request, const ServiceReply& reply);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
