# SPDX-License-Identifier: BSD-3-Clause
"""The fenced code blocks of the documentation's pages."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from markdown_it import MarkdownIt

ROOT = Path(__file__).parents[2]
RUNNABLE = ("python", "cpp", "cmake", "toml", "sh")
REASONS = ("needs a robot", "long")
FILE_NAME = re.compile(r"(?:#|//) ([\w.-]+\.(?:py|cpp|hpp|toml|txt|json|csv))\s*$")


@dataclass(frozen=True)
class Block:
    """One fenced code block.

    Attributes:
        language: First word after the fence.
        text: Code, with a newline at the end.
        page: File that contains it.
        line: Line of the page with the opening fence, from 1.
        options: Rest of the line after the language.
    """

    language: str
    text: str
    page: Path
    line: int
    options: str

    @property
    def where(self) -> str:
        """`page:line`, with the page from the root of the repository."""
        page = self.page.relative_to(ROOT) if self.page.is_relative_to(ROOT) else self.page
        return f"{page}:{self.line}"

    @property
    def no_run(self) -> str:
        """Why the block is not run; "" if it is run."""
        return self._option("no-run")

    @property
    def background(self) -> str:
        """Text that a background command prints when it is ready; "" for other blocks."""
        return self._option("background")

    @property
    def file_name(self) -> str:
        """File that the block's first line names; "" if none."""
        match = FILE_NAME.match(self.text.split("\n", 1)[0])
        return match[1] if match else ""

    def _option(self, name: str) -> str:
        return (
            self.options.removeprefix(f"{name}: ") if self.options.startswith(f"{name}: ") else ""
        )


def page_paths() -> list[Path]:
    """Return all pages with code of their own: README, CONTRIBUTING and those below docs."""
    below = sorted((ROOT / "docs").rglob("*.md"))
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *below]


def read_blocks(page: Path) -> list[Block]:
    """Return the blocks of a page that are code of a RUNNABLE language, in order."""
    blocks = []
    for token in MarkdownIt().parse(page.read_text(encoding="utf-8")):
        if token.type != "fence" or not token.map:
            continue
        language, _, options = token.info.strip().partition(" ")
        if language in RUNNABLE:
            blocks.append(Block(language, token.content, page, token.map[0] + 1, options.strip()))
    return blocks
