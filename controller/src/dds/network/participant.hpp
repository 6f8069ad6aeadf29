// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "dds/ddsc/library.hpp"
#include "surefoot/dds_network.hpp"

namespace surefoot {

/// Entity of DDS that is deleted with its owner, together with the entities that belong to it.
class DdsEntity {
 public:
  DdsEntity() = default;
  /// Take over an entity that libddsc has just created. Throws surefoot::Error if it is a return
  /// code.
  /// @param what name of the entity in the error
  DdsEntity(const ddsc::Functions& functions, ddsc::Entity created, const std::string& what);
  ~DdsEntity();
  DdsEntity(DdsEntity&& other) noexcept
      : functions_(std::exchange(other.functions_, nullptr)), handle_(other.handle_) {}
  DdsEntity& operator=(DdsEntity&& other) noexcept {
    std::swap(functions_, other.functions_);
    std::swap(handle_, other.handle_);
    return *this;
  }

  ddsc::Entity handle() const noexcept { return handle_; }

 private:
  const ddsc::Functions* functions_ = nullptr;
  ddsc::Entity handle_ = 0;
};

/// Domain, participant and libddsc of a DdsNetwork.
class DdsParticipant {
 public:
  /// Create the domain and its participant. Throws surefoot::Error if libddsc is missing or
  /// untested, or if it is already in the domain.
  /// @param config settings of Cyclone DDS, XML
  DdsParticipant(DdsLibrary library, int domain, const std::string& config);
  // Entities point to the functions in library_.
  DdsParticipant(const DdsParticipant&) = delete;
  DdsParticipant& operator=(const DdsParticipant&) = delete;

  const DdsLibrary& library() const noexcept { return library_; }
  const ddsc::Functions& functions() const noexcept { return library_.functions; }
  ddsc::Entity handle() const noexcept { return participant_.handle(); }

 private:
  DdsLibrary library_;
  DdsEntity domain_, participant_;
};

/// Return the participant of a network. Throws surefoot::Error if there is no network.
const DdsParticipant& participant_of(const std::shared_ptr<DdsNetwork>& network);

/// Return "ERROR (-1)" for a return code of libddsc. Real-time: no.
std::string to_text(const ddsc::Functions& functions, ddsc::Return code);

}  // namespace surefoot
