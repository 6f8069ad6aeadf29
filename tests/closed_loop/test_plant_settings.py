# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

from typing import Any

import pytest
import surefoot
from surefoot.robot.loading import describe_robot
from surefoot.sim import Plant, PlantSettings, Push


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("sensors", "perfect"),
        ("foot_force", "on"),
        ("walking_sensors", "real"),
        ("soft_soles", 0.005),
        ("friction", -0.1),
        ("friction", float("nan")),
        ("friction", "high"),
        ("soft_ground_sink", -0.01),
        ("soft_ground_sink", 0.2),
        ("slope_deg", 60.0),
        ("slope_heading_deg", 1e6),
        ("payload_kg", -1.0),
        ("payload_position", (0.0, 0.0)),
        ("payload_position", (0.0, 0.0, float("inf"))),
        ("payload_position", None),
        ("control_rate", 0.0),
        ("physics_dt", 0.0007),
        ("physics_dt", 0.1),
        ("joint_friction_scale", -1.0),
        ("armature_scale", True),
        ("backlash_deg", -0.1),
        ("backlash_deg", 6.0),
        ("motor_lag", -0.001),
        ("extra_delay", -0.002),
        ("seed", -1),
        ("seed", 1.5),
    ],
)
def test_invalid_setting_error_names_the_field(field: str, value: Any) -> None:
    with pytest.raises(surefoot.Error, match=rf"^{field}: got "):
        PlantSettings(**{field: value})


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("direction", "up"),
        ("direction", 400.0),
        ("impulse", float("nan")),
        ("duration", 0.0),
        ("time", -1.0),
        ("height", float("inf")),
    ],
)
def test_invalid_push_error_names_the_field(field: str, value: Any) -> None:
    good: dict[str, Any] = {"direction": "lateral", "impulse": 1.0, "duration": 0.1, "time": 0.0}
    with pytest.raises(surefoot.Error, match=rf"^{field}: got "):
        Push(**{**good, field: value})


def test_an_error_lists_the_valid_names() -> None:
    with pytest.raises(surefoot.Error, match="'perfect'; valid names: real, ideal"):
        PlantSettings(sensors="perfect")
    with pytest.raises(surefoot.Error, match="'up'; valid names: forward, lateral or a number"):
        Push("up", 1.0)


def test_settings_of_the_wrong_type_are_refused() -> None:
    with pytest.raises(surefoot.Error, match="expected PlantSettings"):
        Plant("go1", {"sensors": "ideal"})  # type: ignore[arg-type]


def test_motor_lag_default_depends_on_the_sensors() -> None:
    assert PlantSettings().lag == 0.002
    assert PlantSettings(sensors="ideal").lag == 0.0
    assert PlantSettings(motor_lag=0.005).lag == 0.005
    assert PlantSettings().steps_per_tick == 4


def test_plant_is_built_from_user_files() -> None:
    go2 = describe_robot("go2")
    models = surefoot.robot.description._models_folder()
    plant = Plant(describe_robot(urdf=go2.urdf, config=models / "go2.toml"))
    assert plant.robot.mass == pytest.approx(Plant("go2").robot.mass)


def test_unknown_foot_link_is_named() -> None:
    go1 = describe_robot("go1")
    go1.table["feet"]["frames"][2] = "RR_foot_fixed"  # the joint of that name, not the link
    with pytest.raises(surefoot.Error, match="got 'RR_foot_fixed', expected a link of the URDF"):
        Plant(go1)
