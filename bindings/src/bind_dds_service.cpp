// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "surefoot/dds_service.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_client(nb::module_& m) {
  nb::class_<DdsServiceClient>(
      m, "DdsServiceClient",
      "Client of a service of unitree_sdk2: topics rt/api/SERVICE/request and /response.\n\n"
      "Not thread-safe.")
      .def(nb::init<std::shared_ptr<DdsNetwork>, const std::string&>(), "network"_a, "service"_a,
           "Open the client of a service, such as 'motion_switcher'.")
      .def("wait_for_server", &DdsServiceClient::wait_for_server, "timeout"_a,
           nb::call_guard<nb::gil_scoped_release>(),
           "Wait for a server for at most a timeout [s]; return whether one was discovered.")
      .def(
          "call",
          [](DdsServiceClient& client, std::int64_t api_id, const std::string& parameter,
             double timeout, bool repeat) {
            const ServiceReply reply = client.call(api_id, parameter, timeout, repeat);
            return std::pair(reply.code, reply.data);
          },
          "api_id"_a, "parameter"_a, "timeout"_a, "repeat"_a = false,
          nb::call_guard<nb::gil_scoped_release>(),
          "Send a request and wait for its reply.\n\n"
          "Args:\n"
          "    api_id: Number of the function.\n"
          "    parameter: Argument, usually JSON.\n"
          "    timeout: Longest wait [s].\n"
          "    repeat: If True, send the request again every 0.5 s until the reply arrives.\n"
          "        The first request is lost if the server has not discovered this client yet.\n"
          "        Only for requests that change nothing, because the server executes each.\n\n"
          "Returns:\n"
          "    The code and the data of the reply. The code is 0 if the request was done, 3102 if\n"
          "    no server was discovered, and 3104 if the server has not answered in time.");
}

void bind_server(nb::module_& m) {
  nb::class_<ServiceRequest>(m, "ServiceRequest", "Request to a service.")
      .def_ro("id", &ServiceRequest::id, "Number of the request; the reply has the same.")
      .def_ro("api_id", &ServiceRequest::api_id, "Number of the function, such as 1001.")
      .def_ro("parameter", &ServiceRequest::parameter, "Argument, usually JSON.")
      .def_ro("no_reply", &ServiceRequest::no_reply, "True if the client expects no reply.");
  nb::class_<DdsServiceServer>(m, "DdsServiceServer",
                               "Server of a service of unitree_sdk2. Not thread-safe.")
      .def(nb::init<std::shared_ptr<DdsNetwork>, const std::string&>(), "network"_a, "service"_a,
           "Open the server of a service, such as 'motion_switcher'.")
      .def("take", &DdsServiceServer::take,
           "Return the oldest request that waits, or None. Never blocks.")
      .def(
          "reply",
          [](DdsServiceServer& server, const ServiceRequest& request, int code,
             const std::string& data) { server.reply(request, {code, data}); },
          "request"_a, "code"_a, "data"_a = "",
          "Send the reply to a request, unless its client expects none.");
}

}  // namespace

void bind_dds_service(nb::module_& m) {
  bind_client(m);
  bind_server(m);
}
