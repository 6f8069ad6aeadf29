# SPDX-License-Identifier: BSD-3-Clause
"""A module whose import takes 60 s."""

import time

time.sleep(60.0)
