# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import math
import struct

import numpy as np
import pinocchio as pin
import pytest
import surefoot
from surefoot import FallbackLevel, LowState, StandController, Status

PERIOD = 2  # [ms]
HOLD_TICKS = 5  # ticks of 2 ms for which the last good command is repeated
MOTOR = np.dtype(
    {
        "names": ["mode", "q", "dq", "tau", "Kp", "Kd"],
        "formats": ["u1", "<f4", "<f4", "<f4", "<f4", "<f4"],
        "offsets": [0, 1, 5, 9, 13, 17],
        "itemsize": 33,
    }
)
NON_FINITE_VALUES = [math.nan, math.inf, -math.inf, 1e30]


def motors(commands):
    """Return the twelve motor commands of LowCmds or of their bytes, shape (n, 12)."""
    frames = [c if isinstance(c, bytes) else c.to_bytes() for c in commands]
    return np.array([np.frombuffer(frame, MOTOR, 12, 22) for frame in frames])


def damps(commands):
    m = motors(commands)
    still = (m["dq"] == 0.0) & (m["Kp"] == 0.0) & (m["tau"] == 0.0) & (m["Kd"] > 0.0)
    return (still & (m["mode"] == 0x0A) & (m["q"] == np.float32(2.146e9))).all(axis=1)


def is_torque_mode(commands):
    m = motors(commands)
    off = (m["q"] == np.float32(2.146e9)) & (m["dq"] == 16000.0) & (m["Kp"] == 0) & (m["Kd"] == 0)
    return (off & (m["mode"] == 0x0A) & np.isfinite(m["tau"])).all(axis=1)


class Stand:
    """A controller that receives the samples of a robot standing still."""

    def __init__(self, body, tick: int = 1000, period: int = PERIOD, **options) -> None:
        gains = options.pop("gains", body.robot.config.gains)
        self.controller = StandController(body.robot, gains, surefoot.ControllerOptions(**options))
        self.good = body.resting_sample(0).to_bytes()
        self.tick, self.period = tick, period

    def report(self) -> LowState:
        """Return the next valid sample, one period later."""
        self.tick += self.period
        report = LowState.from_bytes(self.good)
        report.tick = self.tick % 2**32
        return report

    def run(self, ticks: int, spoil=lambda report: None):
        """Run some ticks with samples changed by `spoil`; return commands and statuses."""
        commands, statuses = [], []
        for _ in range(ticks):
            report = self.report()
            spoil(report)
            commands.append(self.controller.update(report).to_bytes())
            statuses.append(self.controller.status)
        return commands, statuses


@pytest.fixture
def stand(go1) -> Stand:
    return Stand(go1)


def set_imu(field: str, index: int, value: float):
    def spoil(report: LowState) -> None:
        getattr(report.imu, field)[index] = value

    return spoil


TOPPLING_ACCELERATION = 10.0  # [rad/s^2]


def toppling(axis: int, rate: float, angles: list[float]):
    """Return a function that writes the IMU values of a robot that topples about an axis.

    Args:
        axis: Axis of the base, 0 .. 2.
        rate: Largest angular velocity [rad/s].
        angles: Receives the tilt of every tick [rad].
    """
    turn, angle, speed = np.eye(3)[axis], 0.0, 0.0

    def spoil(report: LowState) -> None:
        nonlocal angle, speed
        speed = min(rate, speed + 0.001 * PERIOD * TOPPLING_ACCELERATION)
        angle += 0.001 * PERIOD * speed
        angles.append(angle)
        report.imu.gyroscope[:] = speed * turn
        report.imu.accelerometer[:] = 9.81 * pin.exp3(angle * turn)[2]

    return spoil


def lift(stand: Stand, body) -> None:
    """Unload all feet, so that leg kinematics do not contradict a rotation of the body."""
    stand.good = body.resting_sample(0, loads=(0.0,) * 4).to_bytes()
    stand.run(30)


def set_motor(index: int, field: str, value: float):
    def spoil(report: LowState) -> None:
        setattr(report.motorState[index], field, value)

    return spoil


def used_fields(value: float):
    sizes = {"quaternion": 4, "gyroscope": 3, "accelerometer": 3}
    for field, size in sizes.items():
        for k in range(size):
            yield f"{field}[{k}]", set_imu(field, k, value)
    for i in range(12):
        for field in ("q", "dq", "tauEst"):
            yield f"motor {i} {field}", set_motor(i, field, value)


def zero_quaternion(report: LowState) -> None:
    report.imu.quaternion[:] = 0.0


def long_quaternion(report: LowState) -> None:
    report.imu.quaternion[:] *= 1.5


nan_gyroscope = set_imu("gyroscope", 0, math.nan)


def set_tick(tick: int):
    def spoil(report: LowState) -> None:
        report.tick = tick

    return spoil


def backwards(report: LowState) -> None:
    report.tick = 2**32 - report.tick


FAULTS = {
    "NaN": (set_motor(3, "q", math.nan), Status.NON_FINITE),
    "tick that stands still": (set_tick(1000 + 40 * PERIOD), Status.STALE_TICK),
    "tick that jumped back": (set_tick(7), Status.STALE_TICK),
    "tick running backwards": (backwards, Status.STALE_TICK),
    "rate beyond any gyroscope": (set_imu("gyroscope", 1, 50.0), Status.IMPLAUSIBLE),
}


@pytest.fixture(params=FAULTS)
def fault(request):
    return FAULTS[request.param]


def test_resting_robot_is_held_by_static_torques(body) -> None:
    stand = Stand(body)
    commands, statuses = stand.run(200)
    assert set(statuses) == {Status.OK}
    assert is_torque_mode(commands).all()
    reported = [body.resting_sample(0).motorState[i].tauEst for i in range(12)]
    share = body.robot.config.tau_max.max()
    np.testing.assert_allclose(motors(commands)["tau"][-1], reported, atol=0.05 * share)


def test_new_controller_has_status_waiting(go1) -> None:
    controller = StandController(go1.robot)
    assert (controller.status, controller.fault) == (Status.WAITING, Status.OK)


def test_fault_holds_the_command_for_10_ms_then_latches_damping(stand, fault) -> None:
    spoil, status = fault
    good, _ = stand.run(40)
    commands, statuses = stand.run(20, spoil)
    assert set(commands[:HOLD_TICKS]) == {good[-1]}
    assert set(statuses[:HOLD_TICKS]) == {status}
    assert damps(commands[HOLD_TICKS:]).all()
    assert set(statuses[HOLD_TICKS:]) == {Status.DAMPING}
    assert stand.controller.fault == status
    commands, statuses = stand.run(200)
    assert damps(commands).all()
    assert set(statuses) == {Status.DAMPING}
    assert stand.controller.fault == status


@pytest.mark.parametrize("value", NON_FINITE_VALUES)
def test_every_used_field_is_checked_for_non_finite_values(go1, value: float) -> None:
    for name, spoil in used_fields(value):
        stand = Stand(go1)
        good, _ = stand.run(3)
        commands, statuses = stand.run(10, spoil)
        assert set(statuses[:HOLD_TICKS]) == {Status.NON_FINITE}, name
        assert set(commands[:HOLD_TICKS]) == {good[-1]}, name
        assert damps(commands[HOLD_TICKS:]).all(), name
        assert set(statuses[HOLD_TICKS:]) == {Status.DAMPING}, name


def test_straight_leg_stops_only_the_condensed_form(go1) -> None:
    straighten = set_motor(2, "q", 0.0)
    stand = Stand(go1, form=surefoot.QpForm.CONDENSED)
    stand.run(40)
    commands, statuses = stand.run(20, straighten)
    assert is_torque_mode(commands[:HOLD_TICKS]).all()
    assert (
        stand.controller.fallback_count(FallbackLevel.FORCES) == HOLD_TICKS
    )  # the sample is valid: a fallback level gives torques
    assert set(statuses[:HOLD_TICKS]) == {Status.SINGULAR}
    assert damps(commands[HOLD_TICKS:]).all()
    stand = Stand(go1)
    stand.run(40)
    commands, statuses = stand.run(3, straighten)
    assert all(surefoot.is_usable(status) for status in statuses)
    assert stand.controller.solution.form == surefoot.QpForm.GENERAL
    assert is_torque_mode(commands).all()
    tau = motors(commands)["tau"]
    assert (np.abs(tau[:, :12]) <= go1.robot.config.tau_max + 1e-6).all()


RANGE_CASES = {
    "gyroscope": (set_imu("gyroscope", 0, 35.0), set_imu("gyroscope", 0, -60.0)),
    "accelerometer": (set_imu("accelerometer", 2, 157.0), set_imu("accelerometer", 2, 250.0)),
    "hip angle": (set_motor(0, "q", -1.0), set_motor(0, "q", -2.5)),
    "joint speed": (set_motor(7, "dq", -35.0), set_motor(7, "dq", 80.0)),
    "torque": (set_motor(7, "tauEst", 40.0), set_motor(7, "tauEst", -120.0)),
}


@pytest.mark.parametrize("field", RANGE_CASES)
def test_values_beyond_the_sensor_range_are_implausible(go1, field: str) -> None:
    can, cannot = RANGE_CASES[field]
    stand = Stand(go1)
    stand.run(20)
    assert surefoot.is_usable(stand.run(1, can)[1][0])
    stand.run(20)
    commands, statuses = stand.run(10, cannot)
    assert set(statuses[:HOLD_TICKS]) == {Status.IMPLAUSIBLE}
    assert damps(commands[HOLD_TICKS:]).all()
    assert stand.controller.fault == Status.IMPLAUSIBLE


@pytest.mark.parametrize(
    ("spoil", "verdict"), [(zero_quaternion, "ZERO"), (long_quaternion, "IMPLAUSIBLE")]
)
def test_standing_continues_without_a_valid_quaternion(stand, spoil, verdict) -> None:
    stand.run(40)
    commands, statuses = stand.run(500, spoil)
    assert set(statuses) == {Status.OK}
    assert is_torque_mode(commands).all()
    assert stand.controller.estimator_report.quaternion == surefoot.SensorVerdict[verdict]
    stand.run(5)
    assert stand.controller.estimator_report.quaternion == surefoot.SensorVerdict.GOOD


@pytest.mark.parametrize("axis", [0, 1])
def test_toppling_robot_is_damped_beyond_fall_tilt(go1, axis: int) -> None:
    stand = Stand(go1)
    stand.run(20)
    lift(stand, go1)
    angles: list[float] = []
    commands, statuses = stand.run(400, toppling(axis, 4.0, angles))
    fell = statuses.index(Status.FALLEN)
    assert 0.95 <= angles[fell] / go1.robot.config.gains.fall_tilt < 1.2
    assert is_torque_mode(commands[:fell]).all()
    assert set(statuses[fell : fell + HOLD_TICKS]) == {Status.FALLEN}
    assert damps(commands[fell + HOLD_TICKS :]).all()
    assert stand.controller.fault == Status.FALLEN


def test_robot_on_its_side_is_damped_from_the_start(go1) -> None:
    stand = Stand(go1)
    stand.good = go1.resting_sample(0, pin.rpy.rpyToMatrix(1.3, 0.0, 0.0)).to_bytes()
    commands, statuses = stand.run(20)
    assert damps(commands).all()
    assert set(statuses) == {Status.FALLEN}


def test_unused_fields_do_not_change_the_command(go1) -> None:
    def spoil(report: LowState) -> None:
        for motor in (report.motorState[i] for i in range(20)):
            motor.ddq = motor.q_raw = motor.dq_raw = motor.ddq_raw = math.nan
            motor.mode, motor.temperature = 0x08, 127
        for motor in (report.motorState[i] for i in range(12, 20)):
            motor.q = motor.dq = motor.tauEst = math.nan
        report.imu.rpy[:], report.imu.temperature = math.nan, 127
        report.footForce = np.array([-300, 0, 5000, 32767], dtype=np.int16)
        report.head[:], report.levelFlag, report.crc, report.reserve = 0, 0, 1, 2
        report.SN[:], report.version[:], report.bandWidth, report.frameReserve = 3, 4, 5, 6
        report.wirelessRemote[:], report.bms.SOC = 0xFF, 0

    commands, statuses = Stand(go1).run(50, spoil)
    assert set(statuses) == {Status.OK}
    assert commands == Stand(go1).run(50)[0]


@pytest.mark.parametrize("bad_ticks", range(1, HOLD_TICKS + 1))
def test_fault_up_to_10_ms_does_not_latch(stand, fault, bad_ticks: int) -> None:
    spoil, status = fault
    stand.run(40)
    _, during = stand.run(bad_ticks, spoil)
    commands, after = stand.run(50)
    assert set(during) == {status}
    assert set(after) == {Status.OK}
    assert is_torque_mode(commands).all()
    assert stand.controller.fault == status


def test_valid_tick_restarts_the_10_ms_hold(stand) -> None:
    spoil, _ = FAULTS["NaN"]
    stand.run(10)
    for _ in range(20):
        _, during = stand.run(HOLD_TICKS, spoil)
        _, after = stand.run(1)
        assert set(during) == {Status.NON_FINITE}
        assert after == [Status.OK]


def test_reset_ends_damping_and_stands_again(stand, fault) -> None:
    spoil, _ = fault
    stand.run(40)
    stand.run(20, spoil)
    stand.controller.reset()
    assert (stand.controller.status, stand.controller.fault) == (Status.WAITING, Status.OK)
    commands, statuses = stand.run(20)
    assert set(statuses) == {Status.OK}
    assert is_torque_mode(commands).all()


def test_reset_stand_controller_equals_a_new_one(go1) -> None:
    used = Stand(go1)
    used.run(100, set_imu("gyroscope", 0, 0.3))
    used.run(100, set_motor(4, "dq", 2.0))
    used.run(20, nan_gyroscope)
    used.controller.reset()
    assert used.run(100)[0] == Stand(go1).run(100)[0]


def test_bad_first_sample_damps_without_latching(stand) -> None:
    spoil, status = FAULTS["NaN"]
    commands, statuses = stand.run(50, spoil)
    assert damps(commands).all()
    assert set(statuses) == {status}
    commands, statuses = stand.run(5)
    assert set(statuses) == {Status.OK}
    assert is_torque_mode(commands).all()


@pytest.mark.parametrize("first", [zero_quaternion, FAULTS["NaN"][0]])
def test_bad_first_samples_damp_until_a_valid_sample(stand, first) -> None:
    commands, statuses = stand.run(3, first)
    assert damps(commands).all()
    assert Status.DAMPING not in statuses
    assert stand.run(1)[1] == [Status.OK]


def linear_acceleration(report: LowState) -> None:
    report.imu.accelerometer[2] -= 9.81


def reversed_torques(report: LowState) -> None:
    for i in range(12):
        report.motorState[i].tauEst *= -1.0


WRONG_SENSORS = {
    "accelerometer without gravity": (linear_acceleration, Status.WRONG_ACCELEROMETER),
    "torques of the opposite sign": (reversed_torques, Status.WRONG_JOINT_TORQUES),
    "hip in degrees": (set_motor(0, "q", 40.0), Status.WRONG_JOINT_ANGLES),
    "rate beyond any gyroscope": (set_imu("gyroscope", 1, 50.0), Status.WRONG_GYROSCOPE),
}


@pytest.mark.parametrize("name", WRONG_SENSORS)
def test_sensor_wrong_since_the_first_sample_is_named_and_latches_damping(go1, name: str) -> None:
    spoil, status = WRONG_SENSORS[name]
    stand = Stand(go1)
    commands, statuses = stand.run(200, spoil)
    assert stand.controller.fault == status and surefoot.names_wrong_sensor(status)
    assert statuses[-1] == Status.DAMPING and damps(commands[-1:]).all()
    _, statuses = stand.run(100)
    assert set(statuses) == {Status.DAMPING} and stand.controller.fault == status
    stand.controller.reset()
    _, statuses = stand.run(200)
    assert set(statuses) == {Status.OK} and stand.controller.fault == Status.OK


@pytest.mark.parametrize("name", WRONG_SENSORS)
def test_sensor_that_fails_later_is_not_named(go1, name: str) -> None:
    stand = Stand(go1)
    stand.run(200)
    stand.run(200, WRONG_SENSORS[name][0])
    assert not surefoot.names_wrong_sensor(stand.controller.fault)


def test_damping_uses_damping_kd(go1) -> None:
    gains = surefoot.Gains()
    gains.damping_kd = 4.5
    stand = Stand(go1, gains=gains)
    commands, _ = stand.run(1, nan_gyroscope)
    np.testing.assert_array_equal(motors(commands)["Kd"], 4.5)
    gains.damping_kd = 6.0
    stand.controller.set_gains(gains)
    np.testing.assert_array_equal(motors(stand.run(1, nan_gyroscope)[0])["Kd"], 6.0)


def test_motor_damping_changes_only_kd_and_dq(go1) -> None:
    commands = motors(Stand(go1, motor_damping=0.75).run(20)[0])
    np.testing.assert_array_equal(commands["Kd"], 0.75)
    np.testing.assert_array_equal(commands["dq"], 0.0)
    pure = motors(Stand(go1).run(20)[0])
    for field in ("mode", "q", "Kp", "tau"):
        np.testing.assert_array_equal(commands[field], pure[field])


def test_empty_slots_and_frame_header_keep_sdk_defaults(go1) -> None:
    stand, default = Stand(go1), surefoot.LowCmd().to_bytes()
    good, _ = stand.run(3)
    bad, _ = stand.run(10, nan_gyroscope)
    for frame in (good[-1], bad[-1]):
        assert frame[:22] == default[:22]
        assert frame[22 + 12 * 33 :] == default[22 + 12 * 33 :]


def test_control_continues_across_the_tick_wrap(go1) -> None:
    wrapping, plain = Stand(go1, tick=2**32 - 100), Stand(go1, tick=5000)
    commands, statuses = wrapping.run(100)
    assert set(statuses) == {Status.OK}
    assert commands == plain.run(100)[0]


def test_tick_wrap_during_a_fault_is_not_a_fault(go1) -> None:
    stand = Stand(go1, tick=2**32 - 6)
    stand.run(1)
    assert set(stand.run(4, nan_gyroscope)[1]) == {Status.NON_FINITE}
    assert set(stand.run(10)[1]) == {Status.OK}


@pytest.mark.parametrize("period", [1, 2, 4])
def test_time_advances_by_ticks_not_by_calls(go1, period: int) -> None:
    stand = Stand(go1, period=period)
    stand.run(1)
    stand.run(100 // period, set_imu("gyroscope", 2, 0.5))
    turned = pin.rpy.matrixToRpy(pin.Quaternion(stand.controller.state.q[3:7]).matrix())[2]
    assert turned == pytest.approx(0.05, rel=0.06)


@pytest.mark.parametrize("period", [1, 2, 5])
def test_command_is_held_for_10_ms_at_any_rate(go1, period: int) -> None:
    stand = Stand(go1, period=period)
    good, _ = stand.run(20)
    commands, _ = stand.run(20, nan_gyroscope)
    held = 10 // period
    assert set(commands[:held]) == {good[-1]}
    assert damps(commands[held:]).all()


def test_time_of_bad_samples_is_integrated_later(go1) -> None:
    stand, whole = Stand(go1), Stand(go1)
    for each in (stand, whole):
        each.run(50)
        lift(each, go1)
    for _ in range(50):
        stand.run(2, nan_gyroscope)
        stand.run(1, set_imu("gyroscope", 2, 0.5))
        whole.run(3, set_imu("gyroscope", 2, 0.5))
    ours, theirs = (
        pin.rpy.matrixToRpy(pin.Quaternion(each.controller.state.q[3:7]).matrix())[2]
        for each in (stand, whole)
    )
    assert theirs > 0.1
    assert ours == pytest.approx(theirs, rel=0.02)


def test_single_tick_jump_is_refused_and_control_continues(stand) -> None:
    stand.run(20)
    leap = set_tick(stand.tick + 600_000)
    assert stand.run(1, leap)[1] == [Status.STALE_TICK]
    assert set(stand.run(50)[1]) == {Status.OK}


def test_lasting_tick_jump_latches_damping(stand) -> None:
    stand.run(20)
    stand.tick += 600_000  # the robot was without commands for ten minutes
    commands, statuses = stand.run(20)
    assert statuses == [Status.STALE_TICK] + [Status.DAMPING] * 19
    assert damps(commands[1:]).all()
    assert stand.controller.fault == Status.STALE_TICK
    stand.controller.reset()
    assert set(stand.run(5)[1]) == {Status.OK}


def test_bad_sample_after_a_50_ms_gap_damps_at_once(stand) -> None:
    stand.run(10)
    stand.tick += 50
    commands, statuses = stand.run(1, nan_gyroscope)
    assert damps(commands).all()
    assert statuses == [Status.DAMPING]


def test_robot_clock_restart_damps_until_reset(stand) -> None:
    stand.run(50)
    stand.tick = 0
    commands, _ = stand.run(30)
    assert damps(commands[HOLD_TICKS:]).all()
    stand.controller.reset()
    assert set(stand.run(5)[1]) == {Status.OK}


def test_fault_names_the_latest_reason(stand) -> None:
    stand.run(5)
    assert (stand.controller.status, stand.controller.fault) == (Status.OK, Status.OK)
    stand.run(2, FAULTS["rate beyond any gyroscope"][0])
    assert stand.controller.fault == Status.IMPLAUSIBLE
    stand.run(2, nan_gyroscope)
    assert stand.controller.fault == Status.NON_FINITE


def test_last_valid_estimate_is_kept_during_bad_samples(stand) -> None:
    stand.run(20)
    state, solution = stand.controller.state, stand.controller.solution
    stand.run(20, set_imu("quaternion", 0, math.nan))
    np.testing.assert_array_equal(stand.controller.state.q, state.q)
    np.testing.assert_array_equal(stand.controller.solution.torques, solution.torques)


def inside_limits(body, commands):
    """Return for each command whether all torques are within the limits at rest."""
    return (np.abs(motors(commands)["tau"]) <= np.float32(body.robot.config.tau_max)).all(axis=1)


def test_random_bytes_give_only_valid_commands_or_damping(go1) -> None:
    controller, rng = StandController(go1.robot), np.random.default_rng(42)
    for _ in range(5):
        controller.update(Stand(go1).report())
    commands, statuses = [], []
    for _ in range(2000):
        commands.append(controller.update(LowState.from_bytes(rng.bytes(937))).to_bytes())
        statuses.append(controller.status)
    frames = motors(commands)
    assert all(np.isfinite(frames[field]).all() for field in ("q", "dq", "tau", "Kp", "Kd"))
    assert (damps(commands) | (is_torque_mode(commands) & inside_limits(go1, commands))).all()
    assert Status.OK not in statuses
    assert damps(commands[-1900:]).all()


def set_plausible_random_values(rng, report: LowState) -> None:
    """Write random finite values to all used fields, with a unit quaternion."""
    report.imu.quaternion[:] = rng.normal(size=4)
    report.imu.quaternion[:] /= np.linalg.norm(report.imu.quaternion)
    size = 10.0 ** rng.uniform(-2, 3.9)
    report.imu.gyroscope[:] = size * rng.uniform(-1, 1, 3)
    report.imu.accelerometer[:] = size * rng.uniform(-1, 1, 3)
    report.footForceEst = rng.integers(-32768, 32767, 4).astype(np.int16)
    for motor in (report.motorState[i] for i in range(12)):
        motor.q += rng.normal() * rng.choice([0.1, 3.0])
        motor.dq, motor.tauEst = size * rng.uniform(-1, 1, 2)
    report.tick = (report.tick + int(rng.integers(0, 30))) % 2**32


def test_plausible_random_samples_give_limited_torques_or_damping(body) -> None:
    stand, rng = Stand(body), np.random.default_rng(43)
    commands, statuses = [], []
    for _ in range(500):
        some, what = stand.run(1, lambda report: set_plausible_random_values(rng, report))
        commands, statuses = commands + some, statuses + what
        stand.tick += 30
        if what == [Status.DAMPING]:
            stand.controller.reset()
    assert any(surefoot.is_usable(status) for status in statuses)
    assert Status.DAMPING in statuses
    assert (damps(commands) | (is_torque_mode(commands) & inside_limits(body, commands))).all()


def test_single_bit_flips_never_give_an_invalid_command(go1) -> None:
    stand, rng = Stand(go1), np.random.default_rng(44)
    stand.run(20)

    def flip(report: LowState) -> None:
        report.raw[int(rng.integers(937))] ^= 1 << int(rng.integers(8))

    commands = []
    for _ in range(1000):
        commands += stand.run(1, flip)[0]
        stand.tick += 50
        stand.controller.reset()
        commands += stand.run(1)[0]
    assert (damps(commands) | (is_torque_mode(commands) & inside_limits(go1, commands))).all()
    assert is_torque_mode(commands[1::2]).all()


def test_command_layout_of_this_file_matches_the_sdk() -> None:
    command = surefoot.damping_low_cmd(2.0)
    packed = struct.pack("<B5f", 0x0A, 2.146e9, 0.0, 0.0, 0.0, 2.0)
    assert command.to_bytes()[22 + 33 * 11 :][:21] == packed
    assert damps([command]).all()
    assert is_torque_mode([surefoot.LowCmd()]).all()
