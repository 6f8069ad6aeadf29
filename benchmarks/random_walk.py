"""Random ground, commands and pushes of an episode of walk_endurance.py, drawn from its seed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from surefoot import Gains, Gait, WalkVelocity
from surefoot.robot.loading import build_robot, describe_robot
from surefoot.sim import Plant, PlantSettings, Push, Terrain
from surefoot.sim.terrain import BLOCKS_LENGTH, FIRST_EDGE

GROUNDS = "level", "slope", "blocks", "step", "soft"
PERIOD = 0.002  # [s] control period
STAND_TIME = 3.0  # [s] the robot stands before the first command
COMMAND_TIME = 2.0, 6.0  # [s] range of the time between two commands
PUSH_TIME = 3.0, 6.0  # [s] range of the time between two pushes
PUSH_SHARE = 0.1, 0.5  # range of an impulse as a share of the LIP push limit of the standing robot
PUSH_DURATION = 0.1  # [s]
FRICTION = 0.5, 0.8  # range of the friction coefficient
MAX_PAYLOAD_SHARE = 0.2  # largest payload as a share of the robot's mass
MAX_SLOPE, BLOCK_HEIGHT, STEP_HEIGHT, MAX_SINK = 10.0, 0.03, 0.05, 0.01  # [deg], [m], [m], [m]
# [sqrt(g h)] Largest speed on all grounds but the level one: 0.5 m/s on a go1. h is the height of
# the base.
ROUGH_SPEED = 0.3
# Share of the velocity limits: on a go1 1.5 m/s forward, 0.6 m/s to the side and 2 rad/s.
SPEED_SHARE = 0.7
STOP_SHARE, GAIT_SHARE = 0.15, 0.3  # share of commands with velocity 0, and with another gait
# [m] Distance from the middle of blocks or of a step from which on the robot walks back to it.
MAX_DISTANCE = 2.0
TURN_GAIN = 1.5  # [1/s] yaw rate per angle towards the middle


@dataclass(frozen=True)
class Command:
    """A command: velocity and gait from a time on.

    Attributes:
        time: Time [s].
        velocity: Velocity.
        gait: Gait.
    """

    time: float
    velocity: WalkVelocity
    gait: Gait


class RandomWalk:
    """Commands and pushes of an episode.

    Args:
        plant: Plant with a standing robot, for its size and its LIP push limits.
        ground: One of GROUNDS.
        duration: Time of the episode [s].
        rng: Random numbers.

    Attributes:
        commands: Commands in order of time.
        pushes: Pushes in order of time.
    """

    def __init__(
        self, plant: Plant, ground: str, duration: float, rng: np.random.Generator
    ) -> None:
        self._plant = plant
        self._returns = ground in ("blocks", "step")
        height = float(plant.data.qpos[2])
        self._limits = _velocity_limits(plant.robot.config.gains, height, ground == "level")
        self.commands = self._draw_commands(duration, rng)
        self.pushes = self._draw_pushes(duration, rng)

    def velocity(self, command: Command) -> WalkVelocity:
        """Return the velocity of a command, or one towards the terrain if that is far away."""
        x, y = (float(value) for value in self._plant.data.qpos[:2])
        to_x, to_y = FIRST_EDGE + 0.5 * BLOCKS_LENGTH - x, -y
        if not self._returns or math.hypot(to_x, to_y) < MAX_DISTANCE:
            return command.velocity
        R = self._plant.data.xmat[self._plant.handles.root]
        bearing = math.atan2(to_y, to_x) - math.atan2(R[3], R[0])
        bearing = math.remainder(bearing, 2.0 * math.pi)
        forward, turn = self._limits[1][0], self._limits[1][2]
        speed = forward * max(0.0, math.cos(bearing))
        return WalkVelocity(speed, 0.0, min(max(TURN_GAIN * bearing, -turn), turn))

    def _draw_commands(self, duration: float, rng: np.random.Generator) -> list[Command]:
        commands, time, gait = [], STAND_TIME, Gait.AUTO
        while time < duration:
            vx, vy, yaw_rate = rng.uniform(*self._limits)
            stops = bool(rng.uniform() < STOP_SHARE)
            velocity = WalkVelocity() if stops else WalkVelocity(vx, vy, yaw_rate)
            if rng.uniform() < GAIT_SHARE:
                gait = (Gait.AUTO, Gait.TROT, Gait.WALK)[int(rng.integers(3))]
            commands.append(Command(time, velocity, gait))
            time += float(rng.uniform(*COMMAND_TIME))
        return commands

    def _draw_pushes(self, duration: float, rng: np.random.Generator) -> list[Push]:
        pushes, time = [], STAND_TIME + float(rng.uniform(*PUSH_TIME))
        while time < duration - PUSH_TIME[0]:
            degrees = float(rng.uniform(-180.0, 180.0))
            limit = self._plant.lip_push_limit(degrees, PUSH_DURATION)
            impulse = float(rng.uniform(*PUSH_SHARE)) * limit
            pushes.append(Push(degrees, impulse, PUSH_DURATION, time))
            time += float(rng.uniform(*PUSH_TIME))
        return pushes


def random_ground(robot: str, seed: int, rng: np.random.Generator) -> tuple[str, PlantSettings]:
    """Draw the ground, the payload and the foot force sensors of an episode.

    Returns:
        One of GROUNDS, and the settings of the plant.
    """
    ground = str(rng.choice(GROUNDS))
    kinds: dict[str, dict[str, Any]] = {
        "level": {},
        "slope": {
            "slope_deg": float(rng.uniform(0.0, MAX_SLOPE)),
            "slope_heading_deg": float(rng.uniform(-180.0, 180.0)),
        },
        "blocks": {"terrain": Terrain(block_height=BLOCK_HEIGHT, seed=seed)},
        "step": {"terrain": Terrain(step_height=STEP_HEIGHT, seed=seed)},
        "soft": {"soft_ground_sink": float(rng.uniform(0.1, 1.0)) * MAX_SINK},
    }
    mass = build_robot(describe_robot(robot)).mass
    x, y = (0.03 * rng.uniform(-1.0, 1.0, 2)).tolist()
    return ground, PlantSettings(
        seed=seed,
        physics_dt=0.001,
        walking_sensors=True,
        soft_soles=True,
        leg_collisions=True,
        foot_force=str(rng.choice(["est", "raw", "dead"])),
        friction=float(rng.uniform(*FRICTION)),
        payload_kg=float(MAX_PAYLOAD_SHARE * mass * rng.uniform()),
        payload_position=(x, y, 0.05),
        **kinds[ground],
    )


def _velocity_limits(gains: Gains, height: float, level: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return the smallest and the largest velocity (3,) [m/s, m/s, rad/s] of the commands."""
    time = math.sqrt(height / 9.81)
    speeds = np.array(
        [gains.walk_speed_backward, gains.walk_speed_forward, gains.walk_speed_sideways]
    )
    backward, forward, sideways = (
        np.minimum(SPEED_SHARE * speeds, np.inf if level else ROUGH_SPEED) * height / time
    )
    turn = SPEED_SHARE * gains.walk_turn_speed / time
    return np.array([-backward, -sideways, -turn]), np.array([forward, sideways, turn])
