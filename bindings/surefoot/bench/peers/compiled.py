"""Workers in C++, compiled when they are first wanted and kept."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from surefoot.bench.peers.options import PeerOptions, PeerProblem
from surefoot.whole_file import whole_place

SOURCES = Path(__file__).parent / "cpp"
# One compiler and one set of flags for every side; the wheels are built without -march as well.
FLAGS = ["-std=c++17", "-O3", "-DNDEBUG"]
# What Pinocchio's own CMake targets define: its types depend on it.
PINOCCHIO = [
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION",
]
LONGEST_BUILD = 600.0  # [s]


@dataclass(frozen=True)
class Program:
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
            PeerProblem: There is no g++, or it would not.
        """
        compiler = shutil.which("g++") or shutil.which("c++")
        if compiler is None:
            raise PeerProblem("could not be compiled: no g++ was found")
        words = [compiler, *FLAGS, *PINOCCHIO, str(SOURCES / self.source)]
        for prefix in prefixes:
            words += ["-isystem", str(prefix / "include"), f"-L{prefix / 'lib'}"]
            words += ["-isystem", str(prefix / "include" / "eigen3")]
            words += [f"-Wl,-rpath,{prefix / 'lib'}"]
        words += [f"-l{library}" for library in self.libraries]
        out = options.folder.absolute() / "compiled" / f"{Path(self.source).stem}-{_key(words)}"
        if out.exists():
            return out
        options.say(f"peers: compiling {self.source}")
        out.parent.mkdir(parents=True, exist_ok=True)
        _compile(words, out)
        return out


def _key(words: list[str]) -> str:
    """Return what changes when sources, command, compiler or our headers do."""
    key = hashlib.sha256("\0".join(words).encode())
    headers = Path(__file__).parents[2] / "include" / "surefoot"
    for file in [*sorted(SOURCES.iterdir()), *sorted(headers.glob("*.hpp"))]:
        key.update(file.read_bytes())
    key.update(_run([words[0], "--version"]).stdout)
    return key.hexdigest()[:16]


def _compile(words: list[str], out: Path) -> None:
    with whole_place(out) as part:  # what is interrupted must not be taken for complete
        done = _run([*words, "-o", str(part)])
        if done.returncode != 0:
            lines = done.stderr.decode(errors="replace").splitlines()
            said = [line for line in lines if "error" in line] or lines or ["without a word"]
            raise PeerProblem(f"could not be compiled: {said[0].strip()}")


def _run(words: list[str]) -> subprocess.CompletedProcess[bytes]:
    try:
        return subprocess.run(
            words,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=LONGEST_BUILD,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as problem:
        raise PeerProblem(f"could not be compiled: {problem}") from None
