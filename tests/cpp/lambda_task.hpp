// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "surefoot/task.hpp"

/// A user's task whose write() is a function that the test passes.
class LambdaTask : public surefoot::Task {
 public:
  using Write = std::function<bool(const surefoot::RobotState&, surefoot::TaskRows&)>;
  LambdaTask(int rows, Write write) : rows_(rows), write_(std::move(write)) {}
  int rows() const override { return rows_; }
  bool write(const surefoot::RobotState& state, surefoot::TaskRows& rows) noexcept override {
    return write_(state, rows);
  }

 private:
  int rows_;
  Write write_;
};

inline std::shared_ptr<surefoot::Task> task(int rows, LambdaTask::Write write) {
  return std::make_shared<LambdaTask>(rows, std::move(write));
}
