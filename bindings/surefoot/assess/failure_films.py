"""Films of failures: runs the worst pushes and the first failed stands again, with a renderer."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from surefoot._core import Error
from surefoot.assess import plan
from surefoot.assess.checked_controller import ControllerFailure
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_score import CRITERIA, UnitResults
from surefoot.assess.robot_source import RobotSource
from surefoot.assess.settings import AssessSettings
from surefoot.assess.sweep import rows_to_sweep
from surefoot.assess.work_units import Heartbeat, PushUnit, StandUnit
from surefoot.assess.worker import WorkItem
from surefoot.assess.worker_pool import run_work
from surefoot.geometry.rotations import Array
from surefoot.sim import Plant

# Chosen for the size of a report; `surefoot stand` has the same FRAME_PERIOD.
MAX_FILMS = 6  # largest number of films in a report
FRAME_PERIOD = 0.08  # [s] time between frames
WIDTH, HEIGHT = 480, 360  # [px]


@dataclass(frozen=True)
class FilmUnit:
    """A run to be filmed.

    Attributes:
        unit: Unit that contains the failed run.
        level: Impulse of the failed push in percent of the push limit; unused for a stand.
        file: Path of the film.
        caption: Caption of the film.
    """

    unit: PushUnit | StandUnit
    level: float
    file: str
    caption: str
    # Chosen: rendering without a graphics card is slow.
    deadline_factor: ClassVar[float] = 20.0

    @property
    def key(self) -> str:
        """Name of the unit in the results of run_work()."""
        return f"film | {self.caption}"

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Run the unit again and write its film.

        Returns:
            {"film": file name}, or {"broken": reason} if rendering fails.
        """
        try:
            film = _FilmRecorder()
            with suppress(ControllerFailure):  # the film shows the run until this failure
                if isinstance(self.unit, PushUnit):
                    self.unit.simulate(source, controller_under_test, self.level, film.on_tick)
                else:
                    self.unit.simulate(source, controller_under_test, film.on_tick)
            film.save(Path(self.file))
        except Exception as problem:
            # Graphics drivers raise errors of many types; the report must not fail because of them.
            return {"broken": f"no film: {type(problem).__name__}: {problem}"}
        return {"film": Path(self.file).name}


class _FilmRecorder:
    """Renders a frame every FRAME_PERIOD and writes the film."""

    def __init__(self) -> None:
        self._frames: list[Array] = []
        self._renderer: Any = None

    def on_tick(self, plant: Plant, tick: int) -> None:
        if tick % round(FRAME_PERIOD * plant.settings.control_rate):
            return
        if self._renderer is None:
            from surefoot.sim import Renderer

            self._renderer = Renderer(plant, WIDTH, HEIGHT)
        self._frames.append(self._renderer.frame())

    def save(self, path: Path) -> None:
        from PIL import Image

        from surefoot.stand.film import save_film

        if self._renderer is None:
            raise Error("the controller failed before the first frame; expected at least one tick")
        self._renderer.close()
        pictures = [Image.fromarray(picture) for picture in self._frames]
        save_film(pictures, np.full(len(pictures), 1000.0 * FRAME_PERIOD), path)


def make_films(
    settings: AssessSettings, limits: PushLimits, results: UnitResults, folder: Path
) -> list[dict[str, str]]:
    """Film the failures of the controller under test.

    Args:
        settings: Settings of the assessment.
        limits: Push limits of the robot.
        results: Results of the controller's units, by unit key.
        folder: Folder of the report; created if missing.

    Returns:
        One dict per film, at most MAX_FILMS. Key "caption": the caption. Key "film": the file name;
        if there is no film, key "broken" instead: the reason.
    """
    folder.mkdir(parents=True, exist_ok=True)
    units = list(films_of_failures(settings, limits, results, folder))[:MAX_FILMS]
    work_items = [WorkItem(unit, settings.controller_under_test) for unit in units]
    film_results = {
        work.unit.key: result
        for work, result in run_work(work_items, settings.robot, settings.jobs, settings.deadline)
    }
    kept_keys = ("film", "broken")
    return [
        {
            "caption": unit.caption,
            **{k: v for k, v in film_results[unit.key].items() if k in kept_keys},
        }
        for unit in units
    ]


def films_of_failures(
    settings: AssessSettings, limits: PushLimits, results: UnitResults, folder: Path
) -> Iterator[FilmUnit]:
    """Yield the worst failed push of each criterion, then the first failed stand per condition."""
    pushes = [u for u in plan.push_units(settings.stand_card, limits) if "rows" in results[u.key]]
    summary_units = [
        unit
        for unit in pushes
        if (unit.duration, unit.push_height) == settings.stand_card.summary_push
    ]
    for kind, attribute in CRITERIA.items():
        if not summary_units:
            break
        sweeps = [(rows_to_sweep(results[unit.key]["rows"]), unit) for unit in summary_units]
        worst, unit = min(sweeps, key=lambda pair: pair[0].largest_passed(attribute))
        failed_levels = [
            level for level in worst.outcomes if level > worst.largest_passed(attribute)
        ]
        if failed_levels:
            words = (
                f"{unit.direction_deg:g} deg, {min(failed_levels):g} % of the push limit, "
                f"seed {unit.seed}"
            )
            file = str(folder / f"film_{kind}.webp")
            yield FilmUnit(unit, min(failed_levels), file, f"worst failed push ({kind}): {words}")
    for number, condition in enumerate(settings.stand_card.conditions):
        for stand in plan.stand_units(settings.stand_card, condition):
            if results[stand.key].get("passed") is False:
                words = f"{condition.name}, heading {stand.heading:g} deg, seed {stand.seed}"
                file = str(folder / f"film_condition_{number}.webp")
                yield FilmUnit(stand, 0.0, file, f"failed stand: {words}")
                break
