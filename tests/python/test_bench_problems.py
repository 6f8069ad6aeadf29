# SPDX-License-Identifier: BSD-3-Clause
"""Recorded QP sequences: contents, files and repeatability."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from surefoot import QpForm
from surefoot.bench.problems import load_sequence, record_problems
from surefoot.cli import main

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def pushed():
    # At this push some QPs of an a1 are elastic.
    return record_problems("a1", "push80", QpForm.CONDENSED)


def test_qps_are_grouped_by_size_with_their_ticks(pushed):
    hard, elastic = pushed
    assert (hard.name, elastic.name) == (
        "a1-push80-condensed",
        "a1-push80-condensed-elastic",
    )
    assert hard.H.shape[1:] == (12, 12) and elastic.H.shape[1:] == (26, 26)
    assert sorted([*hard.tick, *elastic.tick]) == list(range(3500))
    assert hard.meta["elastic"] is False and hard.meta["rate"] == 500.0


def test_qps_are_scaled_convex_and_have_ordered_bounds(pushed):
    for s in pushed:
        np.testing.assert_allclose(s.H, s.H.transpose(0, 2, 1), atol=1e-12)
        assert np.linalg.eigvalsh(s.H).min() > 1e-6
        assert (s.l <= s.u).all()
        assert np.isfinite(s.C).all() and not np.isnan(s.l).any()
    np.testing.assert_allclose(np.trace(pushed[0].H, axis1=1, axis2=2), 12.0)


def test_equal_seeds_record_equal_qps(pushed):
    again = record_problems("a1", "push80", QpForm.CONDENSED)
    for a, b in zip(pushed, again, strict=True):
        for name in ("H", "g", "C", "l", "u"):
            np.testing.assert_array_equal(getattr(a, name), getattr(b, name))


def test_the_general_form_has_equalities():
    (s,) = record_problems("a1", "quiet", QpForm.GENERAL)
    assert s.A.shape[1:] == (18, 30) and s.b.shape[1:] == (18,)


def test_three_legged_stance_unloads_one_foot():
    (s,) = record_problems("a1", "limp", QpForm.CONDENSED)
    assert len(s) == 3000
    # The force bounds of a foot in the air are l = u = 0.
    fixed = (s.l == s.u).sum(axis=1)
    assert fixed[0] == 0 and fixed[1100] > 0 and fixed[-1] == 0


def test_saved_qp_sequence_loads_unchanged(pushed, tmp_path):
    path = pushed[0].save(tmp_path)
    read = load_sequence(path)
    assert path.name == "a1-push80-condensed.npz" and read.meta == pushed[0].meta
    np.testing.assert_array_equal(read.u, pushed[0].u)
    (tmp_path / "other.npz").write_bytes(b"no")
    with pytest.raises(surefoot.Error, match=r"other\.npz"):
        load_sequence(tmp_path / "other.npz")


def test_bench_command_exports_sequences_and_a_qpbenchmark_set(tmp_path, capsys):
    words = ["bench", "--robot", "a1", "--scenario", "quiet", "--export"]
    assert main([*words, str(tmp_path / "all")]) == 0
    assert sorted(p.name for p in (tmp_path / "all").iterdir()) == [
        "a1-quiet-condensed.npz",
        "a1-quiet-general.npz",
    ]
    assert main([*words, str(tmp_path / "one"), "--form", "general"]) == 0
    assert [p.name for p in (tmp_path / "one").iterdir()] == ["a1-quiet-general.npz"]
    assert main([*words, str(tmp_path / "few"), "--qpbenchmark"]) == 0
    assert (tmp_path / "few" / "surefoot_wbc.py").exists()
    files = sorted((tmp_path / "few" / "data").glob("*.npz"))
    assert len(files) == 80
    first = np.load(files[0])
    assert first["P"].shape == (12, 12) and first["G"].shape[0] == first["h"].shape[0]
    with pytest.raises(ValueError):
        _ = first["lb"]  # stored as None: qpsolvers then applies no bound


def test_unknown_scenario_is_refused():
    with pytest.raises(surefoot.Error, match="got 'dance', expected one of quiet"):
        record_problems("go1", "dance", QpForm.CONDENSED)
