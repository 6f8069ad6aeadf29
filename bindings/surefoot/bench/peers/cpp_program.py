"""Workers in C++, compiled when they are first wanted and kept."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from surefoot.bench.peers.options import PeerError, PeerOptions
from surefoot.files.atomic_write import atomic_path

SOURCE_FOLDER = Path(__file__).parent / "cpp"
# One compiler and one set of flags for every side; the wheels are built without -march as well.
FLAGS = ["-std=c++17", "-O3", "-DNDEBUG"]
# What Pinocchio's own CMake targets define: its types depend on it.
PINOCCHIO_DEFINES = [
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION",
]
BUILD_TIMEOUT = 600.0  # [s]


@dataclass(frozen=True)
class CppProgram:
    """What is compiled.

    Attributes:
        source: A file in cpp/.
        libraries: To link, without lib and .so.
    """

    source: str
    libraries: tuple[str, ...]

    def build(self, prefixes: Iterable[Path], options: PeerOptions) -> Path:
        """Compile it against what is in include and lib of the prefixes; return the executable.

        Raises:
            PeerError: There is no g++, or it would not.
        """
        compiler = shutil.which("g++") or shutil.which("c++")
        if compiler is None:
            raise PeerError("could not be compiled: no g++ was found")
        words = [compiler, *FLAGS, *PINOCCHIO_DEFINES, str(SOURCE_FOLDER / self.source)]
        for prefix in prefixes:
            words += ["-isystem", str(prefix / "include"), f"-L{prefix / 'lib'}"]
            words += ["-isystem", str(prefix / "include" / "eigen3")]
            words += [f"-Wl,-rpath,{prefix / 'lib'}"]
        words += [f"-l{library}" for library in self.libraries]
        out = (
            options.folder.absolute()
            / "compiled"
            / f"{Path(self.source).stem}-{_build_hash(words)}"
        )
        if out.exists():
            return out
        options.report_progress(f"peers: compiling {self.source}")
        out.parent.mkdir(parents=True, exist_ok=True)
        _compile(words, out)
        return out


def _build_hash(words: list[str]) -> str:
    """Return what changes when sources, command, compiler or our headers do."""
    key = hashlib.sha256("\0".join(words).encode())
    headers = Path(__file__).parents[2] / "include" / "surefoot"
    for file in [*sorted(SOURCE_FOLDER.iterdir()), *sorted(headers.glob("*.hpp"))]:
        key.update(file.read_bytes())
    key.update(_run_command([words[0], "--version"]).stdout)
    return key.hexdigest()[:16]


def _compile(words: list[str], out: Path) -> None:
    with atomic_path(out) as partial_file:  # what is interrupted must not be taken for complete
        process = _run_command([*words, "-o", str(partial_file)])
        if process.returncode != 0:
            lines = process.stderr.decode(errors="replace").splitlines()
            error_lines = [line for line in lines if "error" in line] or lines or ["without a word"]
            raise PeerError(f"could not be compiled: {error_lines[0].strip()}")


def _run_command(words: list[str]) -> subprocess.CompletedProcess[bytes]:
    try:
        return subprocess.run(
            words,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=BUILD_TIMEOUT,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as problem:
        raise PeerError(f"could not be compiled: {problem}") from None
