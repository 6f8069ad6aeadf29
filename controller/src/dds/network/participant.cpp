// SPDX-License-Identifier: BSD-3-Clause
#include "dds/network/participant.hpp"

#include "surefoot/error.hpp"

namespace surefoot {

namespace {

DdsEntity create_domain(const ddsc::Functions& functions, int domain, const std::string& config) {
  const ddsc::Entity created =
      functions.create_domain(static_cast<std::uint32_t>(domain), config.c_str());
  const std::string what = "DDS domain " + std::to_string(domain);
  return DdsEntity(functions, created, what);
}

}  // namespace

std::string to_text(const ddsc::Functions& functions, ddsc::Return code) {
  return std::string(functions.strretcode(code)) + " (" + std::to_string(code) + ")";
}

DdsEntity::DdsEntity(const ddsc::Functions& functions, ddsc::Entity created,
                     const std::string& what)
    : functions_(&functions), handle_(created) {
  if (created > 0) return;
  functions_ = nullptr;
  throw Error(what + ": libddsc could not create it: " + to_text(functions, created));
}

DdsEntity::~DdsEntity() {
  if (functions_ != nullptr) functions_->delete_(handle_);
}

DdsParticipant::DdsParticipant(DdsLibrary library, int domain, const std::string& config)
    : library_(std::move(library)),
      domain_(create_domain(library_.functions, domain, config)),
      participant_(library_.functions,
                   library_.functions.create_participant(static_cast<std::uint32_t>(domain),
                                                         nullptr, nullptr),
                   "DDS participant") {}

const DdsParticipant& participant_of(const std::shared_ptr<DdsNetwork>& network) {
  if (network == nullptr) throw Error("network: got none, expected a DdsNetwork");
  return network->participant();
}

}  // namespace surefoot
