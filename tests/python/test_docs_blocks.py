# SPDX-License-Identifier: BSD-3-Clause
"""The code blocks of README, CONTRIBUTING and docs run; docs/tools/run_blocks.py says how."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "docs" / "tools"))

from fenced_blocks import page_paths, read_blocks
from run_blocks import MAX_NO_RUN, BlockError, run_page

PAGES = [page for page in page_paths() if read_blocks(page)]


def _marked(page: Path) -> object:
    """A page that starts a virtual robot keeps real time; the others simulate for some seconds."""
    in_real_time = any(block.background for block in read_blocks(page))
    mark = pytest.mark.real_time if in_real_time else pytest.mark.slow
    return pytest.param(page, marks=mark, id=str(page.relative_to(ROOT)))


@pytest.mark.parametrize("page", [_marked(page) for page in PAGES])
def test_the_blocks_of_a_page_run(page: Path) -> None:
    run_page(page)


def test_at_most_ten_blocks_of_all_pages_are_not_run() -> None:
    not_run = [block.where for page in PAGES for block in read_blocks(page) if block.no_run]
    print(f"{len(not_run)} blocks are not run: {', '.join(not_run)}")
    assert len(not_run) <= MAX_NO_RUN


@pytest.mark.parametrize(
    ("block", "reason"),
    [
        ("```python\n1 / 0\n```", "python: ZeroDivisionError: division by zero"),
        ("```python\nimport sys\nsys.exit(3)\n```", "python: SystemExit: 3"),
        ("```sh\nsurefoot stand --robot go9\n```", "sh ended with status 2: surefoot: error"),
        ("```sh\nfalse | true\n```", "sh ended with status 1"),
        ("```cpp\nint main() { return x; }\n```", "cpp ended with status 1"),
        ("```toml\na = \n```", "toml: Invalid value"),
        ("```cmake\nproject(a)\n```", "cmake needs a first line"),
        ("```sh no-run: it fails\ntrue\n```", "unknown option 'no-run: it fails'"),
        ("```sh background: ready\ntrue\n```", "sh did not print 'ready'"),
    ],
)
def test_a_block_that_fails_is_named_in_one_line(tmp_path: Path, block: str, reason: str) -> None:
    page = tmp_path / "page.md"
    page.write_text(f"# Page\n\n{block}\n")
    with pytest.raises(BlockError) as error:
        run_page(page)
    text = str(error.value)
    assert text.startswith(f"{page}:3: {reason}") and "\n" not in text


def test_command_ends_with_status_1_if_a_block_fails(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("# Page\n\n```sh\nfalse\n```\n")
    command = [sys.executable, str(ROOT / "docs" / "tools" / "run_blocks.py"), str(page)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 1 and done.stdout.startswith(f"{page}:3: sh ended with status 1")
