"""Body references: metrics of logs with known contents, and a go1 that follows them."""

import dataclasses
import json
import math

import numpy as np
import pinocchio
import pytest
from stand_log_helpers import RATE, ROBOT, still_log, turn_base
from surefoot import ReachLimit
from surefoot.cli import main
from surefoot.stand import StandSettings, parse_reference, run_stand, summarise
from surefoot.stand.foot_frame import matrices_from_rpy, pose_from_feet, pose_in_support
from surefoot.stand.settling import settle_time, settled_ticks

AXES = ("x_mm", "y_mm", "height_mm", "roll_deg", "pitch_deg", "yaw_deg")
ERRORS = ("height_error_mm", "tilt_error_deg", "yaw_error_deg")


def log_with_references(*texts, **changes):
    """Return a log without motion, with requested references."""
    log = still_log(**changes)
    references = tuple(parse_reference(text) for text in texts)
    settings = dataclasses.replace(log.settings, references=references)
    return dataclasses.replace(log, settings=settings)


def tilt_world(log, degrees):
    """Rotate robot and feet of a log about the world's x axis, then its y axis."""
    R = pinocchio.rpy.rpyToMatrix(math.radians(degrees), math.radians(0.5 * degrees), 0.0)
    for q in log.q_true:
        q[:3] = R @ q[:3]
        attitude = pinocchio.Quaternion(*np.roll(q[3:7], 1)).toRotationMatrix()
        q[3:7] = pinocchio.Quaternion(R @ attitude).coeffs()
    log.feet[:] = np.einsum("ij,njk->nik", R, log.feet)


def test_roll_pitch_yaw_matrices_match_pinocchio():
    angles = np.random.default_rng(4).uniform(-3.0, 3.0, (50, 3))
    for rpy, R in zip(angles, matrices_from_rpy(angles), strict=True):
        np.testing.assert_allclose(R, pinocchio.rpy.rpyToMatrix(*rpy), atol=1e-12)


def test_support_pose_equals_feet_pose_on_level_ground():
    log = still_log()
    ours, plain = (f(log.q_true[:1], log.feet[:1]) for f in (pose_in_support, pose_from_feet))
    np.testing.assert_allclose(ours.position, plain.position, atol=1e-12)
    np.testing.assert_allclose(ours.rotation, plain.rotation, atol=1e-12)


def test_support_pose_is_invariant_to_the_slope():
    log = still_log()
    before = pose_in_support(log.q_true[:1], log.feet[:1])
    tilt_world(log, 12.0)
    after = pose_in_support(log.q_true[:1], log.feet[:1])
    np.testing.assert_allclose(after.position, before.position, atol=1e-12)
    np.testing.assert_allclose(after.rotation, before.rotation, atol=1e-12)


def test_unmoved_body_has_the_full_reference_error():
    s = summarise(log_with_references("roll=10,height=-0.03,x=0.04@1"))
    assert (s["reference_error_mm"], s["reference_error_deg"]) == pytest.approx((50.0, 10.0))
    assert [s["reference_reached"][axis] for axis in AXES] == pytest.approx([0.0] * 6, abs=1e-6)
    assert [s[name] for name in ERRORS] == pytest.approx([30.0, 10.0, 0.0], abs=1e-5)
    assert not s["settled"] and s["settle_time_s"] is None


@pytest.mark.parametrize("slope", [0.0, 8.0])
def test_body_at_its_reference_has_no_error_and_is_settled(slope):
    log = log_with_references("height=-0.02,y=0.01@1", "pitch=-6@2")
    log.q_true[510:, 1:3] += [0.01, -0.02]
    log.q_true[1030:] = [turn_base(q, 1, -6.0) for q in log.q_true[1030:]]
    tilt_world(log, slope)
    s = summarise(log)
    zero = [s["reference_error_mm"], s["reference_error_deg"], *(s[name] for name in ERRORS)]
    assert zero == pytest.approx([0.0] * 5, abs=1e-4)
    reached = [s["reference_reached"][axis] for axis in AXES]
    assert reached == pytest.approx([0.0, 10.0, -20.0, 0.0, -6.0, 0.0], abs=1e-5)
    assert s["settled"] and s["settle_time_s"] == pytest.approx(1030 / RATE - 2.0)


def test_initial_pose_is_the_reference_until_the_first_request():
    log = log_with_references("height=0.05@2")
    log.q_true[1000:, 2] += 0.05
    assert settled_ticks(log).all()
    log.q_true[1500, 2] -= 0.05
    log.q_true[500, 2] += 0.05
    assert np.flatnonzero(~settled_ticks(log)).tolist() == [500, 1500]


def test_settle_time_starts_at_the_last_push_or_reference():
    log = log_with_references("x=0.05@1")
    log.q_true[900:, 0] += 0.05
    assert settle_time(log) == pytest.approx(900 / RATE - 1.0)
    late = dataclasses.replace(log.settings, references=(parse_reference("x=0.05@1.7"),))
    assert settle_time(dataclasses.replace(log, settings=late)) == pytest.approx(900 / RATE - 1.7)


def test_run_without_references_has_no_reference_errors():
    s = summarise(still_log())
    assert (s["references"], s["reference_limit"]) == ([], "none")
    names = ("reference_error_mm", "reference_error_deg", "reference_reached")
    assert [s[name] for name in names] == [None] * 3


@pytest.mark.parametrize(
    ("limit", "motor", "words"),
    [
        (ReachLimit.JOINT, 2, "joint FR_calf_joint"),
        (ReachLimit.SUPPORT, -1, "support"),
        (ReachLimit.FOOT_HEIGHT, 3, "foot height"),
        (ReachLimit.UNREACHABLE, -1, "unreachable"),
    ],
)
def test_reference_limit_is_named_only_while_it_is_active(limit, motor, words):
    log = log_with_references("x=0.05@1")
    log.reach[800:-3], log.reach_motor[800:-3] = limit.value, motor
    assert summarise(log)["reference_limit"] == words
    log.reach[-60:] = ReachLimit.NONE.value
    assert summarise(log)["reference_limit"] == "none"


def test_go1_reaches_its_body_references():
    references = (parse_reference("roll=5@0.5"), parse_reference("height=-0.02@0.8"))
    s = summarise(run_stand(StandSettings("go1", 3.0, references=references)))
    assert not s["fell"] and s["settled"] and s["qp_failures"] == 0
    assert s["reference_error_deg"] < 1.0 and s["reference_error_mm"] < 5.0
    assert s["reference_reached"]["roll_deg"] == pytest.approx(5.0, abs=1.0)
    assert s["reference_reached"]["height_mm"] == pytest.approx(-20.0, abs=5.0)
    assert s["reference_limit"] == "none"
    assert s["settle_time_s"] < 1.5


def test_unreachable_height_stops_at_a_named_joint_limit(capsys):
    words = "stand --duration 3 --reference height=0.3@0.5 --json -"
    assert main(words.split()) == 0
    s = json.loads(capsys.readouterr().out)
    motor, name = s["reference_limit"].split()
    assert motor == "joint" and name in ROBOT.config.joint_names
    assert not s["fell"] and s["qp_failures"] == 0 and not s["settled"]
    assert 0.02 < s["reference_reached"]["height_mm"] / 1000.0 < 0.15
    assert s["reference_error_mm"] == pytest.approx(
        300 - s["reference_reached"]["height_mm"], abs=5
    )
