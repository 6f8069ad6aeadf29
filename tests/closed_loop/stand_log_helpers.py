"""Stand logs with known contents."""

import math

import numpy as np
import surefoot
from surefoot.stand import StandLog, StandSettings
from surefoot.stand.foot_frame import foot_positions

RATE, TICKS = 500, 2000
ROBOT = surefoot.load_robot("go1")


def still_log(**changes):
    """Return a log of 4 s without any motion."""
    q = np.tile(ROBOT.q_standing(), (TICKS, 1))
    q[:, 2] = 0.3
    rows, motors = np.zeros((TICKS, ROBOT.nv)), np.zeros((TICKS, 12))
    fields = {
        **{"settings": StandSettings(duration=TICKS / RATE), "robot": ROBOT, "foot_force": "dead"},
        **{"ground_friction": 0.8},
        **{"pushes": (), "push_shares": (), "fell": False},
        **{"lip_limit": {"lateral": 12.0, "forward": 19.0}, "time": np.arange(TICKS) / RATE},
        **{"q_true": q, "v_true": rows, "q_estimated": q.copy(), "v_estimated": rows.copy()},
        **{"feet": foot_positions(ROBOT, q), "forces": np.zeros((TICKS, 3, 4))},
        **{"com": np.zeros((TICKS, 3)), "tau": motors, "dq": motors.copy()},
        **{"contact": np.ones((TICKS, 4)), "status": np.zeros(TICKS, dtype=np.int64)},
        **{"torque_mode": np.ones(TICKS, dtype=bool), "iterations": np.ones(TICKS, dtype=np.int64)},
        **{
            "reach": np.zeros(TICKS, dtype=np.int64),
            "fallback_level": np.zeros(TICKS, dtype=np.int64),
        },
        **{"reach_motor": np.full(TICKS, -1)},
        **{"tick_us": np.linspace(0.0, 100.0, TICKS), "commands": np.zeros((TICKS, 734), np.uint8)},
    }
    return StandLog(**{**fields, **changes})


def turn_base(q, axis, degrees):
    """Return q with the base rotated from level about one of its axes."""
    q = q.copy()
    q[3:7] = 0.0
    q[3 + axis], q[6] = math.sin(math.radians(degrees / 2)), math.cos(math.radians(degrees / 2))
    return q
