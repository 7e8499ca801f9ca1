"""The package in the programs of its users: steps, robots, servers, other processes, type checkers."""

import importlib.util
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import mechservice

PENDULUM = "examples/pendulum/pendulum.xml"
INPUT = "examples/elements/input.xml"
TOP = Path(__file__).resolve().parents[2]
SERVER = os.environ.get("MECHSERVICE_TEST_SERVER", "")


def controlled(model):
    """Runs a controller at 100 Hz; returns the row after each step."""
    run = model.stepped(0.01, t_end=0.2)
    rows = []
    while run.running:
        run["force"] = 40 * (0.5 - run["slide.q"]) - 12 * run["slide.v"]
        run.step()
        rows.append(run.row.copy())
    return np.array(rows)


def test_steps_by_names_and_by_arrays_are_the_same():
    model = mechservice.read(INPUT)
    run = model.stepped(0.01, t_end=0.2)
    force = run.input_names.index("force")
    q, v = run.columns.index("slide.q"), run.columns.index("slide.v")
    rows = []
    while run.running:
        run.inputs[force] = 40 * (0.5 - run.row[q]) - 12 * run.row[v]
        run.step()
        rows.append(run.row.copy())
    assert np.array_equal(rows, controlled(model))
    assert run.units["force"] == "N" and run.time == 0.2
    with pytest.raises(mechservice.MechError, match="has ended at 0.2 s"):
        run.step()


def test_steps_go_on_where_they_were_saved():
    model = mechservice.read(INPUT)
    whole = controlled(model)
    run = model.stepped(0.01, t_end=0.2)
    for _ in range(10):
        run["force"] = 40 * (0.5 - run["slide.q"]) - 12 * run["slide.v"]
        run.step()
    later = model.stepped(0.01, t_end=0.2, saved=run.save())
    later["force"] = 40 * (0.5 - run["slide.q"]) - 12 * run["slide.v"]
    later.step()
    assert np.array_equal(later.row, whole[10])


def test_steps_refuse_what_is_no_input():
    run = mechservice.read(INPUT).stepped(0.01)
    with pytest.raises(KeyError, match="there are force, gust"):
        run["slide.q"] = 1
    with pytest.raises(KeyError, match="there is no column"):
        run["nothing"]
    run["force"] = float("nan")
    with pytest.raises(mechservice.MechError) as refused:
        run.step()
    assert refused.value.code == "S-195"


def test_state_is_read_and_set():
    run = mechservice.read(INPUT).stepped(0.01)
    state = run.state
    state[0] = 0.25
    run.state = state
    assert run.state[0] == 0.25


FOUR_BAR = "examples/four-bar/four-bar.xml"


def test_coordinate_of_a_loop_is_held_and_the_others_follow():
    run = mechservice.read(FOUR_BAR).stepped(0.001)
    state = run.state
    state[run.columns.index("A.q") - 1] = 0.3
    run.state = state
    assert run["A.q"] == pytest.approx(0.3, abs=1e-12) and run["A.q"] == run.row[1]
    assert run["B.q"] != state[1] and run.state[1] == run["B.q"]
    before = run.row.copy()
    run.step()
    assert np.abs(run.row - before)[1:4].max() < 0.001
    state = run.state
    state[:3] += [0.1, 0, -0.4]
    with pytest.raises(mechservice.MechError, match="do not close with A.q, C.q as set") as refused:
        run.state = state
    assert refused.value.code == "S-195"
    run.step()


def test_run_begins_again_with_the_same_bits():
    run = mechservice.read(INPUT).stepped(0.01, t_end=0.2)
    run["force"] = 2
    rows = []
    while run.running:
        run.step()
        rows.append(run.row.copy())
    run.reset()
    assert run.running and run.time == 0 and run["force"] == 3
    run["force"] = 2
    for row in rows:
        run.step()
        assert np.array_equal(run.row, row)
    state = run.state
    state[0] = 0.25
    run.reset(state)
    assert run.time == 0 and run["slide.q"] == 0.25


def in_a_process(program, number=None):
    """Runs a program and sends it a signal once it is ready; returns it with what it printed."""
    places = [str(Path(mechservice.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
    started = subprocess.Popen(
        [sys.executable, "-c", program],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, places))},
    )
    assert started.stdout.readline() == "ready\n"
    if number is not None:
        started.send_signal(number)
    return started, started.communicate(timeout=300)[0]


STEPPED = (
    "import threading, time, mechservice\n"
    f"run = mechservice.read({PENDULUM!r}).stepped(1e8, t_end=1e9)\n"
    "def ready():\n"
    "    print('ready', flush=True)\n"
)


def test_ctrl_c_ends_a_step():
    ended, said = in_a_process(
        STEPPED
        # when the step is under way
        + "threading.Timer(1, ready).start()\n"
        + "try:\n"
        + "    run.step()\n"
        + "except KeyboardInterrupt:\n"
        + "    print('interrupted', run.running, run.time < 1e8)\n",
        signal.SIGINT,
    )
    assert said == "interrupted False True\n" and ended.returncode == 0


def test_sigterm_ends_the_process():
    ended, said = in_a_process(STEPPED + "ready()\ntime.sleep(300)\n", signal.SIGTERM)
    assert ended.returncode == -signal.SIGTERM and said == ""


def test_memory_of_steps_does_not_depend_on_the_end():
    run = mechservice.read(PENDULUM).stepped(0.001, t_end=1e6)
    run.step()
    assert run.time == 0.001 and run.running


def test_models_rows_and_runs_are_pickled():
    model = mechservice.read("examples/elements/Parameters.xml").set(push=4)
    rows = model.simulate(t_end=0.5, columns=["all"])
    again = pickle.loads(pickle.dumps(rows))
    assert np.array_equal(again.values, rows.values) and again.units == rows.units
    assert again.report == rows.report and again.complete and repr(again) == repr(rows)
    assert "<canvas" in again.player() or "<script" in again.player()
    twin = pickle.loads(pickle.dumps(model))
    assert np.array_equal(
        twin.simulate(t_end=0.5).values, model.simulate(t_end=0.5).values
    )
    text = mechservice.parse(model.mechml(), "text").set(push=4)
    elsewhere = pickle.loads(pickle.dumps(text))
    assert np.array_equal(
        elsewhere.simulate(t_end=0.5).values, model.simulate(t_end=0.5).values
    )
    run = mechservice.read(INPUT).stepped(0.01, t_end=0.2)
    run["force"] = 2
    run.step()
    run["force"] = -1
    other = pickle.loads(pickle.dumps(run))
    run.step()
    other.step()
    assert np.array_equal(run.row, other.row)


def test_what_cannot_be_pickled_says_so():
    with pytest.raises(TypeError, match="pickle its model"):
        pickle.dumps(mechservice.Builder("Arm"))


def test_linear_system_has_names():
    system = mechservice.read(INPUT).linear_system()
    assert list(system.states) == ["slide.q", "slide.v"] and list(system.inputs) == ["force", "gust"]
    assert system.A.tolist() == [[0, 1], [0, 0]] and system.B.tolist() == [[0, 0], [0.5, 0.5]]


def test_robots_come_and_go(tmp_path):
    model = mechservice.read(PENDULUM)
    assert model.write_urdf(tmp_path / "pendulum.urdf", strict=True) == []
    again = mechservice.read(tmp_path / "pendulum.urdf")
    there = model.simulate(t_end=1, rtol=1e-10, atol=1e-12)
    back = again.simulate(t_end=1, rtol=1e-10, atol=1e-12)
    assert np.abs(there.values - back.values).max() < 1e-8
    spring = mechservice.read("examples/elements/static.xml")
    with pytest.raises(mechservice.MechError, match="has no spring"):
        spring.write_urdf(tmp_path / "spring.urdf", strict=True)
    assert not (tmp_path / "spring.urdf").exists()
    assert "M-087" in spring.write_urdf(tmp_path / "spring.urdf")[0]
    with pytest.raises(mechservice.ModelError) as loop:
        mechservice.read("examples/four-bar/four-bar.xml").write_urdf(tmp_path / "loop.urdf")
    assert loop.value.code == "M-086"


def test_models_go_to_mujoco_with_their_loops(tmp_path):
    loop = mechservice.read("examples/four-bar/four-bar.xml")
    loop.write_mjcf(tmp_path / "loop.mjcf")
    assert "<connect" in (tmp_path / "loop.mjcf").read_text()
    model = mechservice.read(PENDULUM)
    assert model.write_mjcf(tmp_path / "pendulum.mjcf", strict=True) == []
    there = model.simulate(t_end=1, rtol=1e-10, atol=1e-12)
    back = mechservice.read(tmp_path / "pendulum.mjcf").simulate(t_end=1, rtol=1e-10, atol=1e-12)
    assert np.abs(there.values - back.values).max() < 1e-8
    hill = mechservice.read("examples/how-to/thrown-ball.xml")
    with pytest.raises(mechservice.MechError, match="MJCF does not have"):
        hill.write_mjcf(tmp_path / "hill.mjcf", strict=True)
    assert not (tmp_path / "hill.mjcf").exists()
    assert "M-087" in hill.write_mjcf(tmp_path / "hill.mjcf")[0]


def test_sweeps_tell_how_far_they_are():
    told = []
    model = mechservice.read("examples/elements/Parameters.xml")
    runs = mechservice.sweep(
        model, "push", [1, 2], t_end=0.1, progress=lambda done, all: told.append((done, all))
    )
    assert told == [(1, 2), (2, 2)] and [value for value, _ in runs] == [1, 2]


def last_angle(t_end):
    """A job of another process."""
    return float(mechservice.read(str(TOP / PENDULUM)).simulate(t_end=t_end)["j1.q"][-1])


def test_processes_that_are_spawned_have_a_java_of_their_own():
    here = last_angle(0.1)
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.map(last_angle, [0.1]) == [here]


def test_library_joins_the_java_of_another_package():
    program = (
        "import jpype, sys\n"
        "jpype.startJVM(convertStrings=True)\n"
        "jpype.JClass('java.util.ArrayList')()\n"
        "import mechservice\n"
        f"model = mechservice.read({PENDULUM!r})\n"
        "rows = model.simulate(t_end=0.1)\n"
        "print(rows.complete, rows.columns[1], '<svg' in model.drawing())\n"
        f"server = {SERVER!r}\n"
        "if server:\n"
        "    with mechservice.connect(server) as service:\n"
        f"        there = service.read({PENDULUM!r}).simulate(t_end=0.1)\n"
        "        assert (there.values == rows.values).all()\n"
    )
    places = [str(Path(mechservice.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
    done = subprocess.run(
        [sys.executable, "-c", program],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, places))},
    )
    assert done.stdout == "True j1.q True\n"


@pytest.mark.skipif(not SERVER, reason="MECHSERVICE_TEST_SERVER names no server")
def test_servers_give_the_same_bits(tmp_path, capfd):
    with mechservice.connect(SERVER) as service:
        here, there = mechservice.read(PENDULUM), service.read(PENDULUM)
        a = here.simulate(t_end=1, columns=["energy"], rtol=1e-8, atol=1e-9)
        b = there.simulate(t_end=1, columns=["energy"], rtol=1e-8, atol=1e-9)
        assert np.array_equal(a.values, b.values) and a.columns == b.columns
        assert a.report["steps"] == b.report["steps"]
        assert here.check() == there.check() and here.name == there.name
        assert "<svg" in there._repr_html_() and "<iframe" in b._repr_html_()
        assert np.array_equal(controlled(mechservice.read(INPUT)), controlled(service.read(INPUT)))
        block = "examples/elements/static.xml"
        for verb in ("equilibrium", "modes", "linearise"):
            rows = getattr(service.read(block), verb)()
            assert np.array_equal(rows.values, getattr(mechservice.read(block), verb)().values)
        there.write_jar(tmp_path / "there.jar")
        here.write_jar(tmp_path / "here.jar")
        assert (tmp_path / "there.jar").read_bytes() == (tmp_path / "here.jar").read_bytes()
        with pytest.raises(mechservice.ModelError) as unknown:
            there.set(nothing=1)
        assert unknown.value.code == "M-014"
        with pytest.raises(mechservice.RunError) as failed:
            there.kinematics()
        assert failed.value.code == "N-060" and len(failed.value.rows) == 0
    assert capfd.readouterr().err == ""


def test_a_server_that_is_not_there_is_said():
    with pytest.raises(mechservice.ServerError) as lost:
        mechservice.connect("localhost:1")
    assert lost.value.code == "S-002"


def test_stubs_are_those_of_the_classes_in_java(tmp_path):
    subprocess.run([sys.executable, TOP / "python/write-stubs", tmp_path / "stubs"], check=True)
    written = TOP / "python/src/mechservice/_builder.pyi"
    assert (tmp_path / "stubs").read_text() == written.read_text()


@pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="mypy is not installed")
def test_types_are_complete(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(
        "import mechservice\n"
        "model: mechservice.Model = mechservice.read('model.xml').set(k=2.1e4)\n"
        "rows: mechservice.Trajectory = model.simulate(t_end=1, push=3)\n"
        "last: float = float(rows['q'][-1])\n"
        "arm = mechservice.Builder('Arm')\n"
        "arm.joint('hinge', 'R').between('ground', 'bar').at(0, 0, 0).axis(0, 1, 0)\n"
        "built: mechservice.Model = arm.model()\n"
        "run: mechservice.Stepped = built.stepped(0.001)\n"
        "with mechservice.connect('localhost:15000') as service:\n"
        "    there: mechservice.Model = service.read('model.xml')\n"
    )
    source = Path(mechservice.__file__).parent
    settings = str(TOP / "python/pyproject.toml")
    for what in (["-p", "mechservice"], [str(program)]):
        done = subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", "--config-file", settings, *what],
            stdout=subprocess.PIPE,
            text=True,
            cwd=source.parent,
            env={**os.environ, "MYPY_CACHE_DIR": str(tmp_path / "cache")},
        )
        assert done.returncode == 0, done.stdout
