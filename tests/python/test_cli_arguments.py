import json
import os
import re
import subprocess
import sys
from types import SimpleNamespace

import pytest
import surefoot
from surefoot.cli import arguments, main
from surefoot.cli.stand import choose_graphics, read_settings
from surefoot.sim import PlantSettings

BAD = {
    "no command": [],
    "unknown command": ["dance"],
    "unknown option": ["stand", "--speed", "3"],
    "shortened option": ["stand", "--dur", "3"],
    "unknown robot": ["stand", "--robot", "go7"],
    "no number": ["stand", "--duration", "long"],
    "zero duration": ["stand", "--duration", "0"],
    "negative duration": ["stand", "--duration", "-3"],
    "duration that is not a number": ["stand", "--duration", "nan"],
    "infinite duration": ["stand", "--duration", "inf"],
    "period not in whole milliseconds": ["stand", "--rate", "333"],
    "period below a millisecond": ["stand", "--rate", "2000"],
    "rate of zero": ["stand", "--rate", "0"],
    "unknown sensors": ["stand", "--sensors", "perfect"],
    "unknown foot force": ["stand", "--foot-force", "alive"],
    "negative friction": ["stand", "--friction", "-0.1"],
    "slope without number": ["stand", "--slope", "steep"],
    "slope with too many": ["stand", "--slope", "1:2:3"],
    "slope too steep": ["stand", "--slope", "80"],
    "payload without z": ["stand", "--payload", "2:0:0"],
    "negative payload": ["stand", "--payload", "-2"],
    "bad push": ["stand", "--push", "lateral:8:0.1"],
    "push after the end": ["stand", "--duration", "1", "--push", "lateral:8:0.1@2"],
    "push height that is not a number": ["stand", "--push", "lateral:8:0.1:high@1"],
    "reference without time": ["stand", "--reference", "roll=10"],
    "reference of an unknown axis": ["stand", "--reference", "lean=10@1"],
    "reference after the end": ["stand", "--duration", "1", "--reference", "roll=10@2"],
    "unknown form": ["stand", "--form", "dense"],
    "prediction too long": ["stand", "--predict-ms", "51"],
    "prediction that is not a number": ["stand", "--predict-ms", "nan"],
    "negative delay": ["stand", "--delay-ms", "-2"],
    "infinite delay": ["stand", "--delay-ms", "inf"],
    "negative lag": ["stand", "--motor-lag-ms", "-1"],
    "lag that is not a number": ["stand", "--motor-lag-ms", "nan"],
    "negative armature": ["stand", "--armature-scale", "-1"],
    "negative joint friction": ["stand", "--joint-friction-scale", "-0.5"],
    "negative backlash": ["stand", "--backlash-deg", "-1"],
    "too much backlash": ["stand", "--backlash-deg", "5.1"],
    "backlash without rotors": ["stand", "--backlash-deg", "1", "--armature-scale", "0"],
    "negative ground sink": ["stand", "--soft-ground", "-0.01"],
    "ground sink too large": ["stand", "--soft-ground", "0.11"],
    "ground sink too small": ["stand", "--soft-ground", "1e-6"],
    "soft ground without number": ["stand", "--soft-ground", "mud"],
    "negative seed": ["stand", "--seed", "-1"],
    "fractional seed": ["stand", "--seed", "1.5"],
    "negative damping": ["stand", "--motor-damping", "-1"],
    "missing gains file": ["stand", "--gains", "nowhere.toml"],
    "json in a missing folder": ["stand", "--json", "no/such/folder/out.json"],
    "option without value": ["stand", "--json"],
    "report under a file": ["stand", "--report", f"{__file__}/report"],
    "urdf without config": ["stand", "--urdf", "a.urdf"],
    "config without urdf": ["gains", "--config", "b.toml"],
    "name and files": ["stand", "--robot", "go1", "--urdf", "a.urdf", "--config", "b.toml"],
    "missing files": ["stand", "--urdf", "a.urdf", "--config", "b.toml"],
    "velocity without time": ["walk", "--velocity", "0.5,0,0"],
    "velocity with two numbers": ["walk", "--velocity", "0.5,0@1"],
    "velocity that is not a number": ["walk", "--velocity", "nan,0,0@1"],
    "infinite velocity": ["walk", "--velocity", "0,inf,0@1"],
    "velocity with a word": ["walk", "--velocity", "0,0,fast@1"],
    "velocity before the start": ["walk", "--velocity", "0,0,1@-1"],
    "velocity after the end": ["walk", "--duration", "1", "--velocity", "0,0,1@1"],
    "two velocities at one time": ["walk", "--velocity", "1,0,0@1", "--velocity", "0,1,0@1"],
    "unknown gait": ["walk", "--gait", "pace"],
    "two directions of ascent": ["walk", "--slope", "5:90", "--slope-heading", "0"],
    "walk with an unknown reference": ["walk", "--reference", "mood=1@1"],
    "bench of unknown robot": ["bench", "--robot", "go7"],
    "bench with too few ticks": ["bench", "--ticks", "9"],
    "bench of unknown form": ["bench", "--form", "dense"],
    "bench json in a missing folder": ["bench", "--json", "no/such/folder/out.json"],
    "export without arguments": ["export"],
    "export without robot": ["export", "out.robot"],
    "export of unknown robot": ["export", "go7", "out.robot"],
    "export of two robots": ["export", "go1", "out.robot", "--urdf", "a", "--config", "b"],
    "export without config": ["export", "out.robot", "--urdf", "a.urdf"],
    "export of missing files": ["export", "out.robot", "--urdf", "a.urdf", "--config", "b.toml"],
    "export to a missing folder": ["export", "go1", "no/such/folder/out.robot"],
    "gains of unknown robot": ["gains", "--robot", "go7"],
}
BAD_GAINS = {
    "unknown key": "com_kp_sideways = 3.0",
    "negative": "com_kp_vertical = -1.0",
    "not a number": "com_kp_vertical = nan",
    "a word": 'com_kp_vertical = "high"',
    "not TOML": "com_kp_vertical: 3",
}


@pytest.fixture(autouse=True)
def empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def call(*words):
    """Run the command in its own process."""
    line = [sys.executable, "-m", "surefoot.cli", *words]
    return subprocess.run(line, capture_output=True, text=True, timeout=60)


def assert_one_error_line(status, out, err):
    assert status == 2
    assert out == ""
    assert err.count("\n") == 1 and err.startswith("surefoot")
    assert "Traceback" not in err


@pytest.mark.parametrize("words", BAD.values(), ids=BAD.keys())
def test_invalid_argument_gives_one_error_line_and_status_2(words, capsys):
    status = main(words)
    assert_one_error_line(status, *capsys.readouterr())


@pytest.mark.parametrize("text", BAD_GAINS.values(), ids=BAD_GAINS.keys())
def test_invalid_gain_gives_one_error_line_and_status_2(text, capsys, tmp_path):
    (tmp_path / "gains.toml").write_text(text)
    status = main(["stand", "--gains", "gains.toml"])
    assert_one_error_line(status, *capsys.readouterr())


@pytest.mark.parametrize("words", [["stand", "--robot", "go7"], ["stand", "--push", "hard"], []])
def test_process_with_an_invalid_argument_exits_with_status_2(words):
    done = call(*words)
    assert_one_error_line(done.returncode, done.stdout, done.stderr)


def test_unknown_robot_error_lists_the_known_robots(capsys):
    main(["stand", "--robot", "go7"])
    complaint = capsys.readouterr().err
    assert all(name in complaint for name in surefoot.available_robots())


def test_json_on_stdout_is_exactly_one_object_and_nothing_else():
    done = call("stand", "--duration", "0.1", "--sensors", "ideal", "--json", "-")
    assert (done.returncode, done.stderr) == (0, "")
    summary = json.loads(done.stdout)
    assert (summary["robot"], summary["ticks"], summary["fell"]) == ("go1", 50, False)


def test_json_file_keeps_the_text_summary_on_stdout(capsys, tmp_path):
    (tmp_path / "gains.toml").write_text("[gains]\nfoot_kp = 90.0\n")
    words = "stand --robot a1 --duration 0.1 --rate 250 --slope -5:90 --payload 1:0:0:0.1 --seed 3"
    assert main([*words.split(), "--gains", "gains.toml", "--json", "out.json"]) == 0
    summary = json.loads((tmp_path / "out.json").read_text())
    assert (summary["robot"], summary["ticks"], summary["seed"]) == ("a1", 25, 3)
    assert (summary["slope_deg"], summary["slope_heading_deg"]) == (-5.0, 90.0)
    assert summary["payload_position"] == [0.0, 0.0, 0.1]
    assert summary["gains_changed"] == {"foot_kp": 90.0}
    out, err = capsys.readouterr()
    assert out.startswith("a1 stood 0.1 s") and err == ""


def test_motor_and_ground_options_reach_the_plant_in_si_units():
    words = "stand --delay-ms 3 --motor-lag-ms 5 --armature-scale 1.5 --joint-friction-scale 0.5"
    words += " --backlash-deg 0.8 --soft-ground 0.01"
    plant = read_settings(arguments.parse_arguments(words.split())).plant
    assert (plant.extra_delay, plant.lag) == pytest.approx((0.003, 0.005))
    assert (plant.armature_scale, plant.joint_friction_scale) == (1.5, 0.5)
    assert (plant.backlash_deg, plant.soft_ground_sink) == (0.8, 0.01)


def test_stand_without_options_uses_default_plant_settings():
    plant = read_settings(arguments.parse_arguments(["stand"])).plant
    assert plant == PlantSettings(seed=1)


def test_summary_reports_motor_and_ground_options(capsys, tmp_path):
    words = (
        "stand --duration 0.1 --delay-ms 1 --motor-lag-ms 3 --armature-scale 1.2 --json out.json"
    )
    words += " --joint-friction-scale 2 --backlash-deg 0.5 --soft-ground 0.005"
    words += " --push lateral:1:0.02:0.05@0.05"
    assert main(words.split()) == 0
    s = json.loads((tmp_path / "out.json").read_text())
    assert (s["delay_ms"], s["motor_lag_ms"], s["backlash_deg"]) == (1.0, 3.0, 0.5)
    assert (s["armature_scale"], s["joint_friction_scale"]) == (1.2, 2.0)
    assert (s["soft_ground_sink"], s["pushes"][0]["height_m"]) == (0.005, 0.05)
    out = capsys.readouterr().out
    assert "ground soft by 5 mm, joint friction x 2, armature x 1.2, backlash 0.5 deg" in out
    assert "motor lag 3 ms, delay 1 ms" in out
    assert "+0.05 m above the centre of mass" in out


def test_references_form_and_prediction_reach_the_settings_in_si_units():
    words = "stand --reference roll=10@4 --reference height=-0.02@5 --form condensed --predict-ms 4"
    settings = read_settings(arguments.parse_arguments(words.split()))
    assert [str(request) for request in settings.references] == [
        "roll=10.0@4.0",
        "height=-0.02@5.0",
    ]
    assert (settings.form, settings.predicted_delay) == (surefoot.QpForm.CONDENSED, 0.004)
    plain = read_settings(arguments.parse_arguments(["stand"]))
    assert (plain.references, plain.form, plain.predicted_delay) == ((), surefoot.QpForm.AUTO, 0.0)


def test_summary_reports_form_prediction_and_references(capsys, tmp_path):
    words = "stand --duration 0.2 --form condensed --predict-ms 4 --reference yaw=1,x=0.01@0.1"
    assert main([*words.split(), "--json", "out.json"]) == 0
    s = json.loads((tmp_path / "out.json").read_text())
    assert (s["form"], s["predict_ms"], s["delay_ms"]) == ("condensed", 4.0, 0.0)
    assert s["references"] == [{"time_s": 0.1, "yaw_deg": 1.0, "x_m": 0.01}]
    out = capsys.readouterr().out
    assert "condensed form, 4 ms predicted" in out
    assert "x +0.01 m, yaw +1 deg at 0.1 s" in out


def test_gains_option_changes_only_the_gains_in_the_file(monkeypatch, tmp_path):
    own = surefoot.Gains()
    own.foot_kd = 33.0
    robot = SimpleNamespace(config=SimpleNamespace(gains=own))
    monkeypatch.setattr("surefoot.cli.simulation_arguments.build_robot", lambda _: robot)
    (tmp_path / "gains.toml").write_text("foot_kp = 90.0")
    gains = read_settings(arguments.parse_arguments(["stand", "--gains", "gains.toml"])).gains
    assert (gains.foot_kp, gains.foot_kd) == (90.0, 33.0)
    assert own.foot_kp == surefoot.Gains().foot_kp


def test_fall_exits_with_status_3_and_a_summary(capsys):
    words = "stand --duration 2 --sensors ideal --push lateral:1000%:0.1@0.1 --json -"
    assert main(words.split()) == 3
    summary = json.loads(capsys.readouterr().out)
    assert summary["fell"] and not summary["settled"]
    assert summary["fall_time_s"] == summary["duration"] < 2.0


def test_exported_robot_file_loads_the_same_robot(capsys, tmp_path):
    assert main(["export", "go1", "dog.robot"]) == 0
    loaded, source = surefoot.Robot.load(str(tmp_path / "dog.robot")), surefoot.load_robot("go1")
    assert (loaded.name, loaded.nv) == ("go1", source.nv)
    assert loaded.mass == pytest.approx(source.mass)
    assert "go1" in capsys.readouterr().out


@pytest.fixture
def user_robot_files(tmp_path):
    """Return the options of a user robot: a1's URDF with another name and foot_kp in its TOML."""
    known = surefoot.robot.description.describe_robot("a1")
    config = surefoot.robot.description._models_folder() / "a1.toml"
    text = (
        config.read_text().replace('srdf = "', '# srdf = "').replace('name = "a1"', 'name = "my"')
    )
    text = re.sub(r"^foot_kp = .*$", "foot_kp = 77.0", text, flags=re.MULTILINE)
    (tmp_path / "own.toml").write_text(text)
    return ["--urdf", str(known.urdf), "--config", "own.toml"]


def test_user_robot_is_exported_from_its_files(user_robot_files, tmp_path):
    assert main(["export", *user_robot_files, "mine.robot"]) == 0
    assert surefoot.Robot.load(str(tmp_path / "mine.robot")).name == "my"


def test_user_robot_stands_from_its_files(user_robot_files, capsys):
    assert main(["stand", *user_robot_files, "--duration", "0.3", "--json", "-"]) == 0
    summary = json.loads(capsys.readouterr().out)
    assert (summary["robot"], summary["ticks"], summary["gains_changed"]) == ("my", 150, {})


def test_gains_of_a_user_robot_are_listed_from_its_files(user_robot_files, capsys):
    assert main(["gains", *user_robot_files]) == 0
    rows = {line.split()[0]: line.split()[1] for line in capsys.readouterr().out.splitlines()}
    assert rows["foot_kp"] == "77"


def test_robots_command_lists_every_robot(capsys):
    assert main(["robots"]) == 0
    rows = [line.split()[0] for line in capsys.readouterr().out.splitlines() if line]
    assert set(surefoot.available_robots()) <= set(rows)


@pytest.mark.parametrize("words", [["gains"], ["gains", "--robot", "b1"]])
def test_gains_command_lists_every_gain_with_its_value(words, capsys):
    assert main(words) == 0
    rows = {line.split()[0]: line for line in capsys.readouterr().out.splitlines()}
    gains = surefoot.load_robot("b1").config.gains if len(words) > 1 else surefoot.Gains()
    for row in surefoot.gain_table():
        assert rows[row.name].split()[1] == f"{surefoot.get_gain(gains, row.name):g}"
        assert row.meaning in rows[row.name]


def test_version_and_help_exit_with_status_0(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out.startswith("surefoot ")
    assert main(["stand", "--help"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert "--push" in text and "exit status: 0 the robot stood, 3 it fell" in text


def test_package_runs_as_a_module():
    command = [sys.executable, "-m", "surefoot", "--version"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.startswith("surefoot ")


def test_an_interrupted_run_ends_with_status_130(monkeypatch, capsys):
    def interrupt(_):
        raise KeyboardInterrupt

    monkeypatch.setattr(arguments, "robots", interrupt)
    assert main(["robots"]) == 130
    assert capsys.readouterr().err.count("\n") == 1


def test_closed_stdout_causes_no_traceback():
    line = [sys.executable, "-m", "surefoot.cli", "gains"]
    process = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    process.stdout.close()
    assert process.stderr.read() == ""
    process.stderr.close()
    process.wait(timeout=60)


@pytest.mark.skipif(sys.platform != "linux", reason="other systems draw without a display server")
def test_mujoco_gl_is_set_without_a_display(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "MUJOCO_GL"):
        monkeypatch.delenv(name, raising=False)
    choose_graphics(pictures=True)
    assert os.environ["MUJOCO_GL"] in ("egl", "disable")


def test_mujoco_loads_no_graphics_for_a_command_without_pictures(monkeypatch):
    monkeypatch.setenv("MUJOCO_GL", "foo")
    choose_graphics(pictures=False)
    assert os.environ["MUJOCO_GL"] == "disable"
