"""A fault: where it takes hold of what goes to and fro between robot and supervisor."""

from __future__ import annotations

from surefoot._core import LowCmd, LowState, Robot, Supervisor, SupervisorOptions
from surefoot.geometry.rotations import Array
from surefoot.sim import Plant, PlantSettings


class Fault:
    """Nothing goes wrong: every hook leaves things as they are.

    k counts control periods since the fault began; hooks with a k are called only from then on.

    Attributes:
        from_start: It is there before the robot is armed, and not from a moment in a mode.
        uses_frames: Reports and commands travel as frames through a UdpLink.
    """

    from_start = False
    uses_frames = False

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the plant's settings."""
        return settings

    def assumed_robot(self, robot: Robot) -> Robot:
        """Return what the supervisor takes the robot for."""
        return robot

    def tick0(self, onset: int) -> int | None:
        """Return LowState.tick of the first report, from that at the fault's begin if that is 0."""
        return None

    def set_options(self, options: SupervisorOptions) -> None:
        """Change the supervisor's options, in place."""

    def start(self, plant: Plant, lying: Array) -> LowState:
        """Put the robot where it is at first, and return its first report.

        Args:
            plant: The robot.
            lying: MuJoCo's qpos of a robot that lies at rest.
        """
        return plant.reset_lying_at(lying)

    def prepare(self, supervisor: Supervisor) -> None:
        """Do what must be done before the first report."""

    def begin(self, plant: Plant) -> None:
        """Do what is done once as it begins."""

    def loop_runs(self, k: int) -> bool:
        """Return whether the control loop comes to its turn."""
        return True

    def update_before(self, supervisor: Supervisor) -> None:
        """Do what is done in every period until it begins."""

    def change_state(self, state: LowState, k: int) -> None:
        """Change a report, in place."""

    def change_frame(self, frame: bytes, k: int) -> list[bytes]:
        """Return the datagrams that arrive in place of a report's frame."""
        return [frame]

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Do what an operator does, before the tick."""

    def change_command(self, command: LowCmd, k: int) -> None:
        """Change what reaches the motors, in place."""

    def is_observable(self, plant: Plant) -> bool:
        """Return whether it is there to be seen; from the first such period times count."""
        return True

    def problems(self) -> list[str]:
        """Return what this fault itself found to be not as it should be."""
        return []


class CombinedFault(Fault):
    """Several faults at once.

    Args:
        faults: In the order in which they take hold.
    """

    def __init__(self, *faults: Fault) -> None:
        self._faults = faults
        self.uses_frames = any(fault.uses_frames for fault in faults)
        self.from_start = any(fault.from_start for fault in faults)

    def assumed_robot(self, robot: Robot) -> Robot:
        """Return what it is taken for after all of them."""
        for fault in self._faults:
            robot = fault.assumed_robot(robot)
        return robot

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the settings after all of them."""
        for fault in self._faults:
            settings = fault.plant_settings(settings)
        return settings

    def begin(self, plant: Plant) -> None:
        """Begin all."""
        for fault in self._faults:
            fault.begin(plant)

    def change_state(self, state: LowState, k: int) -> None:
        """Change a report by all of them."""
        for fault in self._faults:
            fault.change_state(state, k)

    def change_command(self, command: LowCmd, k: int) -> None:
        """Change a command by all of them."""
        for fault in self._faults:
            fault.change_command(command, k)
