import pytest
from surefoot import Error
from surefoot.stand import PushRequest, parse_push

READ = {
    "lateral:8.0:0.1@2.0": PushRequest("lateral", 8.0, False, 0.1, 2.0),
    "forward:-12:0.05@0": PushRequest("forward", -12.0, False, 0.05, 0.0),
    "45:3.25:1@1.5": PushRequest(45.0, 3.25, False, 1.0, 1.5),
    "-90.5:1e1:0.1@2": PushRequest(-90.5, 10.0, False, 0.1, 2.0),
    "lateral:50%:0.1@2.0": PushRequest("lateral", 50.0, True, 0.1, 2.0),
    "lateral:8.0:0.1:0.1@2.0": PushRequest("lateral", 8.0, False, 0.1, 2.0, 0.1),
    "lateral:65%:0.1:-0.05@2.0": PushRequest("lateral", 65.0, True, 0.1, 2.0, -0.05),
    "forward:8:0.1:0@2": PushRequest("forward", 8.0, False, 0.1, 2.0, 0.0),
}
BAD = [
    "",
    "lateral",
    "lateral:8",
    "lateral:8:0.1",
    "lateral:8:0.1@",
    "lateral:8:0.1@2@3",
    "lateral:8:0.1:2",
    "lateral:8%%:0.1@2",
    "lateral:%:0.1@2",
    "sideways:8:0.1@2",
    "lateral:much:0.1@2",
    "lateral:nan:0.1@2",
    "inf:8:0.1@2",
    "lateral:8:0@2",
    "lateral:8:-0.1@2",
    "lateral:8:0.1@-2",
    "lateral:8:0.1:@2",
    "lateral:8:0.1:0.1:0.1@2",
    "lateral:8:0.1:high@2",
    "lateral:8:0.1:nan@2",
    "lateral:8:0.1:11@2",
    "lateral:8:0.1@2:0.1",
]


class PlantWithLimit:
    """A fake plant whose LIP push limit depends on direction and duration."""

    def lip_push_limit(self, direction, duration):
        return {"lateral": 12.0, "forward": 20.0}[direction] * (1.0 + duration)


@pytest.mark.parametrize("text", READ)
def test_push_text_is_parsed(text):
    assert parse_push(text) == READ[text]


@pytest.mark.parametrize("text", READ)
def test_push_text_round_trips(text):
    push = parse_push(text)
    assert parse_push(str(push)) == push


@pytest.mark.parametrize("text", BAD)
def test_invalid_push_text_is_refused_in_one_line(text):
    with pytest.raises(Error, match="expected") as problem:
        parse_push(text)
    assert "\n" not in str(problem.value)


def test_push_percentage_resolves_to_newton_seconds():
    push = parse_push("forward:25%:0.5@1").resolve(PlantWithLimit())
    assert push.impulse == pytest.approx(0.25 * 20.0 * 1.5)
    assert (push.direction, push.duration, push.time) == ("forward", 0.5, 1.0)


@pytest.mark.parametrize(("text", "height"), [("8:0.1:0.1", 0.1), ("50%:0.1:-0.05", -0.05)])
def test_push_height_defaults_to_the_centre_of_mass(text, height):
    assert parse_push(f"lateral:{text}@1").resolve(PlantWithLimit()).height == height
    assert parse_push("lateral:8:0.1@1").resolve(PlantWithLimit()).height == 0.0


def test_newton_seconds_do_not_depend_on_the_plant():
    assert parse_push("lateral:8:0.1@1").resolve(PlantWithLimit()).impulse == 8.0
