// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

namespace surefoot {

/// Slot for one message from other threads to the loop. A new message replaces an unread message.
template <typename T>
class Mailbox {
 public:
  /// Store a message. Call it from any thread except that of the loop. Real-time: no.
  void put(const T& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    message_ = message;
    has_message_ = true;
  }

  /// Take the message out of the slot. Never waits. Real-time: yes.
  /// @return false if there is no message, or if another thread is writing a message now; in the
  ///   second case the caller gets the message in a later tick
  bool take(T& message) noexcept {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock() || !has_message_) return false;
    message = message_;
    has_message_ = false;
    return true;
  }

 private:
  std::mutex mutex_;
  T message_;
  bool has_message_ = false;
};

}  // namespace surefoot
