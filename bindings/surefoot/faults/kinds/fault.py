"""Base class of faults: hooks between the plant and the supervisor."""

from __future__ import annotations

from surefoot._core import LowCmd, LowState, Robot, Supervisor, SupervisorOptions, WalkVelocity
from surefoot.geometry.rotations import Array
from surefoot.sim import Plant, PlantSettings


class Fault:
    """Base class of faults. Its hooks change nothing; a subclass overrides the hooks that it needs.

    The onset is the time at which the fault begins. k is the number of control periods since the
    onset. Hooks with a parameter k are called only after the onset.

    Attributes:
        from_start: True: the onset is before arming. False: the onset is in the mode of the cell.
        uses_frames: True: the supervisor receives its samples as encoded frames through a UdpLink.
    """

    from_start = False
    uses_frames = False

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the settings of the plant, changed by the fault."""
        return settings

    def assumed_robot(self, robot: Robot) -> Robot:
        """Return the robot model that the supervisor receives."""
        return robot

    def tick0(self, onset: int) -> int | None:
        """Return LowState.tick of the first sample [ms]; None: 0.

        Args:
            onset: Time from the first sample to the onset of the fault [ms].
        """
        return None

    def set_options(self, options: SupervisorOptions) -> None:
        """Change the options of the supervisor in place."""

    def start(self, plant: Plant, lying_qpos: Array) -> LowState:
        """Put the robot into its initial state and return the first sample.

        Args:
            plant: Plant of the robot.
            lying_qpos: MuJoCo qpos of the robot that lies at rest.
        """
        return plant.reset_lying_at(lying_qpos)

    def prepare(self, supervisor: Supervisor) -> None:
        """Prepare the supervisor before the first sample."""

    def begin(self, plant: Plant) -> None:
        """Change the plant once at the onset."""

    def loop_runs(self, k: int) -> bool:
        """Return True if the control loop runs in period k, False if it misses the period."""
        return True

    def operate_before_onset(self, supervisor: Supervisor) -> None:
        """Call functions of the supervisor in every period before the onset."""

    def change_state(self, state: LowState, k: int) -> None:
        """Change a sample in place."""

    def change_frame(self, frame: bytes, k: int) -> list[bytes]:
        """Return the datagrams that arrive in period k instead of the frame of the sample."""
        return [frame]

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Perform operator actions before tick k."""

    def change_velocity(self, velocity: WalkVelocity, k: int) -> WalkVelocity | None:
        """Return the velocity that a walking robot receives before tick k; None: none."""
        return velocity

    def change_command(self, command: LowCmd, k: int) -> None:
        """Change a command in place before the motors receive it."""

    def is_observable(self, plant: Plant) -> bool:
        """Return True if the fault has an effect that the supervisor can observe.

        Reaction times count from the first period in which this method returns True.
        """
        return True

    def problems(self) -> list[str]:
        """Return the problems that the fault itself found, as text; empty if it found none."""
        return []


class CombinedFault(Fault):
    """Several faults at the same time.

    Only the hooks that this class overrides call the hooks of the faults; all other hooks of the
    faults are ignored.

    Args:
        faults: Faults, in the order in which their hooks run.
    """

    def __init__(self, *faults: Fault) -> None:
        self._faults = faults
        self.uses_frames = any(fault.uses_frames for fault in faults)
        self.from_start = any(fault.from_start for fault in faults)

    def assumed_robot(self, robot: Robot) -> Robot:
        """Return the robot model, changed by all faults."""
        for fault in self._faults:
            robot = fault.assumed_robot(robot)
        return robot

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the plant settings, changed by all faults."""
        for fault in self._faults:
            settings = fault.plant_settings(settings)
        return settings

    def begin(self, plant: Plant) -> None:
        """Begin all faults."""
        for fault in self._faults:
            fault.begin(plant)

    def change_state(self, state: LowState, k: int) -> None:
        """Let all faults change a sample in place."""
        for fault in self._faults:
            fault.change_state(state, k)

    def change_command(self, command: LowCmd, k: int) -> None:
        """Let all faults change a command in place."""
        for fault in self._faults:
            fault.change_command(command, k)
