"""Interleaved timing: implementations compute blocks of ticks in turns, all on one processor."""

from __future__ import annotations

import gc
import os
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from surefoot.bench.peers.options import PeerError
from surefoot.bench.peers.surefoot_implementations import Implementation, Ticks


def interleave(
    implementations: dict[str, Implementation], ticks: int, block: int
) -> tuple[dict[str, Ticks], dict[str, str]]:
    """Let all implementations compute every tick, block by block in turns, after a warm-up run.

    The order of the implementations is reversed in every second round. So no implementation always
    follows the same other implementation.

    Returns:
        The ticks of each implementation that ran to the end, by name; and for each implementation
        that failed, by name, the reason of its failure.
    """
    reasons: dict[str, str] = {}
    played: dict[str, list[Ticks]] = {}
    with without_garbage_collection():
        for _ in ("warm up", "count"):
            played = {name: [] for name in implementations}
            for turn, first in enumerate(range(0, ticks, block)):
                names = list(implementations)[:: -1 if turn % 2 else 1]
                for name in names:
                    if name in reasons:
                        continue
                    try:
                        count = min(block, ticks - first)
                        played[name].append(implementations[name].run_ticks(first, count))
                    except PeerError as problem:
                        reasons[name] = str(problem)
    return {
        name: np.concatenate(blocks) for name, blocks in played.items() if name not in reasons
    }, reasons


def chosen_processor() -> int | None:
    """Return the processor on which ticks are timed; None if the system has no CPU affinity."""
    return max(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else None


@contextmanager
def one_processor() -> Iterator[None]:
    """Keep this process and its children on one processor, if the system supports CPU affinity."""
    processor = chosen_processor()
    if processor is None:
        yield
        return
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {processor})
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)


@contextmanager
def without_garbage_collection() -> Iterator[None]:
    """Disable Python's garbage collector while ticks are timed, as timeit does."""
    was_on = gc.isenabled()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()
