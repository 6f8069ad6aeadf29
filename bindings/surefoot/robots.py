"""Robots by name, or from a URDF and a TOML of your own."""

from __future__ import annotations

import importlib.metadata
import tomllib
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import numpy as np

from surefoot._core import Error, Gains, Robot, RobotConfig, set_gain

_KINDS = ("hip", "thigh", "calf")
_KEYS: dict[str, set[str]] = {
    "robot": {"name", "urdf", "srdf", "joints", "standing", "friction"},
    "feet": {"frames", "radius"},
    "imu": {"frame", "position", "quaternion"},
    "limits": set(_KINDS),
    "motors": {"armature", "corner_fraction"},
    "simulation": {"joint_friction", "joint_damping", "foot_force_est"},
    "gains": set(),  # checked by set_gain, which knows the names
}
_REQUIRED = {
    "robot": {"name", "joints", "standing"},
    "feet": {"frames", "radius"},
    "motors": {"armature", "corner_fraction"},
}


@dataclass(frozen=True)
class RobotDescription:
    """The files and the parsed TOML that a robot is built from.

    Attributes:
        name: One word.
        urdf: Path of the URDF.
        srdf: Path of the SRDF, or None.
        mesh_root: Folder that ``package://example-robot-data/`` paths start from.
        table: The TOML, checked: every key is known.
    """

    name: str
    urdf: Path
    srdf: Path | None
    mesh_root: Path
    table: dict[str, Any]


def available_robots() -> list[str]:
    """List the robots that load_robot() knows by name."""
    return sorted(path.stem for path in _models_folder().glob("*.toml"))


def load_robot(
    name: str | None = None, *, urdf: str | Path | None = None, config: str | Path | None = None
) -> Robot:
    """Load a robot.

    Args:
        name: One of available_robots(); needs the example-robot-data package (extra ``sim``).
        urdf: Or: the path of a URDF ...
        config: ... with the path of a TOML that says what the URDF does not (see models/).

    Returns:
        The robot; armature, limits and IMU mount are in it.

    Raises:
        Error: Unknown name, missing file, joint or frame, a key that does not exist.
    """
    return build_robot(describe_robot(name, urdf=urdf, config=config))


def load_gains(path: str | Path, start: Gains | None = None) -> Gains:
    """Read gains from a TOML file with a ``[gains]`` table (or plain keys).

    Args:
        path: The file.
        start: Gains that keep their value where the file is silent; library defaults if None.

    Raises:
        Error: A key that is no gain, a value that is no number or out of range.
    """
    table = _read_toml(Path(path))
    gains = start.__copy__() if start is not None else Gains()
    rows = table["gains"] if set(table) == {"gains"} else table
    if not isinstance(rows, dict):
        raise Error(f"{path}: 'gains' is {rows!r}, expected a table of names and numbers")
    _apply_gains(gains, rows, str(path))
    return gains


def describe_robot(
    name: str | None = None, *, urdf: str | Path | None = None, config: str | Path | None = None
) -> RobotDescription:
    """Find a robot's files and check its TOML, without building the model; raises Error."""
    if name is not None:
        toml = _models_folder() / f"{name}.toml"
        if name not in available_robots():
            raise Error(
                f"unknown robot: got '{name}'{_suggest(name, available_robots())}; "
                f"valid names: {', '.join(available_robots())}"
            )
        table = _read_toml(toml)
        _check_table(table, str(toml))
        root = _robot_data_folder()
        robot = table["robot"]
        return RobotDescription(
            name, root / "robots" / robot["urdf"], root / "robots" / robot["srdf"], root, table
        )
    if urdf is None or config is None:
        raise Error("load_robot: give a name, or both urdf= and config=")
    table = _read_toml(Path(config))
    _check_table(table, str(config))
    path = Path(urdf)
    if not path.is_file():
        raise Error(f"URDF not found: got '{path}', expected a file")
    srdf = table["robot"].get("srdf")
    return RobotDescription(
        table["robot"]["name"], path, path.parent / srdf if srdf else None, path.parent, table
    )


def load_pinocchio_model(description: RobotDescription) -> Any:
    """Parse the URDF into a pinocchio.Model with a free-flyer root; raises Error."""
    import pinocchio

    if not description.urdf.is_file():
        raise Error(f"URDF not found: got '{description.urdf}', expected a file")
    try:
        return pinocchio.buildModelFromUrdf(
            str(description.urdf), pinocchio.JointModelFreeFlyer()
        )
    except ValueError as problem:
        raise Error(f"'{description.urdf}' is not a URDF: {problem}") from None


def build_robot(description: RobotDescription) -> Robot:
    """Build the Robot that a description describes; raises Error."""
    model = load_pinocchio_model(description)
    return Robot.from_serialized_model(
        model.saveToString(), _build_config(model, description.table)
    )


def _build_config(model: Any, table: dict[str, Any]) -> RobotConfig:
    config = RobotConfig()
    robot, feet, motors = table["robot"], table["feet"], table["motors"]
    config.name = robot["name"]
    config.joint_names = _sized(robot["joints"], 12, "robot.joints")
    config.foot_frames = _sized(feet["frames"], 4, "feet.frames")
    config.foot_radius = float(feet["radius"])
    config.friction = float(robot.get("friction", 0.6))
    config.q_standing = per_motor(robot["standing"], "robot.standing")
    config.armature = per_motor(motors["armature"], "motors.armature")
    _set_imu(config, model, table.get("imu", {}))
    _set_limits(config, model, table.get("limits", {}), float(motors["corner_fraction"]))
    gains = Gains()
    _apply_gains(gains, table.get("gains", {}), config.name)
    config.gains = gains
    return config


def _set_imu(config: RobotConfig, model: Any, imu: dict[str, Any]) -> None:
    if "frame" in imu:
        names = [frame.name for frame in model.frames]
        if imu["frame"] not in names:
            raise Error(
                f"robot '{config.name}': missing IMU frame '{imu['frame']}'"
                f"{_suggest(imu['frame'], names)}; the model has: {', '.join(names)}"
            )
        frame = model.frames[names.index(imu["frame"])]
        if frame.parentJoint != 1:
            raise Error(
                f"robot '{config.name}': IMU frame '{imu['frame']}' hangs on joint "
                f"'{model.names[frame.parentJoint]}', expected the base"
            )
        import pinocchio

        x, y, z, w = pinocchio.Quaternion(frame.placement.rotation).coeffs()
        config.p_base_imu = frame.placement.translation
        config.quat_base_imu = np.array([w, x, y, z])
    else:
        config.p_base_imu = np.array(_sized(imu.get("position", [0, 0, 0]), 3, "imu.position"))
        quaternion = imu.get("quaternion", [1, 0, 0, 0])
        config.quat_base_imu = np.array(_sized(quaternion, 4, "imu.quaternion"), dtype=float)


def _set_limits(
    config: RobotConfig, model: Any, limits: dict[str, Any], corner_fraction: float
) -> None:
    lower, upper, speed, effort = (np.zeros(12) for _ in range(4))
    for i, name in enumerate(config.joint_names):
        if not model.existJointName(name):
            names = list(model.names)[2:]
            raise Error(
                f"robot '{config.name}': missing joint '{name}' (motor {i})"
                f"{_suggest(name, names)}; the model has: {', '.join(names)}"
            )
        joint = model.joints[model.getJointId(name)]
        sdk = limits.get(_KINDS[i % 3], [-np.inf, np.inf])
        lower[i] = max(model.lowerPositionLimit[joint.idx_q], sdk[0])
        upper[i] = min(model.upperPositionLimit[joint.idx_q], sdk[1])
        speed[i] = model.velocityLimit[joint.idx_v]
        effort[i] = model.effortLimit[joint.idx_v]
    config.q_lower, config.q_upper = lower, upper
    config.dq_max, config.no_load_speed, config.tau_max = speed, speed, effort
    config.corner_speed = corner_fraction * speed


def per_motor(values: list[float], field: str) -> np.ndarray:
    """Spread (hip, thigh, calf) over the four legs; twelve values pass through."""
    if len(values) not in (3, 12):
        raise Error(f"{field}: got {len(values)} values, expected 3 (hip, thigh, calf) or 12")
    return np.array(values * (12 // len(values)), dtype=float)


def _sized(values: list[Any], size: int, field: str) -> list[Any]:
    if len(values) != size:
        raise Error(f"{field}: got {len(values)} values, expected {size}")
    return values


def _apply_gains(gains: Gains, rows: dict[str, Any], source: str) -> None:
    for name, value in rows.items():
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise Error(f"{source}: gain '{name}': got {value!r}, expected a number")
        set_gain(gains, name, float(value))
    gains.validate()


def _read_toml(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as problem:
        raise Error(f"cannot read '{path}': {problem.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as problem:
        raise Error(f"'{path}' is not valid TOML: {problem}") from None


def _check_table(table: dict[str, Any], source: str) -> None:
    for section, rows in table.items():
        if section in _KEYS and not isinstance(rows, dict):
            raise Error(f"{source}: '{section}' is {rows!r}, expected a table [{section}]")
        if section not in _KEYS:
            raise Error(
                f"{source}: unknown section [{section}]{_suggest(section, _KEYS)}; "
                f"valid sections: {', '.join(_KEYS)}"
            )
        if section == "gains":
            continue
        for key in rows:
            if key not in _KEYS[section]:
                raise Error(
                    f"{source}: unknown key '{section}.{key}'{_suggest(key, _KEYS[section])}; "
                    f"valid keys: {', '.join(sorted(_KEYS[section]))}"
                )
    for section, keys in _REQUIRED.items():
        for key in sorted(keys):
            if key not in table.get(section, {}):
                raise Error(f"{source}: missing key '{section}.{key}'")


def _suggest(wrong: str, valid: Any) -> str:
    close = get_close_matches(wrong, list(valid), n=1)
    return f" (did you mean '{close[0]}'?)" if close else ""


def _models_folder() -> Path:
    return Path(__file__).parent / "models"


def _robot_data_folder() -> Path:
    """Find share/example-robot-data: the wheel carries data only, no loader."""
    try:
        files = importlib.metadata.files("example-robot-data") or []
    except importlib.metadata.PackageNotFoundError:
        raise Error(
            "robot data not found: loading a robot by name needs the example-robot-data package; "
            "run: pip install 'surefoot[sim]' (or bring a URDF, or a .robot file)"
        ) from None
    marker = "share/example-robot-data/robots/"
    for file in files:
        text = str(file)
        if marker in text:
            start = text.index(marker) + len(marker) - len("robots/")
            return Path(str(file.locate())[: len(str(file.locate())) - len(text) + start])
    raise Error("the example-robot-data package holds no share/example-robot-data/robots folder")
