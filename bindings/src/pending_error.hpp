// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The tick is noexcept: what a task written in Python raises inside it is kept, and raised here
/// when the tick is over.
void raise_pending_error();
