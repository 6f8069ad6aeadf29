"""Workers in C++, compiled on first use and cached."""

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
# Every implementation is compiled with the same compiler and these flags. There is no -march, as in
# the wheels.
FLAGS = ["-std=c++17", "-O3", "-DNDEBUG"]
# Definitions of Pinocchio's own CMake targets; Pinocchio's types depend on these definitions.
PINOCCHIO_DEFINES = [
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION",
]
# Chosen: compiling Pinocchio headers takes a minute or two.
BUILD_TIMEOUT = 600.0  # [s] longest time to compile a worker


@dataclass(frozen=True)
class CppProgram:
    """Source and libraries of an executable.

    Attributes:
        source: File in cpp/.
        libraries: Names of the libraries to link, without lib and .so.
    """

    source: str
    libraries: tuple[str, ...]

    def build(self, prefixes: Iterable[Path], options: PeerOptions) -> Path:
        """Compile the source with the folders include and lib of the prefixes.

        Returns:
            Path of the executable.

        Raises:
            PeerError: There is no g++, or the source does not compile.
        """
        compiler = shutil.which("g++") or shutil.which("c++")
        if compiler is None:
            raise PeerError("could not be compiled: no g++ was found")
        command_line = [compiler, *FLAGS, *PINOCCHIO_DEFINES, str(SOURCE_FOLDER / self.source)]
        for prefix in prefixes:
            command_line += ["-isystem", str(prefix / "include"), f"-L{prefix / 'lib'}"]
            command_line += ["-isystem", str(prefix / "include" / "eigen3")]
            command_line += [f"-Wl,-rpath,{prefix / 'lib'}"]
        command_line += [f"-l{library}" for library in self.libraries]
        out = (
            options.folder.absolute()
            / "compiled"
            / f"{Path(self.source).stem}-{_build_hash(command_line)}"
        )
        if out.exists():
            return out
        options.report_progress(f"peers: compiling {self.source}")
        out.parent.mkdir(parents=True, exist_ok=True)
        _compile(command_line, out)
        return out


def _build_hash(command_line: list[str]) -> str:
    """Return a hash of the sources, the command, the compiler and the headers of Surefoot."""
    key = hashlib.sha256("\0".join(command_line).encode())
    headers = Path(__file__).parents[2] / "include" / "surefoot"
    for file in [*sorted(SOURCE_FOLDER.iterdir()), *sorted(headers.glob("*.hpp"))]:
        key.update(file.read_bytes())
    key.update(_run_command([command_line[0], "--version"]).stdout)
    return key.hexdigest()[:16]


def _compile(command_line: list[str], out: Path) -> None:
    with atomic_path(out) as partial_file:  # atomic: an interrupted build must not look complete
        process = _run_command([*command_line, "-o", str(partial_file)])
        if process.returncode != 0:
            lines = process.stderr.decode(errors="replace").splitlines()
            error_lines = [line for line in lines if "error" in line] or lines or ["no error text"]
            raise PeerError(f"could not be compiled: {error_lines[0].strip()}")


def _run_command(command_line: list[str]) -> subprocess.CompletedProcess[bytes]:
    try:
        return subprocess.run(
            command_line,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=BUILD_TIMEOUT,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as problem:
        raise PeerError(f"could not be compiled: {problem}") from None
