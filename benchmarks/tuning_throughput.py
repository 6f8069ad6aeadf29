# SPDX-License-Identifier: BSD-3-Clause
"""Throughput of gain tuning with one core, two processes, and a Dask cluster of two workers.

    python benchmarks/tuning_throughput.py --robot go1 --rounds 5

Every round runs the same trials on each worker pool in turn. Other processes may load the machine,
so ratios compare times of the same round, and the printed values are medians over rounds. A trial
is the same as in `surefoot tune search`: estimator, QP, physics at 1 kHz, control at 500 Hz,
sensors and cost.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from statistics import median

import mujoco
from surefoot import load_robot
from surefoot.robot.gain_files import gain_values
from surefoot.sim import PlantSettings
from surefoot.tune.search.rollout import TrialJob, cached_plant, evaluate_exclusively
from surefoot.tune.search.stand_episode import StandEpisode
from surefoot.tune.search.trial_queue import TrialQueue
from surefoot.tune.search.worker_pool import DaskCluster, ProcessPool

PORT = 8796  # TCP port of the Dask scheduler
EPISODE_COUNT = 2  # number of episodes per trial


def main() -> None:
    """Measure and print the figures."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--robot", default="go1")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--trials", type=int, default=8, help="trials per round and worker pool")
    parser.add_argument("--json", metavar="FILE")
    options = parser.parse_args()
    figures = measure(options.robot, options.rounds, options.trials)
    for name, value in figures.items():
        print(f"{name:<44}{value:10.3g}")
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(figures, file, indent=2)


def measure(robot: str, rounds: int, trials: int) -> dict[str, float]:
    """Return the figures, as medians over rounds."""
    job = TrialJob(
        gain_values(load_robot(robot).config.gains),
        tuple(StandEpisode(robot, seed, PlantSettings()) for seed in range(EPISODE_COUNT)),
        ("balance",),
    )
    evaluate_exclusively(job)  # fill the cache of plants before timing
    outcomes = [evaluate_exclusively(job) for _ in range(rounds)]
    wall_times: dict[str, list[float]] = {"one": [], "two": [], "dask": []}
    with cluster() as address:
        worker_pools = {"one": ProcessPool(1), "two": ProcessPool(2), "dask": DaskCluster(address)}
        for worker_pool in worker_pools.values():
            # Untimed run, long enough that every worker builds its plants.
            _run(worker_pool, job, 4 * worker_pool.count)
        for _ in range(rounds):
            for name, worker_pool in worker_pools.items():
                wall_times[name].append(_run(worker_pool, job, trials))
        for worker_pool in worker_pools.values():
            worker_pool.close()
    pairs = zip(wall_times["one"], wall_times["two"], wall_times["dask"], strict=True)
    ratios = [(one / two, dask / two) for one, two, dask in pairs]
    return {
        "x real time, one core": median(o.simulated_time / o.cpu_time for o in outcomes),
        "ticks per second of CPU": median(o.ticks / o.cpu_time for o in outcomes),
        "physics steps per second of CPU": median(o.steps / o.cpu_time for o in outcomes),
        "of it MuJoCo's own steps": median(_physics(job) * o.steps / o.cpu_time for o in outcomes),
        "two processes, times one": median(two for two, _ in ratios),
        "Dask of two, time of two processes": median(dask for _, dask in ratios),
    }


def _run(worker_pool: ProcessPool | DaskCluster, job: TrialJob, trials: int) -> float:
    """Return the wall time of some trials on a worker pool [s]."""
    queue, done = TrialQueue(worker_pool), 0
    begin = time.monotonic()
    while done < trials:
        while len(queue) < min(worker_pool.count, trials - done):
            queue.put(done, job)
        done += len(queue.take())
    return time.monotonic() - begin


def _physics(job: TrialJob) -> float:
    """Return the CPU time [s] of one MuJoCo step, for a robot with constant joint torques."""
    plant = cached_plant(job.episodes[0])
    plant.reset()
    model, data, steps = plant.model, mujoco.MjData(plant.model), 1000
    data.qpos[:], data.qfrc_applied[:] = plant.data.qpos, plant.data.qfrc_applied
    mujoco.mj_forward(model, data)
    begin = time.process_time()
    for _ in range(steps):
        mujoco.mj_step2(model, data)
        mujoco.mj_step1(model, data)
    return (time.process_time() - begin) / steps


@contextmanager
def cluster() -> Iterator[str]:
    """Run a Dask scheduler with two workers on this machine; yield its address."""
    dask, address = [sys.executable, "-m", "dask"], f"tcp://127.0.0.1:{PORT}"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    words = ("scheduler", "--host", "127.0.0.1", "--port", str(PORT), "--no-dashboard")
    scheduler = subprocess.Popen([*dask, *words], **quiet)
    words = ("worker", address, "--nworkers", "2", "--nthreads", "1", "--no-dashboard")
    workers = subprocess.Popen([*dask, *words], **quiet)
    try:
        _wait_for(address)
        yield address
    finally:
        for process in (workers, scheduler):
            process.terminate()
            process.wait()


def _wait_for(address: str) -> None:
    import distributed

    with distributed.Client(address, timeout=30) as client:
        client.wait_for_workers(2, timeout=60)


if __name__ == "__main__":
    main()
