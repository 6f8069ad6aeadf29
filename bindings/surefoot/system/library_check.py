"""Checks that Python and the loader found the libraries that Surefoot was built for.

LD_LIBRARY_PATH and PYTHONPATH of a ROS or robotpkg installation often contain another Pinocchio or
numpy. The library has no version in its name, so the loader accepts any release.
"""

from __future__ import annotations

import filecmp
import importlib.metadata
import os
from importlib.util import find_spec
from pathlib import Path

_MIN_NUMPY = (1, 26)  # as in pyproject.toml
PINOCCHIO_LIBRARY = "libpinocchio_default.so"
_PACKAGE = Path(__file__).parents[1]
# Folder of the libraries of the Python package libpinocchio, beside this package.
_LIBRARY_FOLDER = _PACKAGE.parent / "cmeel.prefix" / "lib"


def check_python_packages() -> None:
    """Raise ImportError if numpy cannot be imported or is too old, or if Pinocchio is another one.

    The message says which package was found, and where.
    """
    try:
        import numpy
    except ImportError as problem:
        reason = str(problem).strip().partition("\n")[0]
        raise ImportError(
            f"numpy: cannot import '{_origin('numpy')}': {reason}, expected numpy >= 1.26 for this "
            f"Python; {_path_remedy('numpy')}"
        ) from None
    if tuple(map(int, numpy.__version__.split(".")[:2])) < _MIN_NUMPY:
        raise ImportError(
            f"numpy: got version {numpy.__version__} from '{_origin('numpy')}', expected 1.26 or "
            f"newer; {_path_remedy('numpy')}"
        )
    _check_pinocchio_package()


def explain_core_import(problem: ImportError) -> ImportError:
    """Return an ImportError of the C++ core in one line, with the library that caused it."""
    reason = " ".join(str(problem).split())
    other = _shadowing_library()
    remedy = (
        f"LD_LIBRARY_PATH loads '{other}', expected '{_LIBRARY_FOLDER / other.name}'; run: unset "
        "LD_LIBRARY_PATH"
        if other is not None
        else "expected the libraries of the package libpinocchio; run: pip install "
        "--force-reinstall surefoot"
    )
    return ImportError(f"surefoot: cannot load its C++ core ({reason}): {remedy}")


def loaded_libraries(name: str) -> list[Path]:
    """Return the files of a library that this process has loaded, without duplicates.

    Args:
        name: Name of the library's file, such as "libsurefoot.so". Nothing is found if the system
            is not Linux.
    """
    try:
        maps = Path("/proc/self/maps").read_bytes()
    except OSError:  # not Linux
        return []
    lines = [line for line in maps.splitlines() if name.encode() in line]
    return sorted({Path(os.fsdecode(line.split(maxsplit=5)[5])) for line in lines})


def check_loaded_library() -> None:
    """Raise ImportError if the loader took libpinocchio from another folder, in another build."""
    expected = _LIBRARY_FOLDER / PINOCCHIO_LIBRARY
    for path in loaded_libraries(PINOCCHIO_LIBRARY):
        if expected.is_file() and path.is_file() and not _is_same_file(path, expected):
            raise ImportError(
                f"surefoot: LD_LIBRARY_PATH loads '{path}', expected '{expected}', because another "
                "build of Pinocchio may crash; run: unset LD_LIBRARY_PATH"
            )


def _check_pinocchio_package() -> None:
    """Compare pinocchio, without importing it, with the installed package pin."""
    try:
        pin = importlib.metadata.distribution("pin")
        required = _required_version("pin")
    except importlib.metadata.PackageNotFoundError:
        return  # a robot file needs no Python package of Pinocchio
    origin = _origin("pinocchio")
    if required is not None and pin.version != required:
        raise ImportError(
            f"pinocchio: got pin {pin.version} from '{origin}', expected pin {required}; "
            f"{_path_remedy('pinocchio')}"
        )
    folder = Path(str(pin.locate_file(""))).resolve()
    if origin is not None and folder not in Path(origin).resolve().parents:
        raise ImportError(
            f"pinocchio: got '{origin}', expected that of pin {required} in '{folder}'; "
            f"{_path_remedy('pinocchio')}"
        )


def _required_version(package: str) -> str | None:
    """Return the version of a dependency that surefoot requires exactly, such as "4.1.0"."""
    for requirement in importlib.metadata.requires("surefoot") or ():
        name, _, version = requirement.partition("==")
        if name.strip() == package:
            return version.strip()
    return None


def _origin(package: str) -> str | None:
    spec = find_spec(package)
    return None if spec is None else spec.origin


def _path_remedy(package: str) -> str:
    """Return the remedy: PYTHONPATH without the folder of the package, or an installation."""
    origin = _origin(package) or ""
    for folder in os.environ.get("PYTHONPATH", "").split(os.pathsep):
        if folder and os.path.abspath(origin).startswith(os.path.abspath(folder) + os.sep):
            return f"remove '{folder}' from PYTHONPATH"
    return "run: pip install --force-reinstall surefoot"


def _shadowing_library() -> Path | None:
    """Return the first library that LD_LIBRARY_PATH puts before one of ours; None if none."""
    for folder in os.environ.get("LD_LIBRARY_PATH", "").split(os.pathsep):
        for path in sorted(Path(folder).glob("lib*.so*")) if folder else ():
            own = _LIBRARY_FOLDER / path.name
            if own.exists() and not _is_same_file(path, own):
                return path
    return None


def _is_same_file(path: Path, other: Path) -> bool:
    return path.samefile(other) or filecmp.cmp(path, other)
