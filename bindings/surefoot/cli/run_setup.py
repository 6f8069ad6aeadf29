"""Robot, gains and options of surefoot run, read from its arguments and checked."""

from __future__ import annotations

import argparse
import math
from dataclasses import dataclass

from surefoot._core import (
    ControllerOptions,
    DdsLink,
    Error,
    Gains,
    Robot,
    Runner,
    RunOptions,
    Start,
)
from surefoot.cli.dds_options import DDS_ROBOTS, default_robot
from surefoot.cli.robot_choice import chosen_robot
from surefoot.cli.run_checks import check_dds_robot
from surefoot.cli.run_log import LOG_TIME
from surefoot.cli.simulation_arguments import read_form, read_gains
from surefoot.protocol import default_generation
from surefoot.robot.loading import build_robot

DEFAULT_HOST, DEFAULT_PORT = "127.0.0.1", 8007


@dataclass(frozen=True)
class RunSetup:
    """Everything that a Runner needs except its link.

    Attributes:
        robot: Model and configuration.
        generation: Generation of the frames over UDP, or one of DDS_ROBOTS.
        gains: Gains of the controller.
        stand: Options of the controller.
        options: Options of the loop.
        real_robot: Whether the link may lead to a real robot.
    """

    robot: Robot
    generation: str
    gains: Gains
    stand: ControllerOptions
    options: RunOptions
    real_robot: bool

    def check(self) -> None:
        """Raise Error if a Runner would refuse the robot, a gain or an option.

        The check makes a Runner with a UDP link to this machine. The link sends nothing, because
        the Runner never runs.
        """
        Runner(
            self.robot,
            gains=self.gains,
            stand=self.stand,
            options=self.options,
            real_robot=self.real_robot,
        )

    def udp_runner(self, host: str, port: int, local_port: int) -> Runner:
        """Return a Runner over UDP."""
        return Runner(
            self.robot,
            host,
            port,
            self.generation,
            local_port,
            self.gains,
            self.stand,
            self.options,
            self.real_robot,
        )

    def dds_runner(self, link: DdsLink) -> Runner:
        """Return a Runner over an open DDS link."""
        return Runner(self.robot, link, self.gains, self.stand, self.options)


def read_setup(arguments: argparse.Namespace) -> RunSetup:
    """Return the setup that the arguments give; raise Error if an argument is wrong."""
    description = chosen_robot(arguments, default=default_robot(arguments.sdk))
    assert description is not None  # not None, because a default robot is given
    if arguments.sdk in DDS_ROBOTS:
        name = str(description.table["robot"]["name"])
        check_dds_robot(name, arguments.sdk, arguments.real_robot)
    robot = build_robot(description)
    if not 0.0 <= arguments.predict_ms <= 50.0:
        raise Error(f"--predict-ms: got {arguments.predict_ms:g}, expected 0 .. 50 [ms]")
    stand = ControllerOptions(
        motor_damping=arguments.motor_damping,
        delay=arguments.predict_ms / 1000.0,
        form=read_form(arguments.form),
    )
    if arguments.power_limit is not None:
        stand.power_limit = arguments.power_limit
    return RunSetup(
        robot=robot,
        generation=arguments.sdk or default_generation(robot.name),
        gains=read_gains(arguments.gains, description) or robot.config.gains,
        stand=stand,
        options=_run_options(arguments),
        real_robot=arguments.real_robot,
    )


def _run_options(arguments: argparse.Namespace) -> RunOptions:
    return RunOptions(
        rate=arguments.rate,
        duration=math.inf if arguments.duration is None else arguments.duration,
        power_level=arguments.power_level,
        remote=not arguments.no_remote,
        start=Start.LYING if arguments.rise else Start.STANDING,
        operator_timeout=arguments.operator_timeout,
        log_time=0.0 if arguments.log is None else arguments.log_time or LOG_TIME,
    )
