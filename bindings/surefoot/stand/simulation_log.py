"""Log of a simulated run, tick by tick, without what only one controller has."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import Robot
from surefoot.sim import Push
from surefoot.stand.simulation_settings import SimulationSettings

Array = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]


@dataclass(frozen=True)
class SimulationLog:
    """Log of one run. Row k of every array belongs to the k-th call of update().

    True quantities are the state of MuJoCo at the time of this call. Estimates are the state of the
    estimator after this call. With real sensors an estimate comes from a sample that is one control
    period old, as on the robot. Feet are in leg order, motors in motor order; world z is up.

    Attributes:
        settings: Settings of the run.
        robot: The controller's model of the robot.
        foot_force: Foot force field that has data: "est", "raw", or "dead" if both are zero.
        ground_friction: Friction coefficient of the feet on the ground.
        pushes: Pushes of the run, with impulses in N.s.
        push_shares: Ratio of each impulse to the LIP push limit for its direction and duration.
        lip_limit: LIP push limit for pushes of 0.1 s in the initial pose [N.s]; keys "lateral" and
            "forward".
        fell: True if the robot fell; the log then ends with the last tick before the fall.
        time: (n,) time [s].
        q_true: (n, nq) Pinocchio configuration: position [m], quaternion x y z w, joints [rad].
        v_true: (n, nv) base twist in base axes [m/s, rad/s], joint velocities [rad/s].
        feet: (n, 3, 4) true centres of the foot spheres in the world frame [m].
        forces: (n, 3, 4) force of the ground on each foot in world axes [N].
        com: (n, 3) true centre of mass in the world frame, including the payload [m].
        tau: (n, 12) true motor torques [N.m].
        dq: (n, 12) true joint velocities [rad/s].
        q_estimated: (n, nq) estimate of q_true, in the estimator's world frame.
        v_estimated: (n, nv) estimate of v_true.
        contact: (n, 4) contact confidence of each foot in Controller.state, 0 .. 1.
        status: (n,) surefoot.Status of the tick.
        fallback_level: (n,) surefoot.FallbackLevel of the tick's command.
        torque_mode: (n,) True if the command has all twelve motors in torque mode.
        reach: (n,) surefoot.ReachLimit that stops the body reference before its target.
        reach_motor: (n,) motor whose joint limit stops the body reference; -1: none.
        iterations: (n,) iterations of the QP solver.
        tick_us: (n,) time of Controller.update() as called from Python [us]: wall time of a stand,
            CPU time of a walk.
        commands: (n, 734) bytes of the LowCmds.
    """

    settings: SimulationSettings
    robot: Robot
    foot_force: str
    ground_friction: float
    pushes: tuple[Push, ...]
    push_shares: tuple[float, ...]
    lip_limit: dict[str, float]
    fell: bool
    time: Array
    q_true: Array
    v_true: Array
    feet: Array
    forces: Array
    com: Array
    tau: Array
    dq: Array
    q_estimated: Array
    v_estimated: Array
    contact: Array
    status: IntArray
    fallback_level: IntArray
    torque_mode: npt.NDArray[np.bool_]
    reach: IntArray
    reach_motor: IntArray
    iterations: IntArray
    tick_us: Array
    commands: npt.NDArray[np.uint8]

    def __len__(self) -> int:
        """Return the number of ticks."""
        return len(self.time)

    @property
    def rate(self) -> float:
        """Control rate [Hz]."""
        return float(self.settings.plant.control_rate)

    @property
    def duration(self) -> float:
        """Simulated time [s]."""
        return len(self.time) / self.rate

    @property
    def power(self) -> Array:
        """(n,) sum over the motors of the absolute product of torque and joint velocity [W]."""
        return np.asarray(np.abs(self.tau * self.dq).sum(axis=1))
