# SPDX-License-Identifier: BSD-3-Clause
"""Standing with real sensors: every robot, judged by its true state."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import mujoco
import numpy as np
import pytest
import surefoot
from plant_helpers import ROBOTS
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.sim import Plant, PlantSettings, Push

pytestmark = pytest.mark.slow

MOTOR = np.dtype([("mode", "u1"), *[(n, "<f4") for n in ("q", "dq", "tau", "Kp", "Kd")]])
FORCE = ["est", "dead"]


def attitude(q):
    """Return R_world_base of Pinocchio's q."""
    return matrix_from_wxyz([q[6], *q[3:6]])


def heading(feet) -> float:
    """Return the heading from the middle of the rear feet to the middle of the front feet [rad]."""
    forward = feet[:2, 0] + feet[:2, 1] - feet[:2, 2] - feet[:2, 3]
    return math.atan2(forward[1], forward[0])


def rms(x, axis=None):
    return np.sqrt(np.mean(np.square(x), axis=axis))


@dataclass
class StandRun:
    """One run: samples, commands, estimates, and the true state just before each command."""

    plant: Plant
    controller: surefoot.StandController
    start: object = None
    reports: list[bytes] = field(default_factory=list)
    commands: list[bytes] = field(default_factory=list)
    statuses: list[surefoot.Status] = field(default_factory=list)
    estimates: list[surefoot.RobotState] = field(default_factory=list)
    truths: list = field(default_factory=list)

    def last_truths(self, seconds: float = 2.0):
        return self.truths[-round(seconds * self.plant.settings.control_rate) :]

    def offset(self, truth):
        """Return the base position from the mean of the true feet, minus its start value [m]."""
        current, initial = (t.q[:3] - t.p_world_feet.mean(axis=1) for t in (truth, self.start))
        return current - initial

    def tilt(self, truth) -> float:
        """Return the angle between the vertical in base axes and that of the start [deg]."""
        up, initial = (attitude(t.q)[2] for t in (truth, self.start))
        return math.degrees(math.acos(min(1.0, up @ initial)))

    def yaw(self, truth) -> float:
        """Return the yaw of the base minus that of the feet, since the start [deg]."""
        turn = attitude(truth.q) @ attitude(self.start.q).T
        feet = heading(truth.p_world_feet) - heading(self.start.p_world_feet)
        return math.degrees(math.atan2(turn[1, 0], turn[0, 0]) - feet)

    def foot_travel(self) -> float:
        feet = np.array([t.p_world_feet for t in self.truths])
        return np.linalg.norm(feet - self.start.p_world_feet, axis=1).max()

    def high_frequency_torque(self) -> float:
        """Return the RMS torque above 30 Hz of the worst motor, in the last 2 s [N.m]."""
        tau = np.array([t.tau for t in self.last_truths()])
        spectrum = np.fft.rfft(tau, axis=0)
        low = np.fft.rfftfreq(len(tau), 1.0 / self.plant.settings.control_rate) < 30.0
        spectrum[low] = 0.0
        return rms(np.fft.irfft(spectrum, len(tau), axis=0), axis=0).max()

    def estimate_errors(self) -> tuple[float, float]:
        """Return the RMSE of the base velocity in base axes [m/s] and of the vertical [deg]."""
        speed, lean = [], []
        for truth, state in zip(self.truths, self.estimates, strict=True):
            speed.append(np.linalg.norm(truth.v[:3] - state.v[:3]))
            lean.append(math.acos(min(1.0, attitude(truth.q)[2] @ attitude(state.q)[2])))
        return float(rms(speed)), math.degrees(rms(lean))


def stand(
    plant: Plant, seconds: float, modify_sample=lambda k, report: None, lift: float = 0.0
) -> StandRun:
    """Stand for some seconds; the controller receives only LowStates."""
    run = StandRun(plant, surefoot.StandController(plant.robot))
    report = plant.reset()
    run.start = plant.truth
    plant.data.qpos[2] += lift
    mujoco.mj_step1(plant.model, plant.data)  # Plant.step() begins with mj_step2
    for k in range(round(seconds * plant.settings.control_rate)):
        modify_sample(k, report)
        run.reports.append(report.to_bytes())
        command = run.controller.update(surefoot.LowState.from_bytes(run.reports[-1]))
        run.commands.append(command.to_bytes())
        run.statuses.append(run.controller.status)
        run.estimates.append(run.controller.state)
        run.truths.append(plant.truth)
        report = plant.step(command)
    return run


def check_controlled(run: StandRun) -> None:
    """Check that the robot stands, every status is usable, and all commands are torque mode."""
    assert not run.plant.truth.fell
    assert all(surefoot.is_usable(status) for status in run.statuses)
    frames = np.array([np.frombuffer(c, np.uint8) for c in run.commands])
    motors = frames[:, 22 : 22 + 12 * 33].reshape(-1, 33)[:, :21].copy().view(MOTOR)
    for name, value in {"mode": 0x0A, "q": 2.146e9, "dq": 16000.0, "Kp": 0.0, "Kd": 0.0}.items():
        np.testing.assert_array_equal(motors[name], value)


def check_settled(run: StandRun) -> None:
    """Check that the robot has settled at the end of the run."""
    truth = run.plant.truth
    assert np.linalg.norm(run.offset(truth)) < 0.010
    assert run.tilt(truth) < 2.0
    assert abs(run.yaw(truth)) < 2.0
    assert np.linalg.norm(truth.v[:3]) < 0.05


@pytest.mark.parametrize("force", FORCE)
@pytest.mark.parametrize("name", ROBOTS)
def test_robot_stands_quietly_in_torque_mode(name: str, force: str) -> None:
    run = stand(Plant(name, PlantSettings(foot_force=force, seed=1)), 4.0)
    check_controlled(run)
    assert abs(run.offset(run.truths[-1])[2]) <= 0.005
    assert run.tilt(run.truths[-1]) <= 0.5
    assert abs(run.yaw(run.truths[-1])) <= 1.0
    com = np.array([truth.com for truth in run.last_truths()])
    assert rms(np.linalg.norm(com - com.mean(axis=0), axis=1)) <= 0.001
    assert rms([truth.dq for truth in run.last_truths()]) <= 0.03
    assert run.high_frequency_torque() <= {"b1": 1.5}.get(name, 0.3)
    assert run.foot_travel() <= 0.005
    speed_error, tilt_error = run.estimate_errors()
    assert speed_error <= 0.04
    assert tilt_error <= 0.6


@pytest.mark.parametrize("direction", ["lateral", "forward"])
@pytest.mark.parametrize(
    ("name", "force"), [(n, "dead") for n in ROBOTS] + [("go1", "est"), ("b1", "est")]
)
def test_robot_survives_a_50_percent_push_and_settles(name, force, direction) -> None:
    plant = Plant(name, PlantSettings(foot_force=force, seed=2))
    plant.add_push(Push(direction, 0.5 * plant.lip_push_limit(direction), 0.1, 1.0))
    run = stand(plant, 4.1)
    check_controlled(run)
    check_settled(run)
    moved = [np.linalg.norm(run.offset(truth)) for truth in run.truths]
    assert max(moved) > 0.005
    speed_error, tilt_error = run.estimate_errors()
    assert speed_error <= 0.04
    assert tilt_error <= 0.6


def test_controller_depends_on_the_samples_alone(tmp_path) -> None:
    plant = Plant("go1", PlantSettings(seed=3))
    plant.add_push(Push("lateral", 4.0, 0.1, 0.2))
    run = stand(plant, 1.0)
    plant.robot.save(str(tmp_path / "go1.robot"))
    alone = surefoot.StandController(surefoot.Robot.load(str(tmp_path / "go1.robot")))
    replies = [alone.update(surefoot.LowState.from_bytes(report)) for report in run.reports]
    assert [reply.to_bytes() for reply in replies] == run.commands
    with pytest.raises(TypeError):
        alone.update(plant.truth)


@pytest.mark.parametrize("force", FORCE)
@pytest.mark.parametrize("name", ["go1", "b1"])
def test_robot_stands_with_zero_tau_est_for_the_first_100_ms(name: str, force: str) -> None:
    def clear_tau_est(k: int, report: surefoot.LowState) -> None:
        for i in range(12 if k < 50 else 0):
            report.motorState[i].tauEst = 0.0

    run = stand(Plant(name, PlantSettings(foot_force=force)), 3.0, clear_tau_est)
    check_controlled(run)
    check_settled(run)


@pytest.mark.parametrize("force", FORCE)
@pytest.mark.parametrize("name", ROBOTS)
def test_robot_dropped_from_1_cm_stands(name: str, force: str) -> None:
    run = stand(Plant(name, PlantSettings(foot_force=force)), 4.0, lift=0.01)
    check_controlled(run)
    check_settled(run)
    assert np.linalg.norm(run.truths[5].foot_forces) == 0.0


@pytest.mark.parametrize("name", ["go1", "b1"])
def test_robot_stands_and_settles_at_1_khz(name: str) -> None:
    plant = Plant(name, PlantSettings(control_rate=1000.0))
    plant.add_push(Push("lateral", 0.5 * plant.lip_push_limit("lateral"), 0.1, 0.5))
    run = stand(plant, 3.6)
    check_controlled(run)
    check_settled(run)
    ticks = [surefoot.LowState.from_bytes(report).tick for report in run.reports]
    assert set(np.diff(ticks)) == {1}
    assert rms([truth.dq for truth in run.last_truths(0.5)]) <= 0.03


def test_robot_is_still_with_ideal_sensors() -> None:
    run = stand(Plant("go2", PlantSettings(sensors="ideal")), 3.0)
    check_controlled(run)
    assert np.linalg.norm(run.offset(run.truths[-1])) < 1e-3
    assert rms([truth.dq for truth in run.last_truths(1.0)]) < 1e-3


def test_8_ms_of_bad_samples_do_not_move_the_robot() -> None:
    def corrupt_sample(k: int, report: surefoot.LowState) -> None:
        report.imu.quaternion[0] = math.nan if k % 100 < 4 and k > 50 else report.imu.quaternion[0]

    run = stand(Plant("go1"), 3.0, corrupt_sample)
    assert set(run.statuses) == {surefoot.Status.OK, surefoot.Status.NON_FINITE}
    assert not run.plant.truth.fell
    check_settled(run)


def test_lasting_bad_samples_damp_and_lower_the_robot_slowly() -> None:
    def corrupt_sample(k: int, report: surefoot.LowState) -> None:
        report.imu.gyroscope[0] = math.nan if k > 250 else report.imu.gyroscope[0]

    run = stand(Plant("go1"), 1.5, corrupt_sample)
    assert run.statuses[-1] == surefoot.Status.DAMPING
    assert run.controller.fault == surefoot.Status.NON_FINITE
    sinking = [truth.com_velocity[2] for truth in run.truths[250:]]
    assert -1.0 < min(sinking) < -0.05
    assert max(run.tilt(truth) for truth in run.truths) < 20.0


def test_unknown_2_kg_payload_causes_no_height_or_tilt_error() -> None:
    load = PlantSettings(payload_kg=2.0, payload_position=(0.15, 0.0, 0.05))
    run = stand(Plant("go1", load), 6.0)
    check_controlled(run)
    assert abs(run.offset(run.truths[-1])[2]) < 0.005
    assert run.tilt(run.truths[-1]) < 0.2
