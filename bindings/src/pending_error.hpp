// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Raise the exception that a Python task raised in the last tick of this thread, if there is one.
/// A tick is noexcept, so the exception is stored and raised after the tick.
void raise_pending_error();
