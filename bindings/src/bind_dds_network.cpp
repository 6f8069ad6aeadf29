// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "surefoot/dds_network.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

void bind_dds_network(nb::module_& m) {
  nb::class_<DdsNetwork>(
      m, "DdsNetwork",
      "Membership of this process in a DDS domain on one network interface.\n\n"
      "Loads libddsc, the C library of Cyclone DDS, at run time. The settings of Cyclone\n"
      "DDS are its own: CYCLONEDDS_URI is not used. The participant sends no type\n"
      "information, because Cyclone DDS 0.10.2, which robots run, crashes on that of\n"
      "newer versions. Not thread-safe.")
      .def(
          "__init__",
          [](DdsNetwork* self, const std::string& interface, int domain, bool real_robot,
             const std::string& library, bool untested_library) {
            new (self) DdsNetwork({interface, domain, real_robot, library, untested_library});
          },
          "interface"_a, "domain"_a = 0, "real_robot"_a = false, "library"_a = "",
          "untested_library"_a = false, nb::call_guard<nb::gil_scoped_release>(),
          "Join the domain.\n\n"
          "Args:\n"
          "    interface: Name of the network interface, such as 'lo' or 'enp3s0'.\n"
          "    domain: DDS domain, 0 .. 230; robots: 0, unitree_mujoco: 1.\n"
          "    real_robot: If True, any interface is allowed, otherwise only loopback.\n"
          "    library: File of libddsc; '': that of the package cyclonedds, else that of\n"
          "        the system.\n"
          "    untested_library: If True, a version of libddsc that was not tested is\n"
          "        allowed.\n\n"
          "Raises:\n"
          "    Error: The interface does not exist, is down, has no IPv4 address or no\n"
          "        multicast, or is not loopback and real_robot is False; libddsc is\n"
          "        missing or of an untested version; or this process is already in the\n"
          "        domain.")
      .def_prop_ro("notices", &DdsNetwork::notices,
                   "Sentences about the settings for the operator, such as the version of\n"
                   "libddsc.");
}
