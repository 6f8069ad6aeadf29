"""Session on a simulated robot that stands or walks while its gains, world and commands change."""

from __future__ import annotations

from time import thread_time

import numpy as np

from surefoot._core import (
    ControllerOptions,
    Gains,
    Gait,
    LowState,
    WalkController,
    WalkOptions,
    WalkVelocity,
    is_usable,
)
from surefoot.geometry.rotations import Array
from surefoot.robot.description import RobotDescription
from surefoot.sim import Plant, Push
from surefoot.tune.live.controller_metrics import body_reference, pose_errors, torque_ratio
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.gain_limiter import GainLimiter
from surefoot.tune.live.metric_curves import Curves, TickMetrics
from surefoot.tune.live.push_score import PushScore
from surefoot.tune.live.scene_state import SceneState
from surefoot.tune.live.walk_figures import WalkFigures
from surefoot.tune.live.world import World

PUSH_DURATION = 0.1  # [s] duration of a push from the page, as in `surefoot assess`


class Simulation:
    """Session on a plant that can be pushed and placed into another world.

    Args:
        description: The robot's files.
        gains: Initial gains. None: the robot's own gains.
        world: Initial world.

    Attributes:
        world: The present world.
        requested_world: World that apply_requested_world() will use; any thread may set it.
        controller: The controller; read-only for callers.
        attended: See Session.
        velocity_version: Number of restarts, each of which sets the velocity to 0.
        score: Recorder of the last push and its cost.
        walk_figures: Figures of the present walk.
        plant: The plant; read-only for callers.
        ticks: Number of control periods since construction; a reset does not clear it.

    Raises:
        Error: The robot cannot be built or does not stand, or gains are out of range.
    """

    def __init__(
        self, description: RobotDescription, gains: Gains | None = None, world: World | None = None
    ) -> None:
        self.description, self.world = description, world or World()
        self.requested_world = self.world
        self._reference: dict[str, float] = {}
        self._velocity, self._gait = WalkVelocity(), Gait.AUTO
        self.attended, self.velocity_version = True, 0
        self.gain_limiter: GainLimiter | None = None
        self.curves = Curves()
        self.ticks = 0
        plant = Plant(description, self.world.plant_settings())
        self.robot = plant.robot
        self.editor = GainEditor(self.robot.config.gains, gains)
        self.period = 1.0 / self.world.plant_settings().control_rate
        # _start_stand() sets these attributes for each new standing run.
        self.plant: Plant
        self.score: PushScore
        self.walk_figures: WalkFigures
        self._state: LowState
        self._gains_version: int
        self._tau_max: Array
        self._start_stand(plant, plant.reset())

    @property
    def status(self) -> str:
        """Status of the robot in a few words."""
        if self.scene_state.fell:
            return "fallen: press Reset"
        reach = self.controller.reach
        limit = "" if reach.limit.name == "NONE" else f", reach limited: {reach.limit.name.lower()}"
        walking = ", walking" if self.controller.walking else ""
        return f"{self.controller.status.name.lower()}{walking}{limit}"

    @property
    def healthy(self) -> bool:
        """True if the robot has not fallen and its controller's commands are usable."""
        return is_usable(self.controller.status) and not self.scene_state.fell

    def tick(self) -> None:
        """Advance by one control period: update the controller, then the plant."""
        if self.editor.gains_version != self._gains_version:
            self._gains_version = self.editor.gains_version
            self.controller.set_gains(self.editor.gains)
        if self.attended:
            self.controller.set_velocity(self._velocity)  # in every tick: a velocity times out
        start = thread_time()  # CPU time of this thread, without waiting for other threads
        command = self.controller.update(self._state)
        elapsed = 1e6 * (thread_time() - start)
        self._state = self.plant.step(command)
        self.score.record()
        self.walk_figures.record()
        self.ticks += 1
        ratio = torque_ratio(self.plant.motors.torque, self._tau_max)
        metrics = TickMetrics(
            *pose_errors(self.controller), ratio, self.controller.command_power, elapsed
        )
        self.curves.add(self.ticks * self.period, metrics)

    def update_view(self) -> None:
        """Update `scene_state` from the true state of the plant."""
        truth, plant = self.plant.truth, self.plant
        normal = plant.handles.ground_normal
        force, point = plant.push_force
        self.scene_state = SceneState(
            qpos=plant.data.qpos.copy(),
            contact_points=truth.p_world_feet.T - plant.handles.foot_radius * normal,
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
            degrees: Direction of the push [deg]; 0: forward, 90: to the left.
            percent: Impulse in percent of the LIP push limit in that direction.

        The cost of a push is recorded only while the robot stands.

        Returns:
            The impulse [N.s].
        """
        impulse = percent / 100.0 * self.plant.lip_push_limit(degrees, PUSH_DURATION)
        self.plant.add_push(Push(degrees, impulse, PUSH_DURATION, self.plant.time))
        if self.controller.walking:
            self.score.stop()
        else:
            self.score.begin()
        return impulse

    def set_velocity(self, velocity: WalkVelocity) -> None:
        """Command a velocity; the robot walks until it is 0 or `attended` is False."""
        self._velocity = velocity
        if velocity != WalkVelocity():
            self.score.stop()  # the cost of a push is that of a stand

    def set_gait(self, gait: Gait) -> None:
        """Set the gait."""
        self._gait = self.controller.gait = gait

    def walk_text(self) -> str:
        """Return the command and the RMS errors of the walk as Markdown."""
        return self.walk_figures.text()

    def set_reference(self, values: dict[str, float]) -> None:
        """Set the body reference, by axis as in REFERENCE_RANGES [m, deg]."""
        self._reference = dict(values)
        self.controller.set_body_reference(body_reference(values))

    def reset(self) -> None:
        """Restart the robot at velocity 0, with the present world, gains, reference and gait."""
        self.set_world(self.world)

    def set_world(self, world: World) -> None:
        """Restart the robot in another world; after an Error the old world stays."""
        plant = Plant(self.description, world.plant_settings())
        self.world = world
        self._start_stand(plant, plant.reset())

    def apply_requested_world(self) -> None:
        """Restart the robot in requested_world if requested_world differs from the present world.

        A moving slider requests many worlds; only the last request is built.
        """
        if self.requested_world != self.world:
            self.set_world(self.requested_world)

    def close(self) -> None:
        """Do nothing: a simulation needs no closing."""

    def _start_stand(self, plant: Plant, state: LowState) -> None:
        options = ControllerOptions(delay=self.world.predicted_ms / 1000.0)
        self.controller = WalkController(plant.robot, self.editor.gains, WalkOptions(options))
        self.controller.gait = self._gait
        self._velocity = WalkVelocity()
        self.velocity_version += 1
        self.controller.set_body_reference(body_reference(self._reference))
        self.plant = plant
        self._state = state
        self._gains_version = self.editor.gains_version
        self._tau_max = np.array(plant.robot.config.tau_max)
        self.score = PushScore(plant)
        self.walk_figures = WalkFigures(plant, self.controller)
        self.update_view()
