"""Recorder of a simulated run: one row per tick and array, and the values known before the run."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from surefoot._core import LowCmd, PosStopF, StandController, VelStopF
from surefoot.sim import Plant, Push, Truth
from surefoot.stand.simulation_settings import SimulationSettings

MOTOR_COUNT = 12
SERVO = 0x0A


def is_torque_mode(command: LowCmd) -> bool:
    """Return True if a command has all twelve motors in torque mode: no stiffness, no damping."""
    motors = (command.motorCmd[i] for i in range(MOTOR_COUNT))
    return all(
        motor.mode == SERVO
        and motor.Kp == 0.0
        and motor.Kd == 0.0
        and motor.q == PosStopF
        and motor.dq == VelStopF
        for motor in motors
    )


def log_header(settings: SimulationSettings, plant: Plant) -> dict[str, Any]:
    """Return the fields of the log that are known before the run."""
    pushes = tuple(request.resolve(plant) for request in settings.pushes)
    return {
        "settings": settings,
        "robot": plant.robot,
        "foot_force": plant.settings.foot_force,
        "ground_friction": plant.friction,
        "pushes": pushes,
        "push_shares": tuple(_lip_share(plant, push) for push in pushes),
        "lip_limit": {name: plant.lip_push_limit(name) for name in ("lateral", "forward")},
    }


def _lip_share(plant: Plant, push: Push) -> float:
    limit = plant.lip_push_limit(push.direction, push.duration)
    return push.impulse / limit if limit > 0.0 else math.inf


class LogRecorder:
    """Arrays of the log; record() fills one row of each array per tick.

    Args:
        ticks: Number of rows to allocate.
        nq: Size of q.
        nv: Size of v.
        more: Further arrays by name: shape of a row, and type of its entries.
    """

    def __init__(
        self,
        ticks: int,
        nq: int,
        nv: int,
        more: Mapping[str, tuple[tuple[int, ...], type]] = MappingProxyType({}),
    ) -> None:
        shapes: dict[str, tuple[int, ...]] = {
            **{"time": (), "tick_us": ()},
            **{"q_true": (nq,), "v_true": (nv,), "q_estimated": (nq,), "v_estimated": (nv,)},
            **{"feet": (3, 4), "forces": (3, 4), "com": (3,), "contact": (4,)},
            **{"tau": (MOTOR_COUNT,), "dq": (MOTOR_COUNT,)},
        }
        self._rows: dict[str, np.ndarray] = {k: np.zeros((ticks, *s)) for k, s in shapes.items()}
        for name in ("status", "fallback_level", "iterations", "reach", "reach_motor"):
            self._rows[name] = np.zeros(ticks, dtype=np.int64)
        self._rows["torque_mode"] = np.zeros(ticks, dtype=np.bool_)
        self._rows["commands"] = np.zeros((ticks, len(LowCmd().raw)), dtype=np.uint8)
        for name, (shape, kind) in more.items():
            self._rows[name] = np.zeros((ticks, *shape), dtype=kind)
        self._count = 0

    def record(
        self,
        truth: Truth,
        controller: StandController,
        command: LowCmd,
        tick_us: float,
        more: Mapping[str, Any] = MappingProxyType({}),
    ) -> None:
        """Append the values of one tick as a row; `more` has those of the further arrays."""
        rows, k = self._rows, self._count
        estimate = controller.state
        rows["time"][k], rows["tick_us"][k] = truth.time, tick_us
        rows["q_true"][k], rows["v_true"][k] = truth.q, truth.v
        rows["feet"][k], rows["forces"][k] = truth.p_world_feet, truth.foot_forces
        rows["com"][k], rows["tau"][k], rows["dq"][k] = truth.com, truth.tau, truth.dq
        rows["q_estimated"][k], rows["v_estimated"][k] = estimate.q, estimate.v
        rows["contact"][k] = estimate.contact
        rows["status"][k], rows["fallback_level"][k] = (
            controller.status.value,
            controller.fallback_level.value,
        )
        reach = controller.reach
        rows["reach"][k], rows["reach_motor"][k] = reach.limit.value, reach.motor
        rows["iterations"][k] = controller.solution.iterations
        rows["torque_mode"][k] = is_torque_mode(command)
        rows["commands"][k] = command.raw
        for name, value in more.items():
            rows[name][k] = value
        self._count += 1

    def arrays(self) -> dict[str, Any]:
        """Return the recorded rows of every array, by the array's name."""
        return {name: rows[: self._count] for name, rows in self._rows.items()}
