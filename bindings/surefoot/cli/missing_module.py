"""Message for a module that is not installed."""

from __future__ import annotations

from surefoot._core import Error


def missing_module(command: str, problem: ModuleNotFoundError, *more: str) -> Error:
    """Return an Error that tells how to install the missing module.

    Args:
        command: Subcommand that needs the module, without "surefoot".
        problem: Import error, which names the module.
        more: Extras of the package surefoot that the command needs besides "sim".
    """
    extras = ("sim", *more)
    names = " and ".join(f"'{extra}'" for extra in extras)
    return Error(
        f"module '{problem.name}' not found: surefoot {command} needs the "
        f"extra{'s' if more else ''} {names}; run: pip install 'surefoot[{','.join(extras)}]'"
    )
