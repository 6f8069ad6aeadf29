// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

namespace surefoot {

/// One letter at a time from any thread to the loop; a newer one takes the place of an older.
template <typename T>
class Mailbox {
 public:
  /// From any thread but the loop's.
  void put(const T& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    message_ = message;
    has_message_ = true;
  }

  /// Take what is there. @return false: nothing, or someone is just writing; the next tick will do.
  /// Real-time: yes, it never waits.
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
