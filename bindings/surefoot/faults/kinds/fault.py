"""Base class of faults: hooks between the robot (plant) and its supervisor."""

from __future__ import annotations

from surefoot._core import LowCmd, LowState, Robot, Supervisor, SupervisorOptions
from surefoot.geometry.rotations import Array
from surefoot.sim import Plant, PlantSettings


class Fault:
    """A fault with hooks that all leave the data unchanged; subclasses override some of them.

    k counts control periods since the fault began. Hooks with a k are called only from then on.

    Attributes:
        from_start: True if the fault exists before arming, instead of from a moment in a mode on.
        uses_frames: True if samples travel as frames through a UdpLink.
    """

    from_start = False
    uses_frames = False

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the settings of the plant."""
        return settings

    def assumed_robot(self, robot: Robot) -> Robot:
        """Return the robot model that the supervisor receives."""
        return robot

    def tick0(self, onset: int) -> int | None:
        """Return LowState.tick of the first sample [ms], or None for 0.

        Args:
            onset: Time from the first sample to the onset of the fault [ms].
        """
        return None

    def set_options(self, options: SupervisorOptions) -> None:
        """Change the options of the supervisor in place."""

    def start(self, plant: Plant, lying: Array) -> LowState:
        """Put the robot into its initial state and return the first sample.

        Args:
            plant: Plant of the robot.
            lying: MuJoCo qpos of the robot lying at rest.
        """
        return plant.reset_lying_at(lying)

    def prepare(self, supervisor: Supervisor) -> None:
        """Prepare the supervisor before the first sample."""

    def begin(self, plant: Plant) -> None:
        """Change the plant once at the onset."""

    def loop_runs(self, k: int) -> bool:
        """Return True if the control loop runs in period k."""
        return True

    def update_before(self, supervisor: Supervisor) -> None:
        """Call functions of the supervisor in every period before the onset."""

    def change_state(self, state: LowState, k: int) -> None:
        """Change a sample in place."""

    def change_frame(self, frame: bytes, k: int) -> list[bytes]:
        """Return the datagrams that arrive instead of a sample's frame."""
        return [frame]

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Perform operator actions before tick k."""

    def change_command(self, command: LowCmd, k: int) -> None:
        """Change the command to the motors in place."""

    def is_observable(self, plant: Plant) -> bool:
        """Return True if the fault can be observed; times count from the first such period."""
        return True

    def problems(self) -> list[str]:
        """Return the problems that the fault itself found."""
        return []


class CombinedFault(Fault):
    """Several faults at once.

    Args:
        faults: Faults, in the order in which their hooks run.
    """

    def __init__(self, *faults: Fault) -> None:
        self._faults = faults
        self.uses_frames = any(fault.uses_frames for fault in faults)
        self.from_start = any(fault.from_start for fault in faults)

    def assumed_robot(self, robot: Robot) -> Robot:
        """Return the robot model after all faults."""
        for fault in self._faults:
            robot = fault.assumed_robot(robot)
        return robot

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the plant settings after all faults."""
        for fault in self._faults:
            settings = fault.plant_settings(settings)
        return settings

    def begin(self, plant: Plant) -> None:
        """Begin all faults."""
        for fault in self._faults:
            fault.begin(plant)

    def change_state(self, state: LowState, k: int) -> None:
        """Change a sample by all faults."""
        for fault in self._faults:
            fault.change_state(state, k)

    def change_command(self, command: LowCmd, k: int) -> None:
        """Change a command by all faults."""
        for fault in self._faults:
            fault.change_command(command, k)
