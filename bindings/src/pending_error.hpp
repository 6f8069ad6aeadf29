// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// If a Python task raised an exception in the last tick of this thread, raise this exception. A
/// tick is noexcept, so the exception is stored during the tick and raised here.
void raise_pending_error();
