"""Progress bar on a terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

WIDTH = 30  # [characters] width of the bar


def progress_bar() -> Callable[[str, int, int], None] | None:
    """Return a function (label, done, total) that draws a bar on stderr.

    None: stderr is not a terminal.
    """
    if not sys.stderr.isatty():
        return None

    def draw(label: str, done: int, total: int) -> None:
        if done < total and done % max(1, total // 100) != 0:
            return
        bar = ("#" * (WIDTH * done // total)).ljust(WIDTH, ".")
        sys.stderr.write(f"\r{label:<6} {bar} {100 * done // total:3d} %")
        sys.stderr.write("\r\033[K" if done >= total else "")
        sys.stderr.flush()

    return draw


@contextmanager
def report_kept_results(store: str | None) -> Iterator[None]:
    """On Ctrl-C, print whether the results so far were kept in `store`."""
    try:
        yield
    except KeyboardInterrupt:
        where = f"in {store}: run the same command again to resume"
        kept = where if store else "lost; use --store FILE to keep them"
        print(f"surefoot: the results so far are {kept}", file=sys.stderr)
        raise
