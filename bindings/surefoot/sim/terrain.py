"""Uneven ground ahead of the robot: a platform, stairs or blocks, unseen by the controller."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from surefoot._core import Error
from surefoot.robot.setting_checks import check_number

# All lengths are chosen by hand. [m] The first edge: a b1 in its standing pose has its front feet
# 0.5 m ahead of the origin, and takes a step or two before it meets the edge.
FIRST_EDGE = 1.0
# [m] Range of the draw that is added to FIRST_EDGE for platform and stairs, so that feet meet the
# edges at all phases of a gait: longer than a stride at 0.5 m/s.
EDGE_DRAW = 0.3
WIDTH = 6.0  # [m] of platform and stairs
TOP_LENGTH = 1.5  # [m] length of a platform, and of the top of stairs: longer than a b1
STAIRS = 5  # number of steps up, and of steps down
BLOCKS_LENGTH, BLOCKS_WIDTH = 4.0, 3.0  # [m]
# [m] Side of a block: shorter than the distance between two feet, so that they stand at different
# heights.
BLOCK_SIDE = 0.25
MIN_TREAD = 0.05  # [m] with less, a foot would not fit on a tread
# [m] Largest height of a step: about the leg length of the largest robot.
MAX_HEIGHT = 0.5


@dataclass(frozen=True)
class Box:
    """A box that stands on the ground, in ground axes: x ahead, y to the left, z along the normal.

    Attributes:
        x: Centre [m].
        y: Centre [m].
        length: Full side along its heading [m].
        width: Full side across its heading [m].
        height: Height of its top above the ground [m].
        heading: Heading [rad].
    """

    x: float
    y: float
    length: float
    width: float
    height: float
    heading: float = 0.0

    @property
    def end(self) -> float:
        """Coordinate x [m] at which the line y = 0 leaves the box."""
        c, s = math.cos(self.heading), math.sin(self.heading)
        return self.x + (0.5 * self.length + self.y * s) / c

    def corners(self) -> np.ndarray:
        """Return the corners (4, 2) of the top, counter-clockwise [m]."""
        half = 0.5 * np.array([self.length, self.width])
        c, s = math.cos(self.heading), math.sin(self.heading)
        signs = np.array([[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]])
        return np.asarray([self.x, self.y] + (signs * half) @ np.array([[c, s], [-s, c]]))


@dataclass(frozen=True)
class Terrain:
    """Uneven ground ahead of the robot: at most one of platform, stairs and blocks.

    Attributes:
        step_height: Height of a platform [m], over which the robot walks up and down; 0: none.
        step_heading_deg: Angle by which the edges of the platform are turned to the left [deg]. At
            0 a robot that walks straight ahead meets them squarely.
        stairs_height: Height of each step of stairs, five up and five down [m]; 0: none.
        stairs_tread: Length of each step of the stairs [m].
        block_height: Largest height of blocks [m], which are drawn between 0 and this; 0: none.
        seed: Seed of the heights of the blocks, and of the distance of the first edge.
    """

    step_height: float = 0.0
    step_heading_deg: float = 0.0
    stairs_height: float = 0.0
    stairs_tread: float = 0.3
    block_height: float = 0.0
    seed: int = 0

    def __post_init__(self) -> None:
        heights = ("step_height", "stairs_height", "block_height")
        for name, low, high in (
            *((name, 0.0, MAX_HEIGHT) for name in heights),
            ("step_heading_deg", -45.0, 45.0),
            ("stairs_tread", MIN_TREAD, 5.0),
        ):
            check_number(f"terrain: {name}", getattr(self, name), low, high)
        given = [name for name in heights if getattr(self, name)]
        if len(given) > 1:
            raise Error(f"terrain: got {' and '.join(given)}, expected one of them")
        if self.step_heading_deg and not self.step_height:
            raise Error(
                f"terrain: got step_heading_deg {self.step_heading_deg:g} without step_height, "
                "expected both or neither"
            )
        if isinstance(self.seed, bool) or not isinstance(self.seed, int) or self.seed < 0:
            raise Error(f"terrain: seed: got {self.seed!r}, expected a whole number from 0 up")

    @property
    def is_flat(self) -> bool:
        """Whether there is neither platform nor stairs nor blocks."""
        return not (self.step_height or self.stairs_height or self.block_height)

    @property
    def end(self) -> float:
        """Distance [m] straight ahead of the origin at which flat ground begins again, or 0."""
        return max((box.end for box in self.boxes()), default=0.0)

    def boxes(self) -> list[Box]:
        """Return the boxes of the terrain. Those of stairs contain one another."""
        if self.block_height:
            return self._blocks()
        if self.step_height:
            return self._stairs(1, self.step_height, 0.0, math.radians(self.step_heading_deg))
        if self.stairs_height:
            return self._stairs(STAIRS, self.stairs_height, self.stairs_tread, 0.0)
        return []

    def heights_at(self, points: np.ndarray) -> np.ndarray:
        """Return the height (n,) above the ground plane at points (n, 2), ground axes [m]."""
        if self.is_flat:
            return np.zeros(len(points))
        x_box, y_box, length, width, height, heading = self._table
        c, s = np.cos(heading), np.sin(heading)
        x, y = points[:, 0, None] - x_box, points[:, 1, None] - y_box
        inside = np.abs(c * x + s * y) <= 0.5 * length
        inside &= np.abs(c * y - s * x) <= 0.5 * width
        return np.asarray(np.max(inside * height, axis=1))

    @cached_property
    def _table(self) -> np.ndarray:
        """(6, n) attributes of the boxes."""
        return np.array([list(vars(box).values()) for box in self.boxes()]).T

    def _stairs(self, count: int, height: float, tread: float, heading: float) -> list[Box]:
        """Return `count` boxes, the lowest first; the edge of the first one is at FIRST_EDGE."""
        edge = FIRST_EDGE + EDGE_DRAW * float(np.random.default_rng(self.seed).uniform())
        half = 0.5 * TOP_LENGTH + (count - 1) * tread
        x, y = edge + half * math.cos(heading), half * math.sin(heading)
        lengths = [2.0 * (half - k * tread) for k in range(count)]
        return [
            Box(x, y, length, WIDTH, (k + 1) * height, heading) for k, length in enumerate(lengths)
        ]

    def _blocks(self) -> list[Box]:
        rng = np.random.default_rng(self.seed)
        rows, columns = round(BLOCKS_LENGTH / BLOCK_SIDE), round(BLOCKS_WIDTH / BLOCK_SIDE)
        heights = rng.uniform(0.0, self.block_height, (rows, columns))
        return [
            Box(
                FIRST_EDGE + (row + 0.5) * BLOCK_SIDE,
                (column + 0.5) * BLOCK_SIDE - 0.5 * BLOCKS_WIDTH,
                BLOCK_SIDE,
                BLOCK_SIDE,
                float(heights[row, column]),
            )
            for row in range(rows)
            for column in range(columns)
        ]
