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
from surefoot.assess.checked import Broken
from surefoot.assess.contestant import Contestant
from surefoot.assess.crew import run_all
from surefoot.assess.ground import Source
from surefoot.assess.push_limits import Limits
from surefoot.assess.push_score import KINDS, Found
from surefoot.assess.settings import AssessSettings
from surefoot.assess.sweep import from_rows
from surefoot.assess.unit import Beat, PushUnit, StandUnit
from surefoot.assess.worker import Work
from surefoot.sim import Plant
from surefoot.sim.rotations import Array

MOST = 6  # films in a report
PERIOD = 0.08  # [s] between pictures
WIDTH, HEIGHT = 480, 360


@dataclass(frozen=True)
class FilmUnit:
    """A run to be filmed.

    Attributes:
        of: The run.
        level: Of a push, percent of its limit.
        file: Where the film goes.
        caption: In words.
    """

    of: PushUnit | StandUnit
    level: float
    file: str
    caption: str
    patience: ClassVar[float] = 20.0

    @property
    def key(self) -> str:
        """Its name."""
        return f"film | {self.caption}"

    def run(self, source: Source, contestant: Contestant, beat: Beat) -> dict[str, Any]:
        """Run it again and draw it; what graphics cannot do is a result as well."""
        try:
            film = _Film()
            with suppress(Broken):  # that is the failure to be shown
                if isinstance(self.of, PushUnit):
                    self.of.play(source, contestant, self.level, film.watch)
                else:
                    self.of.play(source, contestant, film.watch)
            film.save(Path(self.file))
        except Exception as problem:
            # Graphics stacks fail in as many ways as there are drivers.
            return {"broken": f"no film: {type(problem).__name__}: {problem}"}
        return {"film": Path(self.file).name}


class _Film:
    """Draws a picture every PERIOD."""

    def __init__(self) -> None:
        self._pictures: list[Array] = []
        self._renderer: Any = None

    def watch(self, plant: Plant, tick: int) -> None:
        if tick % round(PERIOD * plant.settings.control_rate):
            return
        if self._renderer is None:
            from surefoot.sim import Renderer

            self._renderer = Renderer(plant, WIDTH, HEIGHT)
        self._pictures.append(self._renderer.frame())

    def save(self, path: Path) -> None:
        from PIL import Image

        from surefoot.stand.film import save_film

        if self._renderer is None:
            raise Error("the controller broke before the first picture")
        self._renderer.close()
        pictures = [Image.fromarray(picture) for picture in self._pictures]
        save_film(pictures, np.full(len(pictures), 1000.0 * PERIOD), path)


def make_films(
    settings: AssessSettings, limits: Limits, results: Found, folder: Path
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
    units = list(failures(settings, limits, results, folder))[:MOST]
    works = [Work(unit, settings.contestant) for unit in units]
    made = {
        work.unit.key: result
        for work, result in run_all(works, settings.robot, settings.jobs, settings.deadline)
    }
    told = ("film", "broken")
    return [
        {"caption": unit.caption, **{k: v for k, v in made[unit.key].items() if k in told}}
        for unit in units
    ]


def failures(
    settings: AssessSettings, limits: Limits, results: Found, folder: Path
) -> Iterator[FilmUnit]:
    """Yield what is worth a film: the worst pushes, then the first bad stand of each condition."""
    pushes = [u for u in plan.pushes(settings.card, limits) if "rows" in results[u.key]]
    main = [unit for unit in pushes if (unit.duration, unit.lift) == settings.card.main]
    for kind, attribute in KINDS.items():
        if not main:
            break
        sweeps = [(from_rows(results[unit.key]["rows"]), unit) for unit in main]
        found, unit = min(sweeps, key=lambda pair: pair[0].largest(attribute))
        above = [level for level in found.tried if level > found.largest(attribute)]
        if above:
            words = f"{unit.degrees:g} deg, {min(above):g} % of the limit, seed {unit.seed}"
            file = str(folder / f"film_{kind}.webp")
            yield FilmUnit(unit, min(above), file, f"worst push, not passed ({kind}): {words}")
    for number, condition in enumerate(settings.card.conditions):
        for stand in plan.stands(settings.card, condition):
            if results[stand.key].get("passed") is False:
                words = f"{condition.name}, heading {stand.heading:g} deg, seed {stand.seed}"
                file = str(folder / f"film_condition_{number}.webp")
                yield FilmUnit(stand, 0.0, file, f"not passed: {words}")
                break
