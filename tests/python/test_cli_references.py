import math

import pytest
from surefoot import Error
from surefoot.stand import ReferenceRequest, StandSettings, parse_reference
from surefoot.stand.reference_request import AXES, body_references

READ = {
    "roll=10@4.0": ReferenceRequest({"roll": 10.0}, 4.0),
    "roll=10,height=-0.02@4.0": ReferenceRequest({"roll": 10.0, "height": -0.02}, 4.0),
    "x=1e-2@0": ReferenceRequest({"x": 0.01}, 0.0),
    " pitch = -3.5 , y = 0 @ 1.5 ": ReferenceRequest({"pitch": -3.5, "y": 0.0}, 1.5),
    "yaw=+5@2": ReferenceRequest({"yaw": 5.0}, 2.0),
}
BAD = [
    "",
    "roll",
    "roll=10",
    "@4",
    "=10@4",
    "roll@4",
    "roll=10@",
    "roll=10@4@5",
    "roll=10,@4",
    "roll=10;yaw=5@4",
    "roll=@4",
    "roll=ten@4",
    "roll=nan@4",
    "height=inf@4",
    "roll=10@soon",
    "roll=10@-1",
    "roll=181@1",
    "height=11@1",
    "roll=10,roll=5@4",
]


@pytest.mark.parametrize("text", READ)
def test_reference_text_is_parsed(text):
    assert parse_reference(text) == READ[text]


@pytest.mark.parametrize("text", READ)
def test_reference_text_round_trips(text):
    request = parse_reference(text)
    assert parse_reference(str(request)) == request


@pytest.mark.parametrize("text", BAD)
def test_invalid_reference_text_is_refused_in_one_line(text):
    with pytest.raises(Error, match="expected") as problem:
        parse_reference(text)
    assert "\n" not in str(problem.value)


def test_unknown_axis_error_suggests_the_nearest_and_lists_all():
    with pytest.raises(Error, match=r"'rol' \(did you mean 'roll'\?\)") as problem:
        parse_reference("rol=10@4")
    assert all(axis in str(problem.value) for axis in AXES)


def test_a_reference_after_the_end_of_the_run_is_refused():
    with pytest.raises(
        Error, match=r"got time 4\.0 s, expected one before the end of the run at 3"
    ):
        StandSettings(duration=3.0, references=(parse_reference("roll=10@4"),))


def test_reference_angles_convert_to_radians():
    reference = body_references([parse_reference("roll=180,yaw=-90,x=0.5@0")], 500.0)[0]
    assert (reference.roll, reference.yaw) == pytest.approx((math.pi, -math.pi / 2))
    assert (reference.x, reference.y, reference.height, reference.pitch) == (0.5, 0.0, 0.0, 0.0)


def test_later_reference_replaces_only_its_own_axes():
    texts = ["height=-0.02@3", "roll=10,x=0.01@1", "roll=5@4"]
    steps = body_references([parse_reference(text) for text in texts], 100.0)
    seen = {k: (math.degrees(r.roll), r.x, r.height) for k, r in steps.items()}
    assert list(seen) == [100, 300, 400]
    assert seen[100] == pytest.approx((10.0, 0.01, 0.0))
    assert seen[300] == pytest.approx((10.0, 0.01, -0.02))
    assert seen[400] == pytest.approx((5.0, 0.01, -0.02))


def test_references_of_the_same_time_are_merged():
    steps = body_references([parse_reference("roll=1@1"), parse_reference("yaw=1@1")], 500.0)
    assert list(steps) == [500]
    assert steps[500].roll == steps[500].yaw == pytest.approx(math.radians(1.0))


@pytest.mark.parametrize(("time", "tick"), [(0.0, 0), (0.3, 150), (0.301, 151), (0.7, 350)])
def test_reference_starts_at_the_first_tick_at_or_after_its_time(time, tick):
    assert list(body_references([ReferenceRequest({"x": 0.0}, time)], 500.0)) == [tick]
