import ctypes.util
import dataclasses
import json
import re
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image
from surefoot.stand import StandSettings, film, parse_push, parse_reference, run_stand, summarise
from surefoot.stand.report import write_report

PUSH = parse_push("lateral:20%:0.06@0.1")
REFERENCE = parse_reference("x=0.001@0.2")


@pytest.fixture(scope="module")
def log():
    return run_stand(StandSettings(duration=0.3, pushes=(PUSH,), references=(REFERENCE,)))


def test_film_replay_matches_the_run(log):
    for k, plant in film.replay_run(log):
        np.testing.assert_array_equal(plant.truth.q, log.q_true[k])
        np.testing.assert_array_equal(plant.truth.tau, log.tau[k])


def test_film_frames_are_denser_during_a_push(log):
    times = np.array(film.frame_ticks(log)) / log.rate
    pushed = (times >= PUSH.time) & (times < PUSH.time + PUSH.duration)
    assert times[0] == 0.0 and pushed.sum() >= 2
    assert np.diff(times).max() <= film.FRAME_PERIOD + 1e-9


def test_film_of_a_long_run_has_a_frame_limit(log):
    rows = np.zeros((100_000, 1))
    long = dataclasses.replace(log, time=rows[:, 0])
    assert len(film.frame_ticks(long)) <= film.MAX_FRAMES + 10


def test_stand_report_folder_contains_all_files_of_its_page(log, tmp_path, monkeypatch):
    # This test does not check the pictures, and drawing them needs a graphics library.
    monkeypatch.setattr(film, "_frames", lambda log, ticks: (blank() for _ in ticks))
    summary = summarise(log)
    command = ["surefoot", "stand", "--gains", "my gains.toml"]
    page = write_report(log, summary, tmp_path / "new" / "report", command).read_text()
    for file in re.findall(r'(?:src|href)="([^"]+)"', page):
        assert (tmp_path / "new" / "report" / file).stat().st_size > 0
    assert "Requested: x +0.001 m at 0.2 s" in page and "Reached: " in page
    assert "film.webp" in page and "stand --gains &#x27;my gains.toml&#x27;" in page
    assert all(f"<code>{name}</code>" in page for name in summary)
    written = json.loads((tmp_path / "new" / "report" / "summary.json").read_text())
    assert written == summary


def test_film_failure_keeps_the_rest_of_the_report(log, tmp_path, monkeypatch):
    def fail(*_):
        raise RuntimeError("no <graphics> here")

    monkeypatch.setattr(film, "Renderer", fail)
    page = write_report(log, summarise(log), tmp_path, ["surefoot"]).read_text()
    assert "no &lt;graphics&gt; here" in page and "film.webp" not in page
    assert (tmp_path / "pose.png").exists() and not (tmp_path / "film.webp").exists()


@pytest.mark.skipif(not ctypes.util.find_library("EGL"), reason="no EGL library")
def test_stand_command_makes_a_real_time_film(log, tmp_path):
    # A new process can choose its graphics library before it imports MuJoCo.
    line = [sys.executable, "-m", "surefoot.cli", "stand", "--duration", "0.3"]
    words = ["--push", str(PUSH), "--report", str(tmp_path)]
    done = subprocess.run([*line, *words], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")
    assert str(tmp_path / "index.html") in done.stdout
    with Image.open(tmp_path / "film.webp") as picture:
        assert picture.n_frames == len(film.frame_ticks(log))
        assert picture.size == (film.WIDTH, film.HEIGHT)
        shown = 0
        for k in range(picture.n_frames):
            picture.seek(k)
            picture.load()
            shown += picture.info["duration"]
            assert np.ptp(np.asarray(picture.convert("L"))) > 50
    assert shown == pytest.approx(1000 * log.duration + film.END_PAUSE_MS, abs=5)


def blank():
    return Image.new("RGB", (film.WIDTH, film.HEIGHT), tuple(np.random.default_rng().bytes(3)))
