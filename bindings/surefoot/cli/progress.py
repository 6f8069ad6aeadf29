"""A progress bar, for people only."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

WIDTH = 30


def progress_bar() -> Callable[[str, int, int], None] | None:
    """Return a function that draws progress on stderr, or None if no terminal is there."""
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
    """Say where the results of a long run are if it is ended by Ctrl-C."""
    try:
        yield
    except KeyboardInterrupt:
        where = f"in {store}: the same command goes on"
        kept = where if store else "lost; --store FILE would have kept them"
        print(f"surefoot: the results so far are {kept}", file=sys.stderr)
        raise
