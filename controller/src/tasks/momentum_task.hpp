// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the rows of the task of the angular momentum about the centre of mass, world axes [N.m]:
///   sum (p_i - p_com) x f_i = Ldot_ref + kd (L_ref - L)
/// The rows are exact for any motion of the joints (Orin, Goswami, Lee 2013, eq. 2). The caller
/// must subtract the external moment from b. Real-time: yes.
BodyRows momentum_task(const Gains& gains, const Reference& reference,
                       const Dynamics& dynamics) noexcept;

}  // namespace surefoot
