"""Log of a walk, tick by tick."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot.stand.simulation_log import Array, IntArray, SimulationLog
from surefoot.walk.settings import WalkSettings


@dataclass(frozen=True)
class WalkLog(SimulationLog):
    """Log of one walk: the arrays of SimulationLog, and those of a WalkController.

    Velocities are vx, vy [m/s] and yaw rate [rad/s] in the heading frame.

    Attributes:
        settings: Settings of the run.
        mass: True mass of the robot with its payload [kg].
        ground_normal: (3,) unit normal of the ground in world axes.
        com_velocity: (n, 3) true velocity of the centre of mass in world axes [m/s].
        slip_velocity: (n, 3, 4) velocity of the point of each foot sphere that touches the ground,
            in world axes [m/s]. A foot that rolls has slip velocity 0.
        leg_contacts: (n,) number of pairs of a leg with another leg or the trunk that begin to
            touch in this tick.
        body_reference: (n, 3) height [m], roll and pitch [rad] of the body reference, which moves
            to the requested one.
        commanded: (n, 3) commanded velocity, clamped by the controller.
        reference: (n, 3) velocity of the reference, which approaches `commanded`.
        limit: (n,) surefoot.WalkLimit to which the command was clamped.
        walking: (n,) True if the controller planned steps.
        friction: (n,) friction coefficient of the ground that the estimator has learnt.
        planned_loads: (n, 4) planned load of each foot, 0 .. 1; 0: the foot swings.
        footholds: (n, 3, 4) planned footholds in the estimator's world frame [m].
    """

    settings: WalkSettings
    mass: float
    ground_normal: Array
    com_velocity: Array
    slip_velocity: Array
    leg_contacts: IntArray
    body_reference: Array
    commanded: Array
    reference: Array
    limit: IntArray
    walking: npt.NDArray[np.bool_]
    friction: Array
    planned_loads: Array
    footholds: Array

    @property
    def weight(self) -> float:
        """True weight of the robot [N]."""
        return 9.81 * self.mass

    @property
    def normal_forces(self) -> Array:
        """(n, 4) force of the ground on each foot along the ground's normal [N]."""
        return np.asarray(np.einsum("j,njk->nk", self.ground_normal, self.forces))
