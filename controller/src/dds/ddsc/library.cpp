// SPDX-License-Identifier: BSD-3-Clause
#include "dds/ddsc/library.hpp"

#include <dlfcn.h>
#include <link.h>

#include <filesystem>
#include <vector>

#include "common/text.hpp"
#include "dds/ddsc/library_version.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

constexpr const char* kRemedy =
    "install it with pip install 'surefoot[dds]' (no wheel for aarch64: apt install "
    "libddsc0debian, or ROS), or name its file with --libddsc (library=)";

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kFlags = RTLD_NOW | RTLD_LOCAL;  // sanitizers refuse RTLD_DEEPBIND
#else
// RTLD_DEEPBIND: the library uses its own functions, even if another libddsc has global symbols.
constexpr int kFlags = RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND;
#endif

// Return the library of the Python package cyclonedds in the site-packages of this component, which
// is in site-packages/surefoot/lib.
std::string path_beside_package() {
  Dl_info here{};
  if (dladdr(reinterpret_cast<void*>(&path_beside_package), &here) == 0) return "";
  const auto packages = std::filesystem::path(here.dli_fname).parent_path() / ".." / "..";
  const auto path = packages / "cyclonedds" / ".libs" / "libddsc.so";
  std::error_code problem;
  return std::filesystem::exists(path, problem) ? path.lexically_normal().string() : "";
}

std::vector<std::string> candidates(const std::string& path) {
  if (!path.empty()) return {path};
  std::vector<std::string> names;
  if (const std::string wheel = path_beside_package(); !wheel.empty()) names.push_back(wheel);
  for (const char* name : {"libddsc.so.0debian", "libddsc.so.0", "libddsc.so.11", "libddsc.so"})
    names.emplace_back(name);
  return names;
}

// Return a handle of the first library that loads.
void* open_first(const std::vector<std::string>& names) {
  std::string problem;
  for (const std::string& name : names) {
    if (void* handle = dlopen(name.c_str(), kFlags)) return handle;
    if (problem.empty()) problem = dlerror();
  }
  throw Error("libddsc (Cyclone DDS): got none of " + join(names) + " (" + problem +
              "), expected " + tested_library_versions() + "; " + kRemedy);
}

std::string path_of(void* handle) {
  link_map* map = nullptr;
  return dlinfo(handle, RTLD_DI_LINKMAP, &map) == 0 ? map->l_name : "";
}

// Finds functions by name and remembers which are missing.
struct FunctionFinder {
  void* handle;
  std::vector<std::string> missing;
  template <typename Function>
  void operator()(const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(dlsym(handle, name));
    if (function == nullptr) missing.emplace_back(name);
  }
};

ddsc::Functions find_functions(void* handle, const std::string& path) {
  ddsc::Functions f{};
  FunctionFinder find{handle, {}};
  find("dds_create_domain", f.create_domain);
  find("dds_create_participant", f.create_participant);
  find("dds_create_topic", f.create_topic);
  find("dds_create_reader", f.create_reader);
  find("dds_create_writer", f.create_writer);
  find("dds_delete", f.delete_);
  find("dds_get_guid", f.get_guid);
  find("dds_write", f.write);
  find("dds_take", f.take);
  find("dds_read", f.read);
  find("dds_return_loan", f.return_loan);
  find("dds_create_qos", f.create_qos);
  find("dds_delete_qos", f.delete_qos);
  find("dds_qset_reliability", f.qset_reliability);
  find("dds_qset_history", f.qset_history);
  find("dds_qget_reliability", f.qget_reliability);
  find("dds_qget_prop", f.qget_prop);
  find("dds_create_listener", f.create_listener);
  find("dds_delete_listener", f.delete_listener);
  find("dds_lset_data_available_arg", f.lset_data_available_arg);
  find("dds_strretcode", f.strretcode);
  find("dds_free", f.free);
  if (find.missing.empty()) return f;
  throw Error("libddsc: got " + path + " without " + join(find.missing) +
              ", expected a libddsc of version " + tested_library_versions() + "; " + kRemedy);
}

}  // namespace

DdsLibrary load_dds_library(const std::string& path, bool allow_untested) {
  void* const handle = open_first(candidates(path));
  DdsLibrary library{{}, path_of(handle), ""};
  library.version = library_version(library.path);
  if (library.version.empty()) library.version = "unknown";
  if (!allow_untested && !is_tested_library_version(library.version)) {
    throw Error("libddsc: got version " + library.version + " (" + library.path +
                "), expected a tested one, " + tested_library_versions() + "; " + kRemedy +
                ", or allow an untested version with --untested-libddsc (untested_library)");
  }
  library.functions = find_functions(handle, library.path);
  return library;
}

}  // namespace surefoot
