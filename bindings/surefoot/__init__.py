"""Whole-body torque control for Unitree quadrupeds: LowState in, LowCmd out."""

# ruff: noqa: E402
from surefoot.system.command_process import prepare_process

prepare_process()  # first, because the imports below take half a second: Ctrl-C must work in them

from surefoot.system.library_check import (
    check_loaded_library,
    check_python_packages,
    explain_core_import,
)

check_python_packages()
try:
    from surefoot import _core
except ImportError as problem:
    raise explain_core_import(problem) from None
check_loaded_library()
from surefoot._core import *  # noqa: F403
from surefoot.robot.delay_identification import identify_delay
from surefoot.robot.gain_files import load_gains, save_gains
from surefoot.robot.loading import available_robots, load_robot

__version__ = "0.1.0"
__all__ = [
    *(name for name in dir(_core) if not name.startswith("_")),
    "available_robots",
    "identify_delay",
    "load_gains",
    "load_robot",
    "save_gains",
]

# Signatures, messages and pickles then name the public class, as in surefoot.Gains.
for _name in __all__:
    if isinstance(getattr(_core, _name, None), type):
        getattr(_core, _name).__module__ = __name__
