"""What is kept of a run, tick by tick."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import Robot
from surefoot.sim import Push
from surefoot.stand.settings import StandSettings

Array = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]


@dataclass(frozen=True)
class StandLog:
    """One run. Row k of every array is the instant when the controller is called the k-th time.

    True quantities are MuJoCo's at that instant. Estimates are what the controller believes after
    that call; with real sensors they rest on a report that is one period old, as on the robot.
    Feet run FR FL RR RL, motors in SDK order, world z is up.

    Attributes:
        settings: What was asked for.
        robot: The controller's model of the robot.
        foot_force: Which force field lived: "est", "raw" or "dead".
        pushes: Those applied, impulses in N.s.
        push_shares: Each impulse as a fraction of the limit in its direction and duration.
        lip_limit: Impulse of 0.1 s that the linear inverted pendulum survives at the start [N.s];
            keys "lateral", "forward".
        fell: Whether the robot fell; then the log ends with the last tick before it.
        time: (n,) [s].
        q_true: (n, nq) Pinocchio's: position, quaternion x y z w, joints.
        v_true: (n, nv) base twist in base axes, joint velocities.
        feet: (n, 3, 4) true centres of the foot spheres, world [m].
        forces: (n, 3, 4) ground on foot, world axes [N].
        com: (n, 3) true centre of mass, payload included, world [m].
        tau: (n, 12) true motor torque [N.m].
        dq: (n, 12) true joint velocity [rad/s].
        q_estimated: (n, nq) as q_true, in the estimator's own world.
        v_estimated: (n, nv) as v_true.
        contact: (n, 4) estimated probability that a foot bears load.
        status: (n,) surefoot.Status of the tick.
        rung: (n,) surefoot.FallbackLevel of the tick: where its command came from.
        torque_mode: (n,) whether all twelve motors were commanded in pure torque mode.
        iterations: (n,) of the quadratic program's solver.
        reach: (n,) surefoot.ReachLimit: what kept the body from where it was asked to be.
        reach_motor: (n,) SDK motor of that limit, or -1.
        tick_us: (n,) wall time of StandController.update() as called from Python [us].
        commands: (n, 734) bytes of the LowCmds.
    """

    settings: StandSettings
    robot: Robot
    foot_force: str
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
    rung: IntArray
    torque_mode: npt.NDArray[np.bool_]
    iterations: IntArray
    reach: IntArray
    reach_motor: IntArray
    tick_us: Array
    commands: npt.NDArray[np.uint8]

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
        """(n,) sum of |torque x joint velocity| over the motors [W]."""
        return np.asarray(np.abs(self.tau * self.dq).sum(axis=1))
