"""Control of a robot on UDP: LowState to LowCmd behind the protections, damping that latches."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import (
    Button,
    Gains,
    LowState,
    Robot,
    Safety,
    StandController,
    Status,
    UdpLink,
    WirelessRemote,
    damping_low_cmd,
)
from surefoot.sim.rotations import Array
from surefoot.tune.live.curves import Sample
from surefoot.tune.live.measures import pose_errors, torque_ratio

HOLD = 0.01  # [s] without a LowState in which the last command is repeated
STALE = 0.02  # [s] after which the damping is for good ...
FORGIVEN = 0.1  # [s] ... unless the robot's own clock stood still too, for no longer than this
AWAY = 0.1  # [s] that this program may stand still
_MOTORS = 12


@dataclass(frozen=True)
class Place:
    """Where a robot is and what it speaks.

    Attributes:
        host: Its address.
        port: Its UDP port.
        generation: Of its frames.
        power_level: Of the power protection, N x 100 W; 0 switches it off.
    """

    host: str
    port: int
    generation: str
    power_level: int = 1

    def __str__(self) -> str:
        return f"{self.host}:{self.port}"


@dataclass(frozen=True)
class Report:
    """What the loop says of itself.

    Attributes:
        phase: "waiting", "standing" or "damping".
        reason: Of the damping; while waiting, why what has come was not taken.
        q: (nq,) Pinocchio's, estimated; None before the robot has spoken.
        forces: (3, 4) that the program asks of the feet, world axes [N].
        contact: (4,) feet that are believed to bear.
        sample: The greatest of each number since the last report.
    """

    phase: str
    reason: str
    q: Array | None
    forces: Array
    contact: npt.NDArray[np.bool_]
    sample: Sample


class RobotLoop:
    """One robot under one controller; `tick()` comes once a control period.

    It keeps to what StandRunner keeps to: a command is repeated for 10 ms, then the motors damp,
    after 20 ms for good; so they do when this program stood still, the robot began anew, the power
    protection trips, the controller gives up or B is pressed on the remote.

    Args:
        robot: The robot.
        place: Where it is.
        gains: Of the controller.

    Raises:
        Error: What UdpLink raises.
    """

    def __init__(self, robot: Robot, place: Place, gains: Gains) -> None:
        self._link = UdpLink(place.host, place.port, place.generation, 0, gains.damping_kd)
        self.controller = StandController(robot, gains)
        self._safety, self._level = Safety(robot), place.power_level
        self._tau_max = np.array(robot.config.tau_max)
        self._damping = self._command = damping_low_cmd(gains.damping_kd)
        self._phase, self._reason = "waiting", ""
        self._robot_tick = self._restarts = 0
        self._ticked = self._heard = time.monotonic()
        self._greatest = np.zeros(len(Sample._fields))

    def damp(self, reason: str) -> None:
        """Let the motors brake until rearm()."""
        if self._phase == "standing":
            self._phase, self._reason = "damping", reason

    def rearm(self) -> None:
        """Stand again, if the robot speaks; the pose is latched anew."""
        if self._link.age < STALE:
            self.controller.reset()
            self._safety.reset()
            self._command, self._restarts = self._damping, self._link.counts.restarts
            self._phase, self._reason = "standing", ""

    def tick(self) -> None:
        """Receive, control, send."""
        now, new = time.monotonic(), self._link.receive()
        if now - self._ticked > AWAY:
            self.damp(f"this program stood still for {1000.0 * (now - self._ticked):.0f} ms")
        self._ticked = now
        if self._phase == "waiting" and self._link.known:
            self.rearm()
        if self._phase == "damping" and new and self._was_held_up(now):
            self._phase, self._reason = "standing", ""
        if self._phase == "standing":
            self._stand(new, now)
        self._link.send(self._command if self._phase == "standing" else self._damping)

    def report(self) -> Report:
        """Return how it is, and begin anew with the greatest numbers."""
        greatest, self._greatest = self._greatest, np.zeros(len(Sample._fields))
        known, controller = self._link.known, self.controller
        unheard = self._link.counts.received > 0 and not known
        return Report(
            self._phase,
            self._link.last_reject if unheard else self._reason,
            np.array(controller.state.q) if known else None,
            np.array(controller.solution.forces) if known else np.zeros((3, 4)),
            np.array(controller.state.contact, dtype=bool) if known else np.zeros(4, dtype=bool),
            Sample(*greatest.tolist()),
        )

    def _stand(self, new: bool, now: float) -> None:
        age = self._link.age
        if self._link.counts.restarts != self._restarts:
            self.damp("the robot began anew")
        elif new and age < HOLD:
            self._control(self._link.state)
            self._heard = now
        elif age > STALE:
            self.damp("stale")
        elif age > HOLD:
            self._command = self._damping

    def _was_held_up(self, now: float) -> bool:
        """Whether the silence was a simulated robot's, whose clock stood still with it."""
        ticks = (self._link.state.tick - self._robot_tick) % 2**32
        return self._reason == "stale" and now - self._heard < FORGIVEN and ticks <= 1000.0 * HOLD

    def _control(self, state: LowState) -> None:
        self._robot_tick = state.tick
        start = time.perf_counter()
        self._command = self.controller.update(state)
        elapsed = 1e6 * (time.perf_counter() - start)
        if self._level and self._safety.power_protect(self._command, state, self._level) < 0:
            self.damp(f"power protection: {self._safety.power:.0f} W")
        if self.controller.status == Status.DAMPING:
            self.damp(f"the controller found {self.controller.fault.name}")
        if WirelessRemote.from_bytes(bytes(state.wirelessRemote)).pressed(Button.B):
            self.damp("button B")
        tau = np.array([state.motorState[i].tauEst for i in range(_MOTORS)])
        ratio, power = torque_ratio(tau, self._tau_max), self.controller.power
        row = Sample(*pose_errors(self.controller), ratio, power, elapsed)
        self._greatest = np.maximum(self._greatest, row)
