"""True motion of a walk, as the figures need it, whatever controller walks."""

from __future__ import annotations

from typing import Protocol

from surefoot.stand.simulation_log import Array


class WalkMotion(Protocol):
    """True motion of a walk; row k of every array belongs to tick k. A WalkLog is one.

    Attributes are those of WalkLog.
    """

    @property
    def rate(self) -> float: ...  # noqa: D102
    @property
    def weight(self) -> float: ...  # noqa: D102
    @property
    def ground_normal(self) -> Array: ...  # noqa: D102
    @property
    def q_true(self) -> Array: ...  # noqa: D102
    @property
    def v_true(self) -> Array: ...  # noqa: D102
    @property
    def com_velocity(self) -> Array: ...  # noqa: D102
    @property
    def normal_forces(self) -> Array: ...  # noqa: D102
    @property
    def slip_velocity(self) -> Array: ...  # noqa: D102
    @property
    def commanded(self) -> Array: ...  # noqa: D102
    @property
    def body_reference(self) -> Array: ...  # noqa: D102
    @property
    def tau(self) -> Array: ...  # noqa: D102
    @property
    def dq(self) -> Array: ...  # noqa: D102
