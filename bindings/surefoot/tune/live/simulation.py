"""A simulated robot under a controller whose gains, world and reference change as it stands."""

from __future__ import annotations

from time import thread_time

import numpy as np

from surefoot._core import Gains, LowState, StandController, StandOptions, is_usable
from surefoot.geometry.rotations import Array
from surefoot.robot.description import RobotDescription
from surefoot.sim import Plant, Push
from surefoot.tune.live.controller_metrics import body_reference, pose_errors, torque_ratio
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.gain_limiter import GainLimiter
from surefoot.tune.live.metric_curves import Curves, TickMetrics
from surefoot.tune.live.push_score import PushScore
from surefoot.tune.live.scene_state import SceneState
from surefoot.tune.live.world import World

PUSH_DURATION = 0.1  # [s]


class Simulation:
    """A Session on a plant, which can be pushed and put into another world.

    Args:
        description: The robot's files.
        gains: To begin with; None for the robot's own.
        world: To begin in.

    Attributes:
        world: The present world.
        requested_world: What apply_requested_world() will make of it; from any thread.
        controller: The controller, for looking.
        score: Of the last push.
        plant: The plant, for looking.
        ticks: Control periods since the beginning, over all stands.

    Raises:
        Error: A robot that cannot be built or does not stand, gains out of range.
    """

    def __init__(
        self, description: RobotDescription, gains: Gains | None = None, world: World | None = None
    ) -> None:
        self.description, self.world = description, world or World()
        self.requested_world = self.world
        self._reference: dict[str, float] = {}
        self.gain_limiter: GainLimiter | None = None
        self.curves = Curves()
        self.ticks = 0
        plant = Plant(description, self.world.plant_settings())
        self.robot = plant.robot
        self.editor = GainEditor(self.robot.config.gains, gains)
        self.period = 1.0 / self.world.plant_settings().control_rate
        # What changes with every stand; _start_stand() sets it.
        self.plant: Plant
        self.score: PushScore
        self._state: LowState
        self._version: int
        self._tau_max: Array
        self._start_stand(plant, plant.reset())

    @property
    def status(self) -> str:
        """How the robot is, in a few words."""
        if self.scene_state.fell:
            return "fallen: Reset stands it up"
        reach = self.controller.reach
        limit = "" if reach.limit.name == "NONE" else f", reach limited: {reach.limit.name.lower()}"
        return f"{self.controller.status.name.lower()}{limit}"

    @property
    def healthy(self) -> bool:
        """Whether the robot stands and its controller has it under control."""
        return is_usable(self.controller.status) and not self.scene_state.fell

    def tick(self) -> None:
        """Advance one control period: LowState to LowCmd to plant."""
        if self.editor.version != self._version:
            self._version = self.editor.version
            self.controller.set_gains(self.editor.gains)
        start = thread_time()  # not the time in which this thread has to wait for others
        command = self.controller.update(self._state)
        elapsed = 1e6 * (thread_time() - start)
        self._state = self.plant.step(command)
        self.score.record()
        self.ticks += 1
        ratio = torque_ratio(self.plant.motors.torque, self._tau_max)
        sample = TickMetrics(
            *pose_errors(self.controller), ratio, self.controller.command_power, elapsed
        )
        self.curves.add(self.ticks * self.period, sample)

    def update_view(self) -> None:
        """Bring `scene_state` up to date."""
        truth, plant = self.plant.truth, self.plant
        normal = plant.handles.ground_normal
        force, point = plant.push_force
        self.scene_state = SceneState(
            qpos=plant.data.qpos.copy(),
            contact_points=truth.p_world_feet.T - self.robot.config.foot_radius * normal,
            forces=truth.foot_forces.T,
            contact=truth.contact,
            com=truth.com,
            ground=plant.model.geom_quat[plant.handles.ground_geom],
            fell=truth.fell,
            payload_kg=self.world.payload_kg,
            push=(force.copy(), point.copy()) if np.any(force) else None,
        )

    def push(self, degrees: float, percent: float) -> float:
        """Push the robot now, through its centre of mass, for 0.1 s.

        Args:
            degrees: From forward towards left [deg].
            percent: Of what the linear inverted pendulum survives in that direction.

        Returns:
            The impulse [N.s].
        """
        impulse = percent / 100.0 * self.plant.lip_push_limit(degrees, PUSH_DURATION)
        self.plant.add_push(Push(degrees, impulse, PUSH_DURATION, self.plant.time))
        self.score.begin()
        return impulse

    def set_reference(self, values: dict[str, float]) -> None:
        """Ask for another pose of the body, by axis; m and deg."""
        self._reference = dict(values)
        self.controller.set_body_reference(body_reference(values))

    def reset(self) -> None:
        """Stand the robot up anew in its world, with the gains and the reference it has."""
        self.set_world(self.world)

    def set_world(self, world: World) -> None:
        """Stand the robot up in another world; raises Error and stays in the old one."""
        plant = Plant(self.description, world.plant_settings())
        self.world = world
        self._start_stand(plant, plant.reset())

    def apply_requested_world(self) -> None:
        """Stand the robot up in requested_world, unless it is there; a slider asks for many."""
        if self.requested_world != self.world:
            self.set_world(self.requested_world)

    def close(self) -> None:
        """Nothing is to let go of."""

    def _start_stand(self, plant: Plant, state: LowState) -> None:
        options = StandOptions(delay=self.world.predicted_ms / 1000.0)
        self.controller = StandController(plant.robot, self.editor.gains, options)
        self.controller.set_body_reference(body_reference(self._reference))
        self.plant = plant
        self._state = state
        self._version = self.editor.version
        self._tau_max = np.array(plant.robot.config.tau_max)
        self.score = PushScore(plant)
        self.update_view()
