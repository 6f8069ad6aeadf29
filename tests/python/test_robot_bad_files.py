# SPDX-License-Identifier: BSD-3-Clause
"""Robot files that are no files, too large, unreadable or hostile are refused in a moment."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
import surefoot
from robot_edits import EditedRobot
from surefoot import Error

BOMB = '<!DOCTYPE r [<!ENTITY a0 "lol">{}]><robot name="r">&a9;</robot>'
BOMB = BOMB.format("".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 10)))
NOBODY = 65534


def folder(path: Path) -> None:
    path.mkdir()


def pipe(path: Path) -> None:
    os.mkfifo(path)


def empty(path: Path) -> None:
    path.write_bytes(b"")


def gigabyte(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(1 << 30)  # a hole: it takes no space


def loop(path: Path) -> None:
    path.symlink_to(path.with_suffix(".other"))
    path.with_suffix(".other").symlink_to(path)


def binary(path: Path) -> None:
    path.write_bytes(bytes(range(256)) * 40)


def device(path: Path) -> None:
    path.symlink_to("/dev/zero")


BAD: list[tuple[Callable[[Path], None], str]] = [
    (folder, "folder"),
    (pipe, "pipe or a device"),
    (device, "pipe or a device"),
    (gigabyte, "1024 MB"),
    (loop, "symbolic links"),
    (empty, ""),
    (binary, ""),
]


@pytest.fixture(params=["urdf", "toml", "srdf", "robot"])
def load(request, tmp_path: Path):
    """Return the path of one file of a robot, and a function that loads the robot."""
    robot, kind = EditedRobot(tmp_path), request.param
    robot.toml = robot.toml.replace("go1_description/srdf/go1.srdf", "my.srdf")
    files = robot.write()
    text = files["config"].read_text()
    files["config"].write_text(text.replace(f"{robot.description.mesh_root}/robots/", ""))
    (tmp_path / "my.srdf").write_bytes(robot.description.srdf.read_bytes())
    path = tmp_path / f"my.{kind}"
    if kind == "robot":
        surefoot.load_robot("go1").save(str(path))
        return path, lambda: surefoot.Robot.load(str(path))
    return path, lambda: surefoot.load_robot(**files)


@pytest.mark.parametrize(("make", "words"), BAD, ids=[make.__name__ for make, _ in BAD])
def test_bad_file_is_refused_at_once_with_its_path(load, make, words: str) -> None:
    path, load_it = load
    load_it()
    path.unlink()
    make(path)
    begin = time.process_time()
    with pytest.raises(Error) as caught:
        load_it()
    assert path.name in str(caught.value)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)
    assert time.process_time() - begin < 2.0


@contextmanager
def as_nobody() -> Iterator[None]:
    """Give up the rights of root, which may read everything, for a moment."""
    root = os.geteuid() == 0
    if root:
        os.seteuid(NOBODY)
    try:
        yield
    finally:
        if root:
            os.seteuid(0)


def test_file_without_read_permission_is_refused_with_its_path(load) -> None:
    path, load_it = load
    path.chmod(0)
    with as_nobody(), pytest.raises(Error, match=rf"{path.stem}.*Permission denied"):
        load_it()


@pytest.mark.parametrize("kind", ["urdf", "srdf"])
def test_entity_bomb_is_refused(tmp_path: Path, kind: str) -> None:
    robot = EditedRobot(tmp_path)
    files = robot.write()
    if kind == "srdf":
        text = files["config"].read_text()
        end = "robots/go1_description/srdf/go1.srdf"
        old = f"{robot.description.mesh_root}/{end}"
        assert old in text
        files["config"].write_text(text.replace(old, "my.srdf"))
    (tmp_path / f"my.{kind}").write_text(BOMB)
    with pytest.raises(Error, match=rf"my\.{kind}': got <!DOCTYPE r>, expected no document type"):
        surefoot.load_robot(**files)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<mujoco/>", "got <mujoco>, expected <robot>"),
        ("<sdf/>", "got <sdf>, expected <robot>"),
        ("<robot>" * 20000, "not a URDF"),
        ('<?xml version="1.0" encoding="klingon"?><robot/>', "not a URDF"),
        ("<robot name='x'/>", "got no <link>"),
        ('<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro/></robot>', "run xacro"),
    ],
)
def test_other_xml_is_refused(tmp_path: Path, text: str, words: str) -> None:
    files = EditedRobot(tmp_path).write()
    files["urdf"].write_text(text)
    with pytest.raises(Error) as caught:
        surefoot.load_robot(**files)
    assert words in str(caught.value)


def test_toml_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    files = EditedRobot(tmp_path).write()
    files["config"].write_bytes(b"\xef\xbb\xbf" + files["config"].read_bytes())
    assert surefoot.load_robot(**files).name == "go1"
