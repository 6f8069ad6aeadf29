"""What a virtual robot can be asked to be, checked when it is asked."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot import protocol
from surefoot._core import Error
from surefoot.robot.loading import RobotDescription
from surefoot.robot.setting_checks import check_number, check_one_of
from surefoot.sim.settings import PlantSettings
from surefoot.stand.settings import check_rate
from surefoot.virtual_robot.joint_shaking import Shake
from surefoot.virtual_robot.remote import RemoteEvent


@dataclass(frozen=True)
class VirtualRobotSettings:
    """The robot, its link and what happens to it. Times are simulated, since the start [s].

    Attributes:
        robot: A name of surefoot.available_robots(), or a RobotDescription.
        sdk: Generation of the frames, of protocol.GENERATIONS; None takes the robot's own.
        rate: LowStates per second [Hz]; the period is a whole number of milliseconds.
        hung: The base is fixed in the air, the legs are free.
        lying: It lies with its legs anyhow, motors braking; neither hung nor lying it stands.
        drop: Datagrams lost each way [%].
        delay: Of every datagram, each way [s].
        jitter: Further delay each way, uniform from 0 to this [s]; no datagram overtakes another.
        timeout: Without a valid command for so long the motors damp [s]; 0 lets them go on.
        shakes: Hands that shake joints.
        remote: What is done to the wireless remote.
        log_rate: Rows of the log per second [Hz]; 0 keeps none.
        seed: Of every random number.
    """

    robot: str | RobotDescription = "go1"
    sdk: str | None = None
    rate: float = 1000.0
    hung: bool = False
    lying: bool = False
    drop: float = 0.0
    delay: float = 0.0
    jitter: float = 0.0
    timeout: float = 0.1
    shakes: tuple[Shake, ...] = ()
    remote: tuple[RemoteEvent, ...] = ()
    log_rate: float = 0.0
    seed: int = 1

    def __post_init__(self) -> None:
        if self.sdk is not None:
            check_one_of("sdk", self.sdk, protocol.GENERATIONS)
        check_number("rate", self.rate, 10.0, 1000.0)
        check_rate(self.rate)
        if self.hung and self.lying:
            raise Error("lying: got True, expected False for a hung robot")
        check_number("drop", self.drop, 0.0, 100.0)
        check_number("delay", self.delay, 0.0, 10.0)
        check_number("jitter", self.jitter, 0.0, 10.0)
        check_number("timeout", self.timeout, 0.0, 1e6)
        check_number("log_rate", self.log_rate, 0.0, self.rate)
        self.plant_settings(has_force_estimate=False)  # it checks what is left

    @property
    def pose(self) -> str:
        """How the robot is at the start, in words."""
        return "hung up" if self.hung else "lying" if self.lying else "standing"

    @property
    def generation(self) -> str:
        """Generation of the frames, the default resolved; raises Error where there is none."""
        if self.sdk is not None:
            return self.sdk
        name = self.robot if isinstance(self.robot, str) else str(self.robot.table["robot"]["name"])
        try:
            return protocol.default_generation(name)
        except Error as problem:
            raise Error(f"sdk: {problem}") from None

    def plant_settings(self, has_force_estimate: bool) -> PlantSettings:
        """Return the settings of the plant; `has_force_estimate`: does footForceEst carry newtons?"""
        return PlantSettings(
            foot_force="est" if has_force_estimate else "raw",
            control_rate=self.rate,
            hung=self.hung,
            seed=self.seed,
        )
