# SPDX-License-Identifier: BSD-3-Clause
"""Run the fenced code blocks of Markdown pages, as a reader would.

    python docs/tools/run_blocks.py README.md docs/tutorials/first-stand.md
    python docs/tools/run_blocks.py            # all pages

Each page gets an empty folder with links to the entries of the repository. Its blocks run there in
order: `sh` by bash, `python` in one interpreter for the page. `cpp` is compiled without linking,
`toml` is parsed. A block whose first line is a comment with a file name (`# my.toml`,
`// stand.cpp`) is also written to that file; `cmake` must have one. The words after the language
of a fence change this, and the rendered page does not show them:

    no-run: needs a robot       not run; at most MAX_NO_RUN blocks of all pages say so
    no-run: long                not run
    background: TEXT            sh: start it, go on when it has printed TEXT, stop it at the end
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from block_runner import BlockError, PageRunner
from fenced_blocks import REASONS, Block, page_paths, read_blocks

MAX_NO_RUN = 10


def run_page(page: Path) -> list[Block]:
    """Run the blocks of a page; return those that are marked as not to be run.

    Raises:
        BlockError: A block failed, or is written in a way that cannot be run.
    """
    blocks = read_blocks(page)
    with tempfile.TemporaryDirectory(prefix="surefoot-docs-") as folder:
        with PageRunner(Path(folder)) as runner:
            for block in blocks:
                if block.no_run not in REASONS:
                    runner.run(block)
    return [block for block in blocks if block.no_run]


def main() -> int:
    """Run the pages on the command line; print one line for each failure; return the status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pages", nargs="*", type=Path, help="Markdown files; default: all pages")
    arguments = parser.parse_args()
    pages = [page.resolve() for page in arguments.pages] or page_paths()
    failures = 0
    not_run = []
    for page in pages:
        try:
            not_run += run_page(page)
        except BlockError as error:
            print(error, flush=True)
            failures += 1
    for block in not_run:
        print(f"not run: {block.where}: {block.no_run}")
    print(f"{len(pages)} pages, {failures} failed; {len(not_run)} of {MAX_NO_RUN} blocks not run")
    return 1 if failures or len(not_run) > MAX_NO_RUN else 0


if __name__ == "__main__":
    sys.exit(main())
