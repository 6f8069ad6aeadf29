"""TOML files of gains in one folder."""

from __future__ import annotations

from pathlib import Path

from surefoot._core import Error, Gains, Robot
from surefoot.robot.gain_files import load_gains, save_gains


class GainFolder:
    """Folder in which the page saves and loads gains; the page can access no other folder.

    Args:
        folder: The folder.
        robot: The robot. A gain that a file does not name has the robot's own value.

    Raises:
        Error: The folder does not exist.
    """

    def __init__(self, folder: str | Path, robot: Robot) -> None:
        self._folder, self._robot = Path(folder), robot
        if not self._folder.is_dir():
            raise Error(f"--folder: got '{folder}', expected an existing folder")

    def save(self, name: str, gains: Gains, comment: str = "") -> Path:
        """Write gains to a file and return its path.

        Raises:
            Error: The name is invalid.
            OSError: The file cannot be written.
        """
        path = self._path(name)
        save_gains(path, gains, self._robot.name, comment)
        return path

    def load(self, name: str) -> Gains:
        """Return the gains in a file; raise Error if the name or the file is invalid."""
        return load_gains(self._path(name), self._robot.config.gains)

    def _path(self, name: str) -> Path:
        file_name = name.strip()
        if (
            Path(file_name).name != file_name
            or not file_name.endswith(".toml")
            or file_name == ".toml"
        ):
            raise Error(
                f"file: got '{file_name}', expected a name such as gains.toml, without folder"
            )
        return self._folder / file_name
