# SPDX-License-Identifier: BSD-3-Clause
"""A module that cannot be imported in any reasonable time."""

import time

time.sleep(60.0)
