"""Scenario: a plant, a supervisor and one fault, run one control period at a time."""

from __future__ import annotations

from surefoot._core import (
    LowCmd,
    LowState,
    Mode,
    RequestStatus,
    Start,
    SupervisorOptions,
    WalkVelocity,
    fault_table,
)
from surefoot.faults.kinds.fault import Fault
from surefoot.faults.matrix.command_monitor import CommandMonitor
from surefoot.faults.matrix.frame_loopback import FrameLoopback
from surefoot.faults.matrix.matrix_setup import MatrixSetup
from surefoot.robot.loading import build_robot
from surefoot.robot.power_level import power_level
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.settings import COARSE_DT

PERIOD = 0.002  # [s] control period, as in command_monitor.py
# Smallest level of the power protection for a walking robot. Chosen: a step takes up to 210 W on a
# small robot, and a push or a fault takes more.
WALKING_LEVEL = 5


class Scenario:
    """One run of a supervised robot with a fault.

    Args:
        setup: Common setup of the matrix.
        fault: Fault to inject.
        level: Power protection level; None: the robot's default level.
        tick0: LowState.tick of the first sample [ms].
        walking: True: the plant has the sensor errors, soles and collisions of a walking robot.

    Attributes:
        plant: Plant of the robot.
        supervisor: Supervisor under test.
        monitor: Monitor of the commands.
        fault: The fault; begin() starts it.
        command: Last command of the supervisor.
        armed: True if the supervisor was armed at the last call of arm() or update_armed().
        taken_over: True: the robot stands from the start, and the supervisor is armed without
            checks.
        k: Number of control periods since the onset of the fault; None before the onset.
        velocity: Velocity that the supervisor receives before every tick; None: none.
    """

    def __init__(
        self,
        setup: MatrixSetup,
        fault: Fault,
        level: int | None = None,
        tick0: int = 0,
        walking: bool = False,
    ) -> None:
        self.fault = fault
        robot = build_robot(setup.description)
        assumed_robot = fault.assumed_robot(robot)
        settings = PlantSettings(
            seed=setup.seed,
            physics_dt=COARSE_DT,
            walking_sensors=walking,
            soft_soles=walking,
            leg_collisions=walking,
        )
        settings = fault.plant_settings(settings)
        self.plant = Plant(setup.description, settings, tick0=tick0)
        self.taken_over = setup.taken_over
        if self.taken_over:
            self._state = self.plant.reset()
        else:
            self._state = fault.start(self.plant, setup.lying_qpos)
        level = _default_level(robot.name, walking) if level is None else level
        start = Start.STANDING if self.taken_over else Start.LYING
        options = SupervisorOptions(power_level=level, start=start)
        fault.set_options(options)
        self.supervisor = setup.make_supervisor(assumed_robot, options)
        fault.prepare(self.supervisor)
        self.monitor = CommandMonitor(robot, level)
        self._loopback = FrameLoopback(robot.name) if fault.uses_frames else None
        self.command = LowCmd()
        self.k: int | None = None
        self.velocity: WalkVelocity | None = None
        self.armed = False
        self._counts_before_arming: dict[str, int] = {}
        if fault.from_start:
            self.begin()

    @property
    def tick(self) -> int:
        """LowState.tick of the next sample [ms]."""
        return int(self._state.tick)

    def begin(self) -> None:
        """Begin the fault; the next period is the first one with the fault."""
        if self.k is None:
            self.k = 0
            self.fault.begin(self.plant)

    def step(self) -> None:
        """Run one control period.

        The fault changes the sample, the supervisor computes a command, the fault changes the
        command, and the plant makes a step.
        """
        fault, k = self.fault, self.k
        received = LowState()
        received.raw[:] = self._state.raw
        runs = True
        if k is None:
            fault.operate_before_onset(self.supervisor)
        else:
            runs = fault.loop_runs(k)
            fault.change_state(received, k)
        if self._loopback is not None:
            frame = self._loopback.encode(received)
            received = self._loopback.receive(
                [frame] if k is None else fault.change_frame(frame, k)
            )
        if k is not None:
            fault.operate(self.supervisor, k)
        self._send_velocity()
        if runs:
            self.command = self.supervisor.update(received)
            dq = self.plant.data.qvel[self.plant.handles.motor_v]
            self.monitor.check(self.command, self._state, dq)
        delivered = LowCmd()
        delivered.raw[:] = self.command.raw
        if k is not None:
            fault.change_command(delivered, k)
            self.k = k + 1
        self._state = self.plant.step(delivered)

    def _send_velocity(self) -> None:
        if self.velocity is None:
            return
        velocity: WalkVelocity | None = self.velocity
        if self.k is not None:
            velocity = self.fault.change_velocity(self.velocity, self.k)
        if velocity is not None:
            self.supervisor.set_velocity(velocity)

    def run(self, seconds: float) -> None:
        """Run all control periods of a time [s]."""
        for _ in range(round(seconds / PERIOD)):
            self.step()

    def run_until_mode(self, mode: Mode, seconds: float) -> bool:
        """Run until the supervisor is in a mode, for at most a time [s]; return True if it is."""
        for _ in range(round(seconds / PERIOD)):
            if self.supervisor.mode == mode:
                return True
            self.step()
        return self.supervisor.mode == mode

    def arm(self) -> bool:
        """Run until the arming checks pass, then arm; return True if the supervisor is armed.

        A standing robot first sinks to the ground with damping motors, for up to 3 s.
        """
        # The limit of 6 s is chosen: 3 s of sinking, 1 s of arming_time, and a margin of 2 s.
        for _ in range(round(6.0 / PERIOD)):
            if self.supervisor.arm() == RequestStatus.ACCEPTED:
                self.step()
                return self.update_armed()
            self.step()
        return False

    def update_armed(self) -> bool:
        """Return True if the supervisor is armed.

        reported_faults then contains only the faults reported after this call.
        """
        self.armed = bool(self.supervisor.armed)
        self._counts_before_arming = self._counts()
        return self.armed

    @property
    def reported_faults(self) -> list[str]:
        """Names of the faults that the supervisor has reported since the last update_armed()."""
        return [
            name
            for name, n in self._counts().items()
            if n > self._counts_before_arming.get(name, 0)
        ]

    def _counts(self) -> dict[str, int]:
        faults = self.supervisor.faults
        return {info.name: faults.count(info.id) for info in fault_table()}

    @property
    def arming_failures(self) -> str:
        """Failed arming checks as one line of text; "" if all pass."""
        return "; ".join(str(self.supervisor.arming.failures(self.plant.robot)).splitlines())

    def close(self) -> None:
        """Close the sockets of the link."""
        if self._loopback is not None:
            self._loopback.close()


def _default_level(robot: str, walking: bool) -> int:
    """Return the level of the power protection for a cell that does not state one."""
    level = power_level(robot)
    return max(level, WALKING_LEVEL) if walking else level
