"""Settings of a virtual robot; the constructor checks them."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot import protocol
from surefoot._core import Error
from surefoot.robot.loading import RobotDescription
from surefoot.robot.setting_checks import check_number, check_one_of
from surefoot.sim.settings import PlantSettings
from surefoot.stand.simulation_settings import check_rate
from surefoot.virtual_robot.joint_shaker import Shake
from surefoot.virtual_robot.remote import RemoteEvent

DDS_ROBOTS = ("go2", "b2")  # robots that speak DDS; names of DdsLink


@dataclass(frozen=True)
class VirtualRobotSettings:
    """Settings of a virtual robot, its link and its inputs. All times are simulated times.

    If neither `hung` nor `lying` is True, the robot starts in its standing pose.

    Attributes:
        robot: A name of surefoot.available_robots(), or a RobotDescription.
        sdk: Frame generation: version of the SDK's frame format, one of protocol.GENERATIONS, such
            as go1-v3.8; or one of DDS_ROBOTS: DDS instead of UDP; None: the default frame
            generation of this robot.
        rate: LowStates per second [Hz]; the period must be a whole number of milliseconds.
        hung: True: the base is fixed in the air, and the legs are free.
        lying: True: the robot starts lying in a random leg pose with damping motors.
        walking: True: the robot has the sensor errors, soft soles and leg collisions of a walking
            robot (PlantSettings.walking_sensors, soft_soles, leg_collisions).
        drop: Share of lost datagrams in each direction [%].
        delay: Delay of every datagram in each direction [s].
        jitter: Upper limit of an additional random delay in each direction [s]; uniform from 0.
            The order of the datagrams does not change.
        timeout: Time without a valid command after which the motors damp [s]; 0: never.
        shakes: External sine torques on joints.
        remote: Events of the wireless remote, in order of time.
        log_rate: Rows of the log per second [Hz]; 0: no log.
        seed: Seed of all random numbers.
    """

    robot: str | RobotDescription = "go1"
    sdk: str | None = None
    rate: float = 1000.0
    hung: bool = False
    lying: bool = False
    walking: bool = False
    drop: float = 0.0
    delay: float = 0.0
    jitter: float = 0.0
    # Equal to kRobotWatchdogTime: the assumed timeout in the firmware of real robots.
    timeout: float = 0.1
    shakes: tuple[Shake, ...] = ()
    remote: tuple[RemoteEvent, ...] = ()
    log_rate: float = 0.0
    seed: int = 1

    def __post_init__(self) -> None:
        if self.sdk is not None:
            check_one_of("sdk", self.sdk, (*protocol.GENERATIONS, *DDS_ROBOTS))
        check_number("rate", self.rate, 10.0, 1000.0)
        check_rate(self.rate)
        if self.hung and self.lying:
            raise Error("lying: got True, expected False for a hung robot")
        check_number("drop", self.drop, 0.0, 100.0)
        check_number("delay", self.delay, 0.0, 10.0)
        check_number("jitter", self.jitter, 0.0, 10.0)
        check_number("timeout", self.timeout, 0.0, 1e6)
        check_number("log_rate", self.log_rate, 0.0, self.rate)
        self.plant_settings(has_force_estimate=False)  # PlantSettings checks the seed

    @property
    def pose(self) -> str:
        """Initial pose of the robot as text."""
        return "hung up" if self.hung else "lying" if self.lying else "standing"

    @property
    def uses_dds(self) -> bool:
        """True if the robot speaks DDS instead of UDP."""
        return self.sdk in DDS_ROBOTS

    @property
    def generation(self) -> str:
        """Frame generation of the robot, one of protocol.GENERATIONS or DDS_ROBOTS.

        Raises:
            Error: `sdk` is None, and this robot has no default frame generation.
        """
        if self.sdk is not None:
            return self.sdk
        name = self.robot if isinstance(self.robot, str) else str(self.robot.table["robot"]["name"])
        try:
            return protocol.default_generation(name)
        except Error as problem:
            raise Error(f"sdk: {problem}") from None

    def plant_settings(self, has_force_estimate: bool) -> PlantSettings:
        """Return the settings of the plant.

        Args:
            has_force_estimate: True: the robot reports foot forces in N as footForceEst.
        """
        return PlantSettings(
            foot_force="est" if has_force_estimate else "raw",
            control_rate=self.rate,
            hung=self.hung,
            walking_sensors=self.walking,
            soft_soles=self.walking,
            leg_collisions=self.walking,
            seed=self.seed,
        )
