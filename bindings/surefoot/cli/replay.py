"""surefoot replay: replays a log through a new controller and compares the commands bit for bit."""

from __future__ import annotations

import argparse
from dataclasses import asdict

from surefoot.cli.output_files import check_json_path, write_json
from surefoot.cli.progress import progress_bar
from surefoot.cli.robot_choice import add_robot_options, chosen_robot
from surefoot.replay import Recording, Replay, play, read_recording
from surefoot.replay.build_id import build_id
from surefoot.robot.loading import build_robot

DIFFERS = 4  # exit status if the commands differ
_EPILOG = """\
The log holds all inputs of the controller: its gains and options, every LowState, and the requests
in between. Commands are bit-identical on the same build of the library and the same machine.

exit status: 0 identical, 4 the commands differ, 1 a file could not be written, 2 a wrong argument
or a log that cannot be replayed, 130 interrupted"""


def add_replay_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot replay."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    parser.add_argument("log", metavar="LOG.npz", help="log that surefoot stand --log wrote")
    add_robot_options(parser, "the robot that the log names")
    parser.add_argument("--json", metavar="FILE|-", help="write the result as JSON; - is stdout")


def replay(arguments: argparse.Namespace) -> int | None:
    """Replay the log and print the first difference.

    Returns:
        Exit status: 4 if the commands differ, else None.

    Raises:
        Error: A wrong argument, or a log that cannot be replayed.
        OSError: A file could not be written.
    """
    check_json_path(arguments.json)
    recording = read_recording(arguments.log)
    description = chosen_robot(arguments, default=recording.robot)
    assert description is not None  # not None, because a default robot is given
    result = play(recording, build_robot(description), progress_bar())
    write_json(arguments.json, _record(recording, result))
    if arguments.json != "-":
        print(replay_text(recording, result))
    return None if result.first is None else DIFFERS


def replay_text(recording: Recording, result: Replay) -> str:
    """Return the result of a replay as text."""
    what = f"{len(recording.commands)} commands of a {recording.kind} on {recording.robot}"
    other = f"\nbuild: got a log of {recording.build}, this is {build_id()}: bits may differ"
    build = "" if result.same_build else other
    if result.first is None:
        return f"identical: {what}{build}"
    first = result.first
    return (
        f"differs first in row {first.row} (LowState.tick {first.tick}): {first.field}: logged "
        f"{first.logged!r}, replayed {first.replayed!r}\n{result.differing} of {what} differ{build}"
    )


def _record(recording: Recording, result: Replay) -> dict[str, object]:
    return {
        "identical": result.first is None,
        "kind": recording.kind,
        "robot": recording.robot,
        "commands": len(recording.commands),
        "differing": result.differing,
        "first": None if result.first is None else asdict(result.first),
        "build": build_id(),
        "build_of_log": recording.build,
    }
