"""Virtual robot: in each cycle, it receives a command, simulates one period and sends a sample."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from surefoot._core import LowState
from surefoot.robot.loading import describe_robot
from surefoot.sim import Plant
from surefoot.sim.hardware.motors import command_law, damping_law
from surefoot.sim.hardware.wire_format import MotorCommands, measured_power
from surefoot.sim.truth import FALLEN_TILT_COS, has_fallen
from surefoot.virtual_robot.dds_robot_link import DdsRobotLink
from surefoot.virtual_robot.joint_shaker import JointShaker
from surefoot.virtual_robot.remote import Remote
from surefoot.virtual_robot.robot_link import RobotLink
from surefoot.virtual_robot.settings import VirtualRobotSettings
from surefoot.virtual_robot.udp_port import DatagramPort
from surefoot.virtual_robot.watchdog import Watchdog

# [s] Time between two checks for a fall. Chosen: shorter than a fall, which lasts some tenths of a
# second. With a smaller value, the checks would cost more time.
_FALL_CHECK_PERIOD = 0.02
_LYING_RNG_STREAM = 12  # random stream of the lying pose; the plant uses 0 .. 3, the link 10, 11


class VirtualRobot:
    """Simulated robot that receives LowCmds and sends LowStates through a port.

    The robot has only simulated time; each call of cycle() simulates one period. Before the first
    valid command, the motors of a standing robot hold the standing pose in position mode. The
    motors of a lying robot damp.

    Args:
        settings: Settings of the robot and its link.
        port: Port that receives and sends datagrams, or a link over DDS.
        on_message: Function that receives a line of text about each event; None: no messages.

    Raises:
        Error: The robot is unknown, a file is missing, or settings.sdk is None and the robot has no
            default frame generation.

    Attributes:
        settings: The settings.
        plant: The simulated robot; read-only for callers.
        link: Robot's end of the link, with the counts of datagrams.
        watchdog: Watchdog that detects missing commands.
        remote: The wireless remote.
        state: Latest LowState.
        command: Latest valid command as the motors received it; None before the first command.
        power: Sum over the motors of the absolute product tauEst dq in the latest LowState [W].
        fell_at: Time of the fall [s]; None: no fall. A fall is what sim.truth.has_fallen()
            detects. If the run began with a lying robot, only its tilt counts, because its body may
            touch the ground.
    """

    def __init__(
        self,
        settings: VirtualRobotSettings,
        port: DatagramPort | DdsRobotLink,
        on_message: Callable[[str], None] | None = None,
    ) -> None:
        self.settings = settings
        description = (
            describe_robot(settings.robot) if isinstance(settings.robot, str) else settings.robot
        )
        has_force_estimate = description.table.get("simulation", {}).get("foot_force_est", False)
        self.plant = Plant(description, settings.plant_settings(has_force_estimate))
        if settings.lying:
            self.plant.reset_lying(np.random.default_rng([settings.seed, _LYING_RNG_STREAM]))
        self.link = port if isinstance(port, DdsRobotLink) else RobotLink(port, settings)
        self.watchdog = Watchdog(settings.timeout)
        self.remote = Remote(settings.remote)
        self._shaker = JointShaker(settings.shakes)
        self._on_message = on_message or (lambda line: None)
        self._period = 1.0 / settings.rate
        self._cycles = 0
        self._fall_check_cycles = max(1, round(_FALL_CHECK_PERIOD / self._period))
        self.command: MotorCommands | None = None
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
        cos_tilt = float(self.plant.data.xmat[self.plant.handles.root, 8])
        return math.acos(max(-1.0, min(1.0, cos_tilt)))

    def cycle(self) -> None:
        """Receive a command, simulate one period and send a sample."""
        self._receive_command()
        self.plant.apply_joint_torque(self._shaker.torque(self.time))
        self.plant.advance()
        self._cycles += 1
        self._send_sample()
        if self._cycles % self._fall_check_cycles == 0:
            self._check_fall()

    def _receive_command(self) -> None:
        time = self.time
        cmd = self.link.receive(time)
        for line in self.link.take_news():
            self._on_message(f"{time:.3f} s: {line}")
        if cmd is not None:
            self.command = self.plant.read_command(cmd)
            self.plant.apply_law(command_law(self.command))
            if not self.watchdog.received_any:
                self._on_message(f"{time:.3f} s: first valid command")
            if self.watchdog.feed(time):
                self._on_message(f"{time:.3f} s: commands are back, motors follow them")
        elif self.watchdog.check_timeout(time):
            self.plant.apply_law(damping_law())
            milliseconds = 1000.0 * self.settings.timeout
            self._on_message(f"{time:.3f} s: no valid command for {milliseconds:g} ms, motors damp")

    def _send_sample(self) -> None:
        time = self.time
        self.remote.advance(time)
        self.state = self._read()
        self.power = measured_power(self.state)
        self.link.send_state(self.state, time)

    def _read(self) -> LowState:
        state = self.plant.read()
        if self.remote.bytes is not None:
            state.wirelessRemote[:] = memoryview(self.remote.bytes)
        return state

    def _check_fall(self) -> None:
        if self.fell_at is None and self._has_fallen():
            self.fell_at = self.time
            self._on_message(f"{self.time:.3f} s: the robot fell")

    def _has_fallen(self) -> bool:
        if self.settings.lying:  # the body touches the ground when the robot rises and sits down
            return math.cos(self.tilt) < FALLEN_TILT_COS
        return has_fallen(self.plant.data, self.plant.handles)
