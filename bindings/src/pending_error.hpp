// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

/// Store the exception that a Python task or planner raised, unless one is stored already. Call it
/// in a catch block. A tick is noexcept, so the exception waits for raise_pending_error().
void store_pending_error() noexcept;

/// If a Python task or planner raised an exception in the last tick of this thread, raise this
/// exception.
void raise_pending_error();

/// Return whether the answer of a Python method lets the tick continue: None, or a true value.
bool lets_continue(nanobind::handle answer);
