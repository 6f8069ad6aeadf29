// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

namespace surefoot {

/// One letter at a time from any thread to the loop; a newer one takes the place of an older.
template <typename T>
class Mailbox {
 public:
  /// From any thread but the loop's.
  void put(const T& letter) {
    const std::lock_guard<std::mutex> lock(mutex_);
    letter_ = letter;
    full_ = true;
  }

  /// Take what is there. @return false: nothing, or someone is just writing; the next tick will do.
  /// Real-time: yes, it never waits.
  bool take(T& letter) noexcept {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock() || !full_) return false;
    letter = letter_;
    full_ = false;
    return true;
  }

 private:
  std::mutex mutex_;
  T letter_;
  bool full_ = false;
};

}  // namespace surefoot
