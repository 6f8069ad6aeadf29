"""One episode of walk_endurance.py: a supervised robot walks, and its figures are taken."""

from __future__ import annotations

import math
from collections import Counter, deque
from dataclasses import dataclass, field
from time import thread_time_ns

import numpy as np
import surefoot
from false_trips import fault_counts
from random_walk import PERIOD, STAND_TIME, RandomWalk, random_ground
from seed_runs import RunOutcome
from surefoot import FallbackLevel, FaultReaction, Mode, Start, SupervisorOptions
from surefoot.sim import Plant
from surefoot.walk.slip import slip_velocities

COMMAND_SETTLING, PUSH_SETTLING = 1.0, 2.0  # [s] times whose tracking error does not count
CHECK_TICKS = 10  # [ticks] interval of the checks of faults and falls
SLIP_WINDOW = 100  # [ticks] time before the fault "slip" in which a true slide is looked for
MIN_SLIDE = 0.005  # [m] path of a loaded foot along the ground in that time from which on it slid
LOADED_SHARE = 0.05  # force of a loaded foot as a share of the robot's weight
MAX_TICK_US = 10_000  # [us] largest time of a tick in the histogram


@dataclass
class Episode(RunOutcome):
    """Result of an episode; `why` has the time and the reason of a failure.

    Attributes:
        ground: Ground, friction and payload.
        seconds: Simulated time [s].
        walking_ticks: Ticks with stepping feet.
        faults: Number of times that each fault began.
        false_slips: Number of times that "slip" began without a true slide.
        not_first: Ticks whose QP was not solved at the first attempt.
        not_solved: Ticks whose QP was not solved.
        leg_contacts: Contacts between legs, or of a leg with the trunk, that began.
        tick_us: Numbers of ticks by thread CPU time [us], for "stand" and "walk".
        squares: Sums of the squared tracking errors: vx, vy [m^2/s^2], yaw rate [rad^2/s^2].
        tracked_ticks: Number of ticks in `squares`.
    """

    ground: str
    seconds: float = 0.0
    walking_ticks: int = 0
    faults: dict[str, int] = field(default_factory=dict)
    false_slips: int = 0
    not_first: int = 0
    not_solved: int = 0
    leg_contacts: int = 0
    tick_us: dict[str, dict[str, int]] = field(default_factory=dict)
    squares: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    tracked_ticks: int = 0


class EpisodeRun:
    """An episode while it runs.

    Args:
        robot: Name of the robot.
        power_level: Level of the power protection; 0: off.
        seed: Seed of all that is drawn.
        duration: Time of the episode [s].

    Attributes:
        plant: Plant of the robot.
        supervisor: Supervisor under test.
        walk: Commands and pushes.
        episode: Figures so far.
    """

    def __init__(self, robot: str, power_level: int, seed: int, duration: float) -> None:
        rng = np.random.default_rng([seed, 21])
        ground, settings = random_ground(robot, seed, rng)
        self.plant = Plant(robot, settings)
        self._state = self.plant.reset()
        options = SupervisorOptions(power_level=power_level, start=Start.STANDING)
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self.walk = RandomWalk(self.plant, ground, duration, rng)
        for push in self.walk.pushes:
            self.plant.add_push(push)
        words = f"{ground}, friction {settings.friction:.2f}, payload {settings.payload_kg:.1f} kg"
        self.episode = Episode(True, "", words)
        self._ticks = round(duration / PERIOD)
        self._times = {"stand": Counter[int](), "walk": Counter[int]()}
        self._touching: frozenset[tuple[str, str]] = frozenset()
        # [m] Path of each loaded foot along the ground, of the last ticks.
        self._slides: deque[np.ndarray] = deque(maxlen=SLIP_WINDOW)
        self._slips = 0

    def run(self) -> Episode:
        """Run until the end or the first failure; return the figures."""
        episode, supervisor = self.episode, self.supervisor
        coming, command = deque(self.walk.commands), None
        for k in range(self._ticks):
            if coming and k * PERIOD >= coming[0].time:
                command = coming.popleft()
                supervisor.gait = command.gait
            if command is not None:
                if supervisor.mode == Mode.STAND:
                    supervisor.request(Mode.WALK)
                supervisor.set_velocity(self.walk.velocity(command))
            self._update(k)
            self._track(k, 0.0 if command is None else command.time)
            if k % CHECK_TICKS == 0 and self._has_ended():
                break
        episode.seconds = round(self.plant.time, 3)
        episode.faults = {name: n for name, n in fault_counts(supervisor).items() if n}
        episode.tick_us = {
            phase: {str(us): n for us, n in sorted(counts.items())}
            for phase, counts in self._times.items()
        }
        return episode

    def _update(self, k: int) -> None:
        """Run a tick of the supervisor and of the plant."""
        start = thread_time_ns()
        command = self.supervisor.update(self._state)
        tick_us = min((thread_time_ns() - start) // 1000, MAX_TICK_US)
        episode, controller = self.episode, self.supervisor.controller
        walks = controller.walking
        if walks or 1.0 <= k * PERIOD < STAND_TIME:
            self._times["walk" if walks else "stand"][tick_us] += 1
        episode.walking_ticks += walks
        level = controller.fallback_level.value
        episode.not_first += level > FallbackLevel.SOLVED.value
        episode.not_solved += level > FallbackLevel.COLD_SOLVE.value
        self._state = self.plant.step(command)

    def _track(self, k: int, command_time: float) -> None:
        """Add contacts of legs, slides and the tracking error of this tick."""
        plant, episode = self.plant, self.episode
        episode.leg_contacts += len(plant.leg_contacts - self._touching)
        self._touching = plant.leg_contacts
        truth, normal = plant.truth, plant.handles.ground_normal
        weight = 9.81 * float(plant.model.body_subtreemass[plant.handles.root])
        loaded = truth.foot_forces.T @ normal > LOADED_SHARE * weight
        slip = slip_velocities(plant)
        along = np.linalg.norm(slip - np.outer(normal, normal @ slip), axis=0)
        self._slides.append(PERIOD * along * loaded)
        time = k * PERIOD
        begins = [push.time + PUSH_SETTLING for push in self.walk.pushes if push.time <= time]
        if time < max([command_time + COMMAND_SETTLING, *begins]) or not command_time:
            return
        R, v = plant.data.xmat[plant.handles.root], truth.com_velocity
        yaw, rate = math.atan2(R[3], R[0]), float(R[6:9] @ truth.v[3:6])
        c, s = math.cos(yaw), math.sin(yaw)
        commanded = self.supervisor.controller.commanded_velocity
        error = (
            c * v[0] + s * v[1] - commanded.vx,
            c * v[1] - s * v[0] - commanded.vy,
            rate - commanded.yaw_rate,
        )
        episode.squares = [
            total + float(e) ** 2 for total, e in zip(episode.squares, error, strict=True)
        ]
        episode.tracked_ticks += 1

    def _has_ended(self) -> bool:
        """Judge falls and faults; return True if the robot no longer walks on."""
        supervisor, plant = self.supervisor, self.plant
        counts = fault_counts(supervisor)
        if counts["slip"] > self._slips:
            slid = np.sum(self._slides, axis=0).max() >= MIN_SLIDE
            self.episode.false_slips += not slid
            self._slips = counts["slip"]
        faults = [
            info.name
            for info in surefoot.fault_table()
            if counts[info.name] and info.reaction != FaultReaction.WATCH and info.name != "slip"
        ]
        ended = supervisor.mode not in (Mode.STAND, Mode.WALK)
        if ended:
            self._fail(f"{supervisor.mode.name} for {', '.join(faults)}")
        elif plant.truth.fell:
            self._fail("fell")
        elif faults:
            self._fail(f"fault {', '.join(faults)}")
        return ended or bool(plant.truth.fell)

    def _fail(self, why: str) -> None:
        """Add a reason of failure, if it is the first one or a fall."""
        episode = self.episode
        if why not in episode.why:
            old = f"{episode.why}; " if episode.why else f"{episode.ground}; "
            episode.ok, episode.why = False, f"{old}{self.plant.time:.2f} s: {why}"
