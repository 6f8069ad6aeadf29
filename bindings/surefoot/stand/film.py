"""Film of a run in real time."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from surefoot._core import LowCmd
from surefoot.sim import Plant, Renderer
from surefoot.stand.simulation_log import SimulationLog
from surefoot.stand.simulation_loop import Progress, make_plant

# The numbers are chosen: the film has only a few MB, and a person can follow it.
WIDTH, HEIGHT = 480, 360  # [px] size of the film
FRAME_PERIOD = 0.08  # [s] time between frames
PUSH_FRAME_PERIOD = 0.03  # [s] time between frames while a push acts
MAX_FRAMES = 250  # largest number of evenly spaced frames; longer runs get fewer per second
END_PAUSE_MS = 800  # [ms] pause before the film repeats
CAPTION_TIME = 0.8  # [s] time for which the caption of a push stays after the push
_INK, _RED = (40, 46, 54), (190, 30, 30)


def write_film(log: SimulationLog, path: Path, progress: Progress | None = None) -> None:
    """Write a run as an animated WebP.

    The plant replays the run from its recorded commands: the same seed and the same commands give
    the same motion. Rendering therefore does not disturb the timing of the run itself.

    Args:
        log: Log of the run.
        path: Path of the film.
        progress: Function that is called after every frame.
    """
    ticks = frame_ticks(log)
    pictures = []
    for k, picture in enumerate(_frames(log, set(ticks))):
        pictures.append(picture)
        if progress is not None:
            progress("film", k + 1, len(ticks))
    durations = np.diff([*ticks, len(log.time)]) * (1000.0 / log.rate)
    save_film(pictures, durations, path)


def save_film(pictures: list[Image.Image], durations: np.ndarray, path: Path) -> None:
    """Write pictures as an animated WebP that repeats endlessly.

    Args:
        pictures: Frames of the film.
        durations: Time for which each frame is shown [ms]; END_PAUSE_MS is added to the last.
        path: Path of the film.
    """
    durations[-1] += END_PAUSE_MS
    first, *rest = pictures
    first.save(
        path,
        save_all=True,
        append_images=rest,
        duration=np.rint(durations).astype(int).tolist(),
        loop=0,
        quality=75,
        method=3,
    )


def frame_ticks(log: SimulationLog) -> list[int]:
    """Return the ticks to render: evenly spaced ones, and up to 10 more while each push acts."""
    coarse = max(FRAME_PERIOD, log.duration / MAX_FRAMES)
    fine = [
        np.arange(push.time + PUSH_FRAME_PERIOD / 2, push.time + push.duration, PUSH_FRAME_PERIOD)[
            :10
        ]
        for push in log.pushes
    ]
    times = np.concatenate([np.arange(0.0, log.duration, coarse), *fine])
    ticks = np.unique(np.rint(times * log.rate).astype(int))
    return [int(k) for k in ticks if k < len(log.time)]


def replay_run(log: SimulationLog) -> Iterator[tuple[int, Plant]]:
    """Replay a run from its commands.

    Yields the number of each tick, and the plant in its state before the step of that tick.
    """
    plant = make_plant(log.settings)
    plant.reset()
    for k, command in enumerate(log.commands):
        yield k, plant
        plant.step(LowCmd.from_bytes(command.tobytes()))


def _frames(log: SimulationLog, drawn_ticks: set[int]) -> Iterator[Image.Image]:
    renderer: Renderer | None = None
    try:
        for k, plant in replay_run(log):
            if renderer is None:
                renderer = Renderer(plant, WIDTH, HEIGHT)
            if k in drawn_ticks:
                yield _captioned_frame(renderer.frame(), log, float(log.time[k]))
    finally:
        if renderer is not None:
            renderer.close()


def _captioned_frame(pixels: np.ndarray, log: SimulationLog, time: float) -> Image.Image:
    picture = Image.fromarray(pixels)
    draw = ImageDraw.Draw(picture)
    font = ImageFont.load_default(size=15)
    draw.text((12, 10), f"{log.robot.name}   {time:5.2f} s", fill=_INK, font=font)
    for push in log.pushes:
        if push.time <= time < push.time + push.duration + CAPTION_TIME:
            name = push.direction if isinstance(push.direction, str) else f"{push.direction:g} deg"
            text = f"push {name} {push.impulse:.1f} N.s"
            draw.text((WIDTH - 12, 10), text, fill=_RED, font=font, anchor="ra")
    return picture
