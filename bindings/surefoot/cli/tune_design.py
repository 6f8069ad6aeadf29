"""surefoot tune design."""

from __future__ import annotations

import argparse


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot tune design."""


def run(arguments: argparse.Namespace) -> int | None:
    """Run it; raises Error."""
    raise NotImplementedError
