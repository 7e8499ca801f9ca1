"""A model and what one can ask of it."""

from __future__ import annotations

import html
import os
import sys
import threading
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

from ._errors import MechError, python_errors
from ._java import java_class, java_path
from ._trajectory import Trajectory

Value = Union[float, str]

_LOOK_SECONDS = 0.05


class Model:
    """A model file with values of its parameters. It never changes: ``set`` returns another one."""

    def __init__(self, java: Any) -> None:
        self._java = java

    @property
    def name(self) -> str:
        """The model's name."""
        return str(self._java.name())

    @property
    def parameters(self) -> List[str]:
        """The names of its parameters."""
        return [str(one.name()) for one in self._java.parameters()]

    def set(self, **values: Value) -> "Model":
        """Returns the model with other values of parameters, in the units of the file.

        >>> import mechservice
        >>> model = mechservice.read("examples/elements/Parameters.xml")
        >>> float(model.set(push=4).simulate()["slide.q"][-1].round(3))
        3.016
        """
        java = self._java
        with python_errors():
            for name, value in values.items():
                text = value if isinstance(value, str) else repr(float(value))
                java = java.set(name, text)
        return Model(java)

    def check(self) -> str:
        """Returns what is known about the model before it runs, as ``mech check`` prints it."""
        with python_errors():
            return str(self._java.check().text())

    def simulate(
        self,
        *,
        t_end: Optional[float] = None,
        t_step: Optional[float] = None,
        integrator: Optional[str] = None,
        formulation: Optional[str] = None,
        rtol: Optional[float] = None,
        atol: Optional[float] = None,
        columns: Optional[Sequence[str]] = None,
        simulation: Optional[str] = None,
        strict: bool = False,
        csv: "Union[str, os.PathLike[str], None]" = None,
        **parameters: Value,
    ) -> Trajectory:
        """Runs the model; Ctrl-C ends the run and returns the rows there are.

        t_end, t_step: end and distance of the rows, s; the file's if not given.
        rtol, atol: tolerances, to be given together.
        columns: groups besides the joints, such as ``["energy", "bodies"]``.
        simulation: name or number of one of the file's.
        strict: the first warning ends the run.
        csv: a file that takes the rows as well.
        Every other keyword is a parameter of the model.

        Raises ModelError, MechError or RunError; the latter has the rows up to there.
        """
        java = self.set(**parameters)._java
        with python_errors():
            if simulation is not None:
                java = java.simulation(str(simulation))
            if t_end is not None:
                java = java.until(float(t_end))
            if t_step is not None:
                java = java.every(float(t_step))
            if integrator is not None:
                java = java.integrator(integrator)
            if formulation is not None:
                java = java.formulation(formulation)
            if (rtol is None) != (atol is None):
                raise MechError("rtol and atol are given together; the other one is missing")
            if rtol is not None and atol is not None:
                java = java.tolerances(float(rtol), [float(atol)])
            if columns is not None:
                java = java.columns([_group(name) for name in columns])
            if strict:
                java = java.strict()
            trajectory = _interruptible(java)
        if csv is not None:
            with python_errors():
                trajectory._java.writeCsv(java_path(csv))
        return trajectory

    def equilibrium(self) -> Trajectory:
        """Finds where the mechanism comes to rest; one row."""
        return self._analysis("equilibrium")

    def modes(self) -> Trajectory:
        """Computes frequencies, dampings and shapes of small motions about the start."""
        return self._analysis("modes")

    def linearise(self) -> Trajectory:
        """Computes the matrices of small motions about the start."""
        return self._analysis("linearise")

    def kinematics(self) -> Trajectory:
        """Computes the motion of driven coordinates and of all that depend on them."""
        return self._analysis("kinematics")

    def inverse_dynamics(self) -> Trajectory:
        """Computes the forces that produce the prescribed motion."""
        return self._analysis("inverseDynamics")

    def _analysis(self, verb: str) -> Trajectory:
        with python_errors():
            return Trajectory(getattr(self._java, verb)())

    def write_jar(self, path: "Union[str, os.PathLike[str]]") -> None:
        """Writes the model as a JAR that ``java -jar`` runs."""
        with python_errors():
            self._java.writeJar(java_path(path))

    def __repr__(self) -> str:
        return f"<mechservice {self._java.toString()}>"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.check())}</pre>"


def _group(name: str) -> Any:
    groups = java_class("org.mechservice.solver.api.result.ColumnGroup")
    known = {str(group.label()): group for group in groups.values()}
    if name not in known:
        raise MechError(f'"{name}" is no group of columns; there are {", ".join(known)}')
    return known[name]


def _interruptible(java: Any) -> Trajectory:
    """Runs in a thread of its own, so that this one hears of Ctrl-C."""
    control = java_class("org.mechservice.solver.api.run.RunControl")()
    if threading.current_thread() is not threading.main_thread():
        return Trajectory(java.simulate(control))
    done = threading.Event()
    result: Dict[str, Any] = {}

    def run() -> None:
        try:
            result["rows"] = java.simulate(control)
        except BaseException as error:  # handed to the caller's thread
            result["error"] = error
        finally:
            done.set()

    worker = threading.Thread(target=run, name="mechservice-run", daemon=True)
    worker.start()
    while not done.is_set():
        try:
            done.wait(_LOOK_SECONDS)
        except KeyboardInterrupt:
            control.stop()
    if "error" in result:
        raise result["error"]
    return Trajectory(result["rows"])


def read(
    path: "Union[str, os.PathLike[str]]", *, user_code: Iterable[str] = ()
) -> Model:
    """Reads a MechML file.

    user_code: further folders in which classes of forces are sought.
    """
    with python_errors():
        folders = [java_path(folder) for folder in user_code]
        return Model(
            java_class("org.mechservice.library.MechModel").read(java_path(path), folders)
        )


def parse(mechml: str, name: str = "model") -> Model:
    """Reads a model from MechML text.

    >>> import mechservice
    >>> try:
    ...     mechservice.parse("<MechML/>")
    ... except mechservice.ModelError as error:
    ...     print(error.code)
    M-010
    """
    with python_errors():
        return Model(java_class("org.mechservice.library.MechModel").of(name, mechml))


def sweep(
    model: Model, parameter: str, values: Iterable[Value], *, progress: bool = False, **options: Any
) -> List[Tuple[Value, Trajectory]]:
    """Simulates the model once for each value of a parameter; returns values and trajectories.

    progress: whether a line on standard error tells how far it is.

    >>> import mechservice
    >>> model = mechservice.read("examples/elements/Parameters.xml")
    >>> for push, rows in mechservice.sweep(model, "push", [1, 2]):
    ...     print(push, rows["slide.q"][-1].round(3))
    1 1.516
    2 2.016
    """
    wanted = list(values)
    runs: List[Tuple[Value, Trajectory]] = []
    for value in wanted:
        runs.append((value, model.simulate(**{**options, parameter: value})))
        if progress:
            print(f"\r{len(runs)} of {len(wanted)}", end="", file=sys.stderr, flush=True)
    if progress:
        print(file=sys.stderr)
    return runs
