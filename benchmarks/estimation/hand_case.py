"""Case hand: attitude while a hand moves the IMU, beside VQF on the same samples."""

from __future__ import annotations

import numpy as np
from surefoot import Robot
from surefoot.estimate.baselines import BaselineInputs
from surefoot.estimate.baselines.vqf_attitude import vqf_attitude

from estimation.errors import matrices, rms
from estimation.hand_log import HANDS, hand_log
from estimation.hand_motion import REST_TIME
from estimation.log_rows import Array, Log
from estimation.metrics import Result, Values
from estimation.replay import replay

ESTIMATES = ("VQF", "torques", "no torques")


def hand(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Evaluate the RMS error of the inclination of every kind of motion."""
    values: Values = {}
    squares: dict[str, list[float]] = {who: [] for who in ESTIMATES}
    for k, (name, kind) in enumerate(HANDS.items()):
        log = hand_log(robot, kind, [seed, k, 5])
        known = {**log, "tauEst": log["tau_hanging"]}
        attitudes = {
            "VQF": vqf_attitude(_baseline_inputs(robot, log)),
            "torques": matrices(replay(robot, known).q[:, [6, 3, 4, 5]]),
            "no torques": matrices(replay(robot, log).q[:, [6, 3, 4, 5]]),
        }
        for who, rotation in attitudes.items():
            error = inclination_rms(log, rotation)
            values[f"inclination RMS, {who}: {name}"] = error
            squares[who].append(error**2)
    for who in ESTIMATES[1:]:
        ratio = np.mean(squares[who]) / np.mean(squares["VQF"])
        values[f"inclination RMS / that of VQF, {who}"] = float(np.sqrt(ratio))
    return Result(values)


def inclination_rms(log: Log, rotation: Array) -> float:
    """Return the RMS angle [deg] between estimated and true vertical after the initial rest."""
    up, true_up = rotation[:, 2], log["truth_rotation"][:, 2]
    angle = np.arctan2(np.linalg.norm(np.cross(up, true_up), axis=1), np.sum(up * true_up, axis=1))
    moves = log["tick"] > 1000.0 * REST_TIME
    return float(np.degrees(rms(angle[moves])))


def _baseline_inputs(robot: Robot, log: Log) -> BaselineInputs:
    return BaselineInputs.from_imu(
        robot,
        log["tick"] / 1000.0,
        *(log["gyroscope"], log["accelerometer"], log["q"], log["dq"]),
        np.zeros((len(log["tick"]), 4), bool),
    )
