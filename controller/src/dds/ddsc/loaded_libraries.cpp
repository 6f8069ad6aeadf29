// SPDX-License-Identifier: BSD-3-Clause
#include "dds/ddsc/loaded_libraries.hpp"

#include <dlfcn.h>
#include <link.h>

#include <cstdint>
#include <vector>

namespace surefoot {

namespace {

// Signature of dds_lookup_participant(): the number of participants of a domain, or an error.
using LookupParticipant = std::int32_t(std::uint32_t domain, std::int32_t* found, std::size_t size);

int add_libddsc(dl_phdr_info* info, std::size_t, void* paths) {
  const std::string path = info->dlpi_name;
  const std::string name = path.substr(path.rfind('/') + 1);
  if (name.rfind("libddsc", 0) == 0) static_cast<std::vector<std::string>*>(paths)->push_back(path);
  return 0;
}

bool is_in_domain(const std::string& path, int domain) {
  void* const handle = dlopen(path.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (handle == nullptr) return false;
  auto* const lookup =
      reinterpret_cast<LookupParticipant*>(dlsym(handle, "dds_lookup_participant"));
  const bool found =
      lookup != nullptr && lookup(static_cast<std::uint32_t>(domain), nullptr, 0) > 0;
  dlclose(handle);  // only gives back the reference of this function
  return found;
}

}  // namespace

std::string library_in_domain(int domain) {
  std::vector<std::string> paths;
  dl_iterate_phdr(&add_libddsc, &paths);
  for (const std::string& path : paths) {
    if (is_in_domain(path, domain)) return path;
  }
  return "";
}

}  // namespace surefoot
