"""Trace of a plant's true state, from which a cost is computed."""

from __future__ import annotations

import numpy as np

from surefoot.geometry.rotations import Array
from surefoot.sim import Plant
from surefoot.sim.truth import has_fallen

MOTOR_COUNT = 12


class Trace:
    """Ring buffer of a plant's true state, one row per control period.

    Args:
        plant: The plant.
        ticks: Capacity in rows; further rows replace the oldest rows.

    Attributes:
        fell: True if the robot has fallen since the last clear().
    """

    def __init__(self, plant: Plant, ticks: int) -> None:
        self._plant = plant
        self._rows = {
            "time": np.zeros(ticks),
            "base": np.zeros((ticks, 7)),
            "velocity": np.zeros((ticks, 3)),
            "feet": np.zeros((ticks, 4, 3)),
            "tau": np.zeros((ticks, MOTOR_COUNT)),
            "dq": np.zeros((ticks, MOTOR_COUNT)),
            "push": np.zeros(ticks),
        }
        self._capacity, self._count = ticks, 0
        self.fell = False

    def __len__(self) -> int:
        """Return the number of rows."""
        return min(self._count, self._capacity)

    def clear(self) -> None:
        """Delete all rows."""
        self._count, self.fell = 0, False

    def record(self) -> None:
        """Add a row with the present state of the plant."""
        rows, k, plant = self._rows, self._count % self._capacity, self._plant
        data, handles = plant.data, plant.handles
        rows["time"][k] = plant.time
        rows["base"][k] = data.qpos[:7]
        rows["velocity"][k] = data.qvel[:3]
        rows["feet"][k] = data.xpos[handles.foot_bodies]
        rows["tau"][k] = plant.motors.torque
        rows["dq"][k] = data.qvel[handles.motor_v]
        rows["push"][k] = np.abs(plant.push_force[0]).max()
        self._count += 1
        if not self.fell:
            self.fell = has_fallen(data, handles)

    @property
    def rate(self) -> float:
        """Rows per second [Hz]."""
        return self._plant.settings.control_rate

    @property
    def weight(self) -> float:
        """True weight with payload [N]."""
        return float(self._plant.model.body_subtreemass[self._plant.handles.root] * 9.81)

    @property
    def tau_max(self) -> Array:
        """Torque limits (12,) [N.m]."""
        return np.array(self._plant.robot.config.tau_max)

    def column(self, name: str) -> Array:
        """Return one recorded quantity, oldest row first.

        Args:
            name: "time" (n,) [s]; "base" (n, 7) position [m] and quaternion w x y z; "velocity"
                (n, 3) of the base [m/s]; "feet" (n, 4, 3) positions [m]; "tau" (n, 12) motor
                torques [N.m]; "dq" (n, 12) motor velocities, on the rotor's side of the gears
                [rad/s];
                "push" (n,) greatest component of the push force [N]. Positions, velocities and
                forces are in world axes.
        """
        rows = self._rows[name]
        if self._count <= self._capacity:
            return rows[: self._count]
        return np.roll(rows, -(self._count % self._capacity), axis=0)
