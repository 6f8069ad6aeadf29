# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from plant_helpers import pd_command
from surefoot.robot.loading import describe_robot
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim.model.collada import read_collada
from surefoot.sim.model.visuals import merge_vertices

needs_graphics = pytest.mark.skipif("MUJOCO_GL" not in os.environ, reason="MUJOCO_GL is not set")


@needs_graphics
def test_rendered_image_shows_robot_and_push() -> None:
    from surefoot.sim import Renderer

    plant = Plant("go2", PlantSettings(sensors="ideal"), [Push("lateral", 8.0, 0.1, 0.01)])
    renderer = Renderer(plant, width=320, height=240)
    standing = renderer.frame().astype(int)
    for _ in range(10):
        plant.step(pd_command(plant))
    pushed = renderer.frame().astype(int)
    renderer.close()
    assert standing.shape == (240, 320, 3)

    def red(picture: np.ndarray) -> int:
        return int((picture[..., 0] > picture[..., 1:].max(axis=2) + 80).sum())

    assert (standing[60:200, 80:240].max(axis=2) < 70).sum() > 200  # dark legs and shadow
    assert red(standing) == 0
    assert red(pushed) > 100


def test_simulation_without_rendering_does_not_import_the_renderer() -> None:
    code = "import sys, surefoot.sim; print('surefoot.sim.render' in sys.modules)"
    path = os.pathsep.join([str(Path(p)) for p in sys.path if p])
    answer = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=True,
    )
    assert answer.stdout.strip() == "False"


@pytest.mark.parametrize(
    ("name", "mesh", "size"),
    [
        ("go2", "go2_description/visuals/thigh.dae", [0.096, 0.074, 0.278]),
        ("go1", "go1_description/meshes/calf.dae", [0.055, 0.040, 0.266]),
    ],
)
def test_collada_mesh_has_the_correct_size(name: str, mesh: str, size: list[float]) -> None:
    vertices, faces = read_collada(describe_robot(name).mesh_root / "robots" / mesh)
    np.testing.assert_allclose(np.ptp(vertices, axis=0), size, atol=0.001)
    assert faces.max() == len(vertices) - 1
    # A long edge would show that the indices of several materials are mixed up.
    edges = np.linalg.norm(vertices[faces[:, 0]] - vertices[faces[:, 1]], axis=1)
    assert np.quantile(edges, 0.99) < 0.1


TRIANGLE = """<geometry id="{0}"><mesh>
  <source id="{0}p"><float_array>0 0 0 1 0 0 0 1 0</float_array></source>
  <vertices id="{0}v"><input semantic="POSITION" source="#{0}p"/></vertices>
  <triangles><input semantic="NORMAL" offset="1"/><input semantic="VERTEX" offset="0"/>
  <p>0 7 1 7 2 7</p></triangles></mesh></geometry>"""
SCENE = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema">
  <library_geometries>{}{}</library_geometries><library_visual_scenes><visual_scene>
  <node><matrix>1 0 0 5  0 1 0 0  0 0 1 0  0 0 0 1</matrix><instance_geometry url="#a"/>
  <node><matrix>0 -1 0 0  1 0 0 0  0 0 1 2  0 0 0 1</matrix><instance_geometry url="#b"/></node>
  </node></visual_scene></library_visual_scenes></COLLADA>"""


def test_nested_collada_nodes_transform_their_meshes(tmp_path: Path) -> None:
    path = tmp_path / "two.dae"
    path.write_text(SCENE.format(TRIANGLE.format("a"), TRIANGLE.format("b")))
    vertices, faces = read_collada(path)
    first = [[5, 0, 0], [6, 0, 0], [5, 1, 0]]
    second = [[5, 0, 2], [5, 1, 2], [4, 0, 2]]  # rotated by 90 deg about z, raised, then moved
    np.testing.assert_allclose(vertices[faces[0]], first)
    np.testing.assert_allclose(vertices[faces[1]], second)


def test_merging_vertices_keeps_both_sides_of_a_thin_wall() -> None:
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    vertices = np.vstack([square, square + np.array([0, 0, 1e-4])])
    front = np.array([[0, 1, 2], [0, 2, 3]])
    faces = np.vstack([front, front[:, ::-1] + 4, front[:, [1, 2, 0]]])
    merged, kept = merge_vertices(vertices, faces)
    assert len(merged) == 4
    assert len(kept) == 4
