# SPDX-License-Identifier: BSD-3-Clause
"""Forty healthy recordings of four robots, quiet, pushed, sloped and loaded: none is refused."""

from __future__ import annotations

import pytest
import surefoot
from surefoot.estimate.checks import check_log
from surefoot.sim import PlantSettings
from surefoot.stand import SensorRecorder, StandSettings, parse_push, parse_reference, run_stand

pytestmark = pytest.mark.slow

DURATION = 1.6  # [s]
PLANTS = {
    "quiet": {},
    "slippery": {"friction": 0.4},
    "soft ground": {"soft_ground_sink": 0.005},
    "uphill": {"slope_deg": 10.0},
    "left side up": {"slope_deg": 10.0, "slope_heading_deg": 90.0},
    "right side up": {"slope_deg": 10.0, "slope_heading_deg": -90.0},
    "payload": {"payload_kg": 3.0, "payload_position": (0.05, 0.04, 0.08)},
    "pushed sideways": {},
    "pushed forward on a slope": {"slope_deg": 5.0, "slope_heading_deg": 45.0},
    "moving": {},
}
PUSHES = {
    "pushed sideways": "lateral:50%:0.1@0.5",
    "pushed forward on a slope": "forward:50%:0.1@0.5",
}
REFERENCES = {"moving": ("yaw=8,roll=6,pitch=-4@0.3", "yaw=-6,roll=0@0.9")}


@pytest.mark.parametrize("condition", PLANTS)
@pytest.mark.parametrize("name", ["a1", "b1", "go1", "go2"])
def test_healthy_recording_is_accepted_without_a_doubt(name, condition) -> None:
    recorder = SensorRecorder()
    settings = StandSettings(
        robot=name,
        duration=DURATION,
        plant=PlantSettings(seed=list(PLANTS).index(condition), **PLANTS[condition]),
        pushes=tuple(parse_push(PUSHES[condition]) for _ in range(condition in PUSHES)),
        references=tuple(map(parse_reference, REFERENCES.get(condition, ()))),
    )
    run_stand(settings, sensors=recorder)
    assert check_log(surefoot.load_robot(name), recorder.log(condition)) == []
