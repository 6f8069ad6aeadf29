"""True motion of one walk of any controller."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot.geometry.rotations import Array
from surefoot.sim import Plant, Truth
from surefoot.walk.slip import slip_velocities


@dataclass(frozen=True)
class TrueWalk:
    """True motion of a walk, a surefoot.walk.walk_motion.WalkMotion.

    Row k of every array belongs to the k-th call of the controller; the arrays are those of
    surefoot.walk.WalkLog.

    Attributes:
        fell: True if the robot fell; the last row is then the last one before the fall.
        torque_limit: (n, 12) torque limit of each motor at its speed [N.m].
    """

    rate: float
    weight: float
    ground_normal: Array
    fell: bool
    q_true: Array
    v_true: Array
    com_velocity: Array
    feet: Array
    normal_forces: Array
    slip_velocity: Array
    leg_contacts: Array
    commanded: Array
    tau: Array
    dq: Array
    torque_limit: Array

    @property
    def body_reference(self) -> Array:
        """(n, 3) height, roll and pitch of the body reference: a scorecard requests none."""
        return np.zeros((len(self.tau), 3))


class WalkRecorder:
    """Recorder of the true motion of a walk; record() fills one row of each array.

    Args:
        plant: The plant.
        ticks: Largest number of rows.
    """

    def __init__(self, plant: Plant, ticks: int) -> None:
        self._plant, self._count = plant, 0
        self._touching: frozenset[tuple[str, str]] = frozenset()
        nq, nv = plant.robot.nq, plant.robot.nv
        shapes: dict[str, tuple[int, ...]] = {
            **{"q_true": (nq,), "v_true": (nv,), "com_velocity": (3,), "feet": (3, 4)},
            **{"normal_forces": (4,), "slip_velocity": (3, 4), "leg_contacts": ()},
            **{"commanded": (3,), "tau": (12,), "dq": (12,)},
        }
        self._rows = {name: np.zeros((ticks, *shape)) for name, shape in shapes.items()}

    def record(self, truth: Truth, commanded: Array) -> None:
        """Append a row with a true state of the plant and the commanded velocity (3,)."""
        rows, k, plant = self._rows, self._count, self._plant
        rows["q_true"][k], rows["v_true"][k] = truth.q, truth.v
        rows["com_velocity"][k], rows["feet"][k] = truth.com_velocity, truth.p_world_feet
        rows["normal_forces"][k] = plant.handles.ground_normal @ truth.foot_forces
        rows["slip_velocity"][k] = slip_velocities(plant)
        before, self._touching = self._touching, plant.leg_contacts
        rows["leg_contacts"][k] = len(self._touching - before)
        rows["commanded"][k], rows["tau"][k], rows["dq"][k] = commanded, truth.tau, truth.dq
        self._count += 1

    def walk(self, fell: bool) -> TrueWalk:
        """Return the motion that was recorded."""
        plant, config = self._plant, self._plant.robot.config
        rows = {name: array[: self._count] for name, array in self._rows.items()}
        # The limit holds for a torque along the motion; a braking motor has the full torque.
        speed = np.maximum(np.sign(rows["tau"]) * rows["dq"], 0.0)
        corner, none = np.array(config.corner_speed), np.array(config.no_load_speed)
        share = np.clip((none - speed) / (none - corner), 0.0, 1.0)
        return TrueWalk(
            rate=plant.settings.control_rate,
            weight=9.81 * float(plant.model.body_subtreemass[plant.handles.root]),
            ground_normal=plant.handles.ground_normal,
            fell=fell,
            torque_limit=np.array(config.tau_max) * share,
            **rows,
        )
