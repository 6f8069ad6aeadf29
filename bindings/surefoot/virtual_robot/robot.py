"""The virtual robot: what happens in each of its cycles."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from surefoot import protocol
from surefoot._core import Error, FrameExtras, LowState
from surefoot.robots import describe_robot
from surefoot.sim import Plant
from surefoot.sim.motors import command_law, damping_law
from surefoot.sim.truth import FALLEN_TILT_COS, has_fallen
from surefoot.sim.wire import Command, measured_power
from surefoot.virtual_robot.link import Link
from surefoot.virtual_robot.port import Port
from surefoot.virtual_robot.remote import Remote
from surefoot.virtual_robot.settings import VirtualRobotSettings
from surefoot.virtual_robot.shaking import Hands
from surefoot.virtual_robot.watchdog import Watchdog

_FALL_PERIOD = 0.02  # [s] between looks whether it fell
_LYING_STREAM = 12  # of random numbers; the plant has 0 .. 3, the link 10 and 11


class VirtualRobot:
    """A robot in MuJoCo behind a port. It knows simulated time only; cycle() moves it on.

    Until the first valid command the motors hold the standing pose in position mode; those of a
    robot that lies brake.

    Args:
        settings: What it is asked to be.
        port: Where datagrams come from and go to.
        say: Called with a line about what just happened; None is not interested.

    Raises:
        Error: An unknown robot, a missing file; frames that nobody named.

    Attributes:
        settings: The settings.
        plant: The simulated robot; read it, do not write it.
        link: Its end of the wire, with its counts.
        watchdog: When commands were missing.
        remote: The wireless remote.
        state: The latest report.
        command: The latest valid command as the motors got it; None before the first.
        power: Sum of |tauEst dq| in the latest report [W].
        fell_at: When it fell [s], or None; for one that began lying, when it rolled over.
    """

    def __init__(
        self,
        settings: VirtualRobotSettings,
        port: Port,
        say: Callable[[str], None] | None = None,
    ) -> None:
        self.settings = settings
        self._generation = settings.generation
        description = (
            describe_robot(settings.robot) if isinstance(settings.robot, str) else settings.robot
        )
        alive = description.table.get("simulation", {}).get("foot_force_est", False)
        self.plant = Plant(description, settings.plant_settings(alive))
        if settings.lying:
            self.plant.reset_lying(np.random.default_rng([settings.seed, _LYING_STREAM]))
        self.link = Link(port, settings)
        self.watchdog = Watchdog(settings.timeout)
        self.remote = Remote(settings.remote)
        self._hands = Hands(settings.shakes)
        self._extras = _battery_extras()
        self._say = say or (lambda line: None)
        self._period = 1.0 / settings.rate
        self._cycles = 0
        self._fall_cycles = max(1, round(_FALL_PERIOD / self._period))
        self.command: Command | None = None
        self.fell_at: float | None = None
        self.state = self.plant.read()
        self.power = measured_power(self.state)

    @property
    def time(self) -> float:
        """Simulated time since the start [s]."""
        return self._cycles * self._period

    @property
    def height(self) -> float:
        """Height of the base above the ground [m]."""
        return float(self.plant.data.qpos[2])

    @property
    def tilt(self) -> float:
        """Angle between the base's z axis and the vertical [rad]."""
        upright = float(self.plant.data.xmat[self.plant.handles.root, 8])
        return math.acos(max(-1.0, min(1.0, upright)))

    def cycle(self) -> None:
        """Listen, move for one period, report."""
        self._listen()
        self.plant.pull(self._hands.torque(self.time))
        self.plant.advance()
        self._cycles += 1
        self._report()
        if self._cycles % self._fall_cycles == 0:
            self._look_for_fall()

    def _listen(self) -> None:
        time = self.time
        cmd = self.link.receive(time)
        if cmd is not None:
            self.command = self.plant.read_command(cmd)
            self.plant.obey(command_law(self.command))
            if not self.watchdog.heard:
                self._say(f"{time:.3f} s: first valid command")
            if self.watchdog.feed(time):
                self._say(f"{time:.3f} s: commands are back, motors obey")
        elif self.watchdog.expires(time):
            self.plant.obey(damping_law())
            milliseconds = 1000.0 * self.settings.timeout
            self._say(f"{time:.3f} s: no valid command for {milliseconds:g} ms, motors damp")

    def _report(self) -> None:
        time = self.time
        self.remote.advance(time)
        self.state = self._read()
        self.power = measured_power(self.state)
        if self.link.peer is None:
            return
        try:
            frame = protocol.encode_low_state(self.state, self._generation, self._extras)
        except Error:  # physics that has lost its numbers has nothing to say
            self.link.unsent += 1
            return
        self.link.send(frame, time)

    def _read(self) -> LowState:
        state = self.plant.read()
        if self.remote.bytes is not None:
            state.wirelessRemote[:] = memoryview(self.remote.bytes)
        return state

    def _look_for_fall(self) -> None:
        if self.fell_at is None and self._is_down():
            self.fell_at = self.time
            self._say(f"{self.time:.3f} s: the robot fell")

    def _is_down(self) -> bool:
        if self.settings.lying:  # it touches the ground as it gets up and as it sits down
            return math.cos(self.tilt) < FALLEN_TILT_COS
        return has_fallen(self.plant.data, self.plant.handles)


def _battery_extras() -> FrameExtras:
    """Return the sensors that a B1's battery has beyond the LowState's own."""
    extras = FrameExtras()
    extras.BQ_NTC[:], extras.MCU_NTC[:] = 30, 32
    extras.cell_vol[:4] = 3850
    return extras
