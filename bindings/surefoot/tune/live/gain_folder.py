"""Gains to and from TOML files of one folder."""

from __future__ import annotations

from pathlib import Path

from surefoot._core import Error, Gains, Robot
from surefoot.robot.gain_files import load_gains, save_gains


class GainFolder:
    """Saves and loads by file name; the page reaches no other folder than this.

    Args:
        folder: The folder.
        robot: Whose gains; gains that a file does not name are this robot's own.

    Raises:
        Error: There is no such folder.
    """

    def __init__(self, folder: str | Path, robot: Robot) -> None:
        self._folder, self._robot = Path(folder), robot
        if not self._folder.is_dir():
            raise Error(f"--folder: got '{folder}', expected a folder that exists")

    def save(self, name: str, gains: Gains, comment: str = "") -> Path:
        """Write gains; raises Error for a name that is none, OSError if it cannot be written."""
        path = self._path(name)
        save_gains(path, gains, self._robot.name, comment)
        return path

    def load(self, name: str) -> Gains:
        """Read gains; raises Error for a name or a file that is wrong."""
        return load_gains(self._path(name), self._robot.config.gains)

    def _path(self, name: str) -> Path:
        file_name = name.strip()
        if (
            Path(file_name).name != file_name
            or not file_name.endswith(".toml")
            or file_name == ".toml"
        ):
            raise Error(f"file: got '{file_name}', expected a name such as gains.toml, no folder")
        return self._folder / file_name
