"""surefoot walk: simulates a walking robot and writes the results."""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import TYPE_CHECKING

from surefoot._core import Error
from surefoot.cli.gait_argument import read_gait
from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import check_json_path, check_report_folder
from surefoot.cli.progress import progress_bar
from surefoot.cli.simulation_arguments import parse_numbers, read_simulation
from surefoot.cli.simulation_output import write_outputs

if TYPE_CHECKING:
    from surefoot.sim import Terrain
    from surefoot.walk import WalkSettings

REPORT_MODULE = "surefoot.walk.report"


def walk(arguments: argparse.Namespace) -> int:
    """Simulate the robot, print a summary and write the requested files.

    Returns:
        Exit status: 0 if the robot did not fall, 3 if it fell.

    Raises:
        Error: A wrong argument.
    """
    choose_graphics(pictures=arguments.report is not None)
    try:
        from surefoot.walk import run_walk, summarise
        from surefoot.walk.summary_text import summary_text
    except ModuleNotFoundError as problem:
        raise missing_module("walk", problem) from None
    settings = read_settings(arguments)
    check_json_path(arguments.json)
    check_report_folder(arguments.report, "walk", REPORT_MODULE)
    progress = progress_bar()
    log = run_walk(settings, progress)
    return write_outputs(arguments, log, summarise(log), summary_text, REPORT_MODULE, progress)


def read_settings(arguments: argparse.Namespace) -> WalkSettings:
    """Return the settings that the arguments give; raise Error if an argument is wrong."""
    from surefoot.walk import WalkSettings, parse_velocity

    if arguments.slope_heading is not None:
        if ":" in arguments.slope:
            raise Error(
                f"--slope-heading: got {arguments.slope_heading:g} and --slope {arguments.slope}, "
                "expected one direction of ascent"
            )
        arguments.slope = f"{arguments.slope}:{arguments.slope_heading}"
    simulation = read_simulation(arguments)
    simulation["plant"] = replace(
        simulation["plant"],
        walking_sensors=True,
        soft_soles=not arguments.rigid_soles,
        leg_collisions=True,
        terrain=read_terrain(arguments),
    )
    velocities = tuple(parse_velocity(text) for text in arguments.velocity)
    return WalkSettings(
        **simulation,
        velocities=velocities,
        gait=read_gait("--gait", arguments.gait),
        lost_frames=arguments.lost_frames,
    )


def read_terrain(arguments: argparse.Namespace) -> Terrain:
    """Return the terrain that --step, --stairs and --blocks give; raise Error if one is wrong."""
    from surefoot.sim import Terrain

    step, heading = parse_numbers("--step", arguments.step, "HEIGHT[:HEADING]", (1, 2), 2)
    stairs, tread = 0.0, Terrain().stairs_tread
    if arguments.stairs != "0":
        stairs, tread = parse_numbers("--stairs", arguments.stairs, "HEIGHT:TREAD", (2,), 2)
    terrain = Terrain(
        step_height=step,
        step_heading_deg=heading,
        stairs_height=stairs,
        stairs_tread=tread,
        block_height=arguments.blocks,
    )
    return terrain if terrain.is_flat else replace(terrain, seed=arguments.seed)
