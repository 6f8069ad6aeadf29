"""Films of failures: the pushes and the stands that went wrong first and worst, run once more."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from surefoot._core import Error
from surefoot.assess import plan
from surefoot.assess.condition_plant import RobotSource
from surefoot.assess.controller_check import ControllerFailure
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_score import CRITERIA, UnitResults
from surefoot.assess.settings import AssessSettings
from surefoot.assess.sweep import rows_to_sweep
from surefoot.assess.work_units import Heartbeat, PushUnit, StandUnit
from surefoot.assess.worker import WorkItem
from surefoot.assess.worker_pool import run_work
from surefoot.geometry.rotations import Array
from surefoot.sim import Plant

MAX_FILMS = 6  # films in a report
FRAME_PERIOD = 0.08  # [s] between pictures
WIDTH, HEIGHT = 480, 360


@dataclass(frozen=True)
class FilmUnit:
    """A run to be filmed.

    Attributes:
        unit: The run.
        level: Of a push, percent of its limit.
        file: Where the film goes.
        caption: In words.
    """

    unit: PushUnit | StandUnit
    level: float
    file: str
    caption: str
    deadline_factor: ClassVar[float] = 20.0

    @property
    def key(self) -> str:
        """Its name."""
        return f"film | {self.caption}"

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Run it again and draw it; what graphics cannot do is a result as well."""
        try:
            film = _FilmRecorder()
            with suppress(ControllerFailure):  # that is the failure to be shown
                if isinstance(self.unit, PushUnit):
                    self.unit.simulate(source, controller_under_test, self.level, film.on_tick)
                else:
                    self.unit.simulate(source, controller_under_test, film.on_tick)
            film.save(Path(self.file))
        except Exception as problem:
            # Graphics stacks fail in as many ways as there are drivers.
            return {"broken": f"no film: {type(problem).__name__}: {problem}"}
        return {"film": Path(self.file).name}


class _FilmRecorder:
    """Draws a picture every PERIOD."""

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
            raise Error("the controller broke before the first picture")
        self._renderer.close()
        pictures = [Image.fromarray(picture) for picture in self._frames]
        save_film(pictures, np.full(len(pictures), 1000.0 * FRAME_PERIOD), path)


def make_films(
    settings: AssessSettings, limits: PushLimits, results: UnitResults, folder: Path
) -> list[dict[str, str]]:
    """Film the failures of a contestant into a folder.

    Args:
        settings: Of the assessment.
        limits: Of the robot.
        results: What came of the contestant's units, by key.
        folder: Of the report.

    Returns:
        For each: "caption", and "film", its file's name, or "broken", why there is none.
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
    """Yield what is worth a film: the worst pushes, then the first bad stand of each condition."""
    pushes = [u for u in plan.push_units(settings.card, limits) if "rows" in results[u.key]]
    summary_units = [
        unit for unit in pushes if (unit.duration, unit.push_height) == settings.card.summary_push
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
            words = f"{unit.direction_deg:g} deg, {min(failed_levels):g} % of the limit, seed {unit.seed}"
            file = str(folder / f"film_{kind}.webp")
            yield FilmUnit(
                unit, min(failed_levels), file, f"worst push, not passed ({kind}): {words}"
            )
    for number, condition in enumerate(settings.card.conditions):
        for stand in plan.stand_units(settings.card, condition):
            if results[stand.key].get("passed") is False:
                words = f"{condition.name}, heading {stand.heading:g} deg, seed {stand.seed}"
                file = str(folder / f"film_condition_{number}.webp")
                yield FilmUnit(stand, 0.0, file, f"not passed: {words}")
                break
