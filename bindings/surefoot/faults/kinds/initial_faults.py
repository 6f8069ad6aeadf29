"""Faults that begin before arming: wrong wiring, robot model, surroundings, payload or pose."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from surefoot._core import LowCmd, LowState, Robot, SupervisorOptions
from surefoot.faults.kinds.fault import CombinedFault, Fault
from surefoot.faults.kinds.signal_faults import constant
from surefoot.faults.kinds.signals import AttitudeFault, SignalFault, signal_view
from surefoot.geometry.rotations import Array
from surefoot.robot.loading import load_robot
from surefoot.sim import Plant, PlantSettings

# Names of wrong models, by the name of the true robot: the robot of the most similar size, and a
# robot of a very different size.
SIMILAR_ROBOT = {"a1": "go1", "go1": "a1", "go2": "go1", "b1": "go2"}
DIFFERENT_ROBOT = {"a1": "b1", "go1": "b1", "go2": "b1", "b1": "go1"}


class WrongWiring(Fault):
    """Motors are wired in a wrong order or turn in the wrong direction, from the start.

    Args:
        order: True motor by assumed motor. Motor order[i] receives the command for motor i, and its
            measurements arrive as those of motor i. A motor without an entry is wired correctly.
        reversed_motors: Motors that turn in the wrong direction.
    """

    from_start = True

    def __init__(self, order: dict[int, int], reversed_motors: tuple[int, ...] = ()) -> None:
        self._order = np.array([order.get(i, i) for i in range(12)])
        self._reversed_motors = reversed_motors

    def change_state(self, state: LowState, k: int) -> None:
        """Change order and direction of the motors in a sample."""
        # motorState of the SDK's LowState begins at byte 75 and has 38 bytes per motor.
        motors = state.raw[75 : 75 + 12 * 38].reshape(12, 38)
        motors[:] = motors[self._order]
        for name in ("q", "dq", "tauEst"):
            signal_view(state, name)[list(self._reversed_motors)] *= -1.0

    def change_command(self, command: LowCmd, k: int) -> None:
        """Change order and direction of the motors in a command."""
        # A dq of 1e3 or more is not a velocity but the marker VelStopF (16000), so its sign stays.
        for i in self._reversed_motors:
            motor = command.motorCmd[i]
            motor.tau, motor.dq = -motor.tau, -motor.dq if abs(motor.dq) < 1e3 else motor.dq
        # motorCmd of the SDK's LowCmd begins at byte 22 and has 33 bytes per motor.
        motors = command.raw[22 : 22 + 12 * 33].reshape(12, 33)
        commanded = motors.copy()
        motors[self._order] = commanded


class WrongRobot(Fault):
    """The supervisor has the model of another robot, from the start.

    Args:
        wrong_robots: Name of the wrong model, by the name of the true robot.
    """

    from_start = True

    def __init__(self, wrong_robots: dict[str, str]) -> None:
        self._wrong_robots = wrong_robots

    def assumed_robot(self, robot: Robot) -> Robot:
        """Return the wrong model."""
        return load_robot(self._wrong_robots.get(robot.name, "go1"))


class ChangedSurroundings(Fault):
    """The surroundings differ from the model, from the start.

    Args:
        friction: Friction coefficient of the ground.
        sink: Depth by which feet sink into the ground [m]; see PlantSettings.soft_ground_sink.
        hung: True: the robot hangs in the air.
    """

    from_start = True

    def __init__(self, friction: float = 0.8, sink: float = 0.0, hung: bool = False) -> None:
        self._friction, self._sink, self._hung = friction, sink, hung

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the plant settings with the changed surroundings."""
        return replace(
            settings, friction=self._friction, soft_ground_sink=self._sink, hung=self._hung
        )

    def start(self, plant: Plant, lying_qpos: Array) -> LowState:
        """Put the robot into its lying pose, or let it hang; return the first sample."""
        return plant.reset() if self._hung else super().start(plant, lying_qpos)


class UnknownPayload(Fault):
    """The robot carries a payload that is not in its model, from the start.

    Args:
        share: Payload as a share of the robot's mass.
        x: Forward position of the payload in the base frame [m].
        limit: SupervisorOptions.payload_limit as a share of the robot's mass; 0: the option keeps
            its default.
    """

    from_start = True

    def __init__(self, share: float, x: float = 0.0, limit: float = 0.0) -> None:
        self._share, self._x, self._limit, self._mass = share, x, limit, 0.0

    def assumed_robot(self, robot: Robot) -> Robot:
        """Store the mass of the robot; return the model unchanged."""
        self._mass = robot.mass
        return robot

    def set_options(self, options: SupervisorOptions) -> None:
        """Set the payload limit."""
        if self._limit > 0.0:
            options.payload_limit = self._limit * self._mass

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the plant settings with the payload."""
        load = self._share * self._mass
        # The payload is 0.1 m above the origin of the base: on the back of a small robot.
        return replace(settings, payload_kg=load, payload_position=(self._x, 0.0, 0.1))


class StartsStanding(Fault):
    """The robot stands in position mode when the supervisor starts."""

    from_start = True

    def start(self, plant: Plant, lying_qpos: Array) -> LowState:
        """Put the robot into its standing pose; return the first sample."""
        return plant.reset()


def swapped_legs(one: int, other: int) -> dict[int, int]:
    """Return an order for WrongWiring that swaps the motors of two legs (0 .. 3, in leg order)."""
    first, second = 3 * one, 3 * other
    return {a + i: b + i for a, b in ((first, second), (second, first)) for i in range(3)}


def reported_slope() -> Fault:
    """Return a fault whose samples report a pitch of 35 degrees for a robot that lies level."""
    angle = np.radians(35.0)  # [rad] above the limit of the arming checks, 25 degrees
    return CombinedFault(
        AttitudeFault(lambda k: 35.0, 1),
        SignalFault("accelerometer", constant(-9.81 * np.sin(angle)), 0),
        SignalFault("accelerometer", constant(9.81 * np.cos(angle)), 2),
    )
