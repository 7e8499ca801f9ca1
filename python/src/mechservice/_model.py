"""A model and what one can ask of it."""

from __future__ import annotations

import html
import math
import os
import sys
import threading
from typing import Any, Callable, Iterable, List, Optional, Sequence, Tuple, Union

import jpype

from ._errors import MechError, RunInterrupted, python_errors
from ._interrupts import cancellable, interruptible
from ._java import java_class, java_path
from ._stepped import Stepped
from ._trajectory import LinearSystem, Trajectory

Value = Union[float, str]


class Model:
    """A model file with values of its parameters. It never changes: ``set`` returns another one.

    A pickle of it names its file, or has its text, and is read anew elsewhere.
    """

    def __init__(
        self,
        java: Any,
        here: Optional[Callable[[], Any]] = None,
        made: "Optional[Tuple[Any, ...]]" = None,
    ) -> None:
        self._java = java
        self._here = here
        self._made = made

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
        if not values:
            return self

        def change(java: Any) -> Any:
            for name, value in values.items():
                java = java.set(name, value if isinstance(value, str) else repr(float(value)))
            return java

        return self._changed(change, "set", values)

    def silence(self, *warnings: str) -> "Model":
        """Returns the model without some warnings, those of its check and those of its runs.

        warnings: their names or codes, such as ``"no-gravity"`` or ``"M-090"``.

        Raises ModelError if there is no such warning.
        """
        return self._changed(lambda java: java.silence(list(warnings)), "silence", warnings)

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
        """Runs the model; Ctrl-C ends the run and raises RunInterrupted, which has the rows.

        t_end, t_step: end and distance of the rows, s; the file's if not given.
        rtol, atol: tolerances, to be given together.
        columns: groups besides the joints, such as ``["energy", "bodies"]``; ``["all"]`` for each
            that the model has.
        simulation: name or number of one of the file's.
        strict: the first warning ends the run.
        csv: a file that takes the rows as well.
        Every other keyword is a parameter of the model.

        Raises ModelError, MechError or RunError; the latter has the rows up to there.
        """
        model = self.set(**parameters)._with(
            t_end, t_step, integrator, formulation, rtol, atol, columns, simulation, strict
        )
        with python_errors():
            trajectory = Trajectory(_rows(model._java), model)
            if csv is not None:
                trajectory._java.writeCsv(java_path(csv))
        return trajectory

    def _with(
        self,
        t_end: Optional[float] = None,
        t_step: Optional[float] = None,
        integrator: Optional[str] = None,
        formulation: Optional[str] = None,
        rtol: Optional[float] = None,
        atol: Optional[float] = None,
        columns: Optional[Sequence[str]] = None,
        simulation: Optional[str] = None,
        strict: bool = False,
    ) -> "Model":
        """Returns the model with settings of its run."""
        given = (t_end, t_step, integrator, formulation, rtol, atol, columns, simulation)
        if not strict and all(one is None for one in given):
            return self

        def change(java: Any) -> Any:
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
                java = java.columns(_groups(columns))
            return java.strict() if strict else java

        return self._changed(change, "_with", (*given, strict))

    def _changed(self, change: Callable[[Any], Any], verb: str, values: Any) -> "Model":
        """Returns the model after a change, here and, of a model at a server, in its twin here.

        verb, values: how to make it again.
        """
        made = None if self._made is None else (*self._made, (verb, values))
        with python_errors():
            there = change(self._java)
            here = self._here
            return Model(there, None if here is None else lambda: change(here()), made)

    def __reduce__(self) -> "Tuple[Any, ...]":
        if self._made is None:
            raise TypeError(
                "a model at a server belongs to its connection and cannot be pickled;"
                " read it again in the other process"
            )
        return _made_again, self._made

    def mechml(self) -> str:
        """Returns the model's text in MechML, with the files that it includes.

        Values and settings that were given to it later are not in it.
        """
        with python_errors():
            return str(self._in_process().mechml())

    def _in_process(self) -> Any:
        """Returns the model in Java in this process, which pictures and files are made of."""
        return self._java if self._here is None else self._here()

    def stepped(
        self,
        step: float,
        *,
        t_end: Optional[float] = None,
        integrator: Optional[str] = None,
        formulation: Optional[str] = None,
        rtol: Optional[float] = None,
        atol: Optional[float] = None,
        columns: Optional[Sequence[str]] = None,
        simulation: Optional[str] = None,
        saved: Optional[bytes] = None,
        **parameters: Value,
    ) -> Stepped:
        """Begins a run that your program advances by steps, between which it sets inputs.

        step: time between two steps, s; inputs are constant within one.
        saved: what ``Stepped.save`` returned; the run goes on there, with the same bits.
        The other keywords are those of ``simulate``.

        >>> import mechservice
        >>> block = mechservice.read("examples/elements/input.xml")
        >>> run = block.stepped(0.01, t_end=2)
        >>> run["gust"] = 0
        >>> while run.running:
        ...     run["force"] = 40 * (0.5 - run["slide.q"]) - 12 * run["slide.v"]
        ...     run.step()
        >>> round(run["slide.q"], 4)
        0.4985
        """
        model = self.set(**parameters)._with(
            t_end, None, integrator, formulation, rtol, atol, columns, simulation, False
        )
        with python_errors():
            given = (float(step),) if saved is None else (float(step), saved)
            return Stepped(model._java.stepped(*given), (model, float(step)))

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

    def linear_system(self) -> LinearSystem:
        """Computes x' = A x + B u, y = C x + D u from inputs to outputs, about the start."""
        with python_errors():
            return LinearSystem(self._java.linearSystem())

    def _analysis(self, verb: str) -> Trajectory:
        with python_errors():
            return Trajectory(getattr(self._java, verb)())

    def report(
        self,
        folder: "Union[str, os.PathLike[str]]",
        *,
        quick: bool = False,
        progress: "Union[bool, Callable[[str, float, float], None]]" = False,
    ) -> str:
        """Measures error against run time of every method that fits; returns the path of the page.

        folder: takes the page of ``mech report`` and its data. Ctrl-C ends the report at its next
        measurement; with the same folder it is taken up again there.
        quick: fewer tolerances and shorter limits, about a minute, or up to three for a large
        mechanism; else some minutes.
        progress: whether a line on standard error tells what is measured; or a function that is
        called with it, the part done, from 0 to 1, and the time left, s, NaN if not known yet.

        Of a model at a server, the server builds the methods; they are measured here.
        """
        effort = java_class("org.mechservice.report.measure.Effort")
        wanted = effort.QUICK if quick else effort.FULL
        told = progress if callable(progress) else _progress_line if progress else _silence
        stop = threading.Event()

        def at(what: Any, done: Any, left: Any) -> None:
            if stop.is_set():
                raise MechError("the report was interrupted")
            told(str(what), float(done), float(left))

        listener = jpype.JProxy("org.mechservice.report.measure.ReportProgress", dict={"at": at})
        try:
            with python_errors():
                page = cancellable(
                    lambda: self._java.report(java_path(folder), wanted, listener), stop
                )
                return str(page.toString())
        finally:
            if progress is True:
                print(file=sys.stderr)

    def write_jar(self, path: "Union[str, os.PathLike[str]]") -> None:
        """Writes the model as a JAR that ``java -jar`` runs."""
        with python_errors():
            self._java.writeJar(java_path(path))

    def write_urdf(
        self, path: "Union[str, os.PathLike[str]]", *, strict: bool = False
    ) -> List[str]:
        """Writes the mechanism as a robot in URDF; returns what URDF cannot express.

        strict: raise a MechError instead of leaving anything out; nothing is written then.

        Raises ModelError (M-086) if the mechanism would be another one: loops, constraints, joints
        of types S, PL and H.
        """
        return self._write_robot("URDF", path, strict)

    def write_mjcf(
        self, path: "Union[str, os.PathLike[str]]", *, strict: bool = False
    ) -> List[str]:
        """Writes the mechanism as a model of MuJoCo; returns what MJCF cannot express.

        Loops, couplings, armature, motors with their inputs and the start are written, too.

        strict: raise a MechError instead of leaving anything out; nothing is written then.

        Raises ModelError (M-086) if the mechanism would be another one: constraints and joints that
        MJCF does not have, moving bodies without mass.
        """
        return self._write_robot("MJCF", path, strict)

    def _write_robot(
        self, title: str, path: "Union[str, os.PathLike[str]]", strict: bool
    ) -> List[str]:
        with python_errors():
            java = self._in_process()
            robot = java.urdf() if title == "URDF" else java.mjcf()
            lost = [str(one.toString()) for one in robot.losses()]
            if strict and lost:
                raise MechError(f"S-127 {title} does not have:\n" + "\n".join(lost))
            with open(path, "w", encoding="utf-8", newline="") as file:
                file.write(str(robot.text()))
            return lost

    def drawing(self) -> str:
        """Returns the drawing of the mechanism in its initial position as SVG."""
        with python_errors():
            pictures = java_class("org.mechservice.view.model.ModelPictures")
            return str(pictures.drawing(self._in_process()))

    def __repr__(self) -> str:
        return f"<mechservice {self._java.toString()}>"

    def _repr_html_(self) -> str:
        try:
            drawing = self.drawing()
        except MechError as error:
            drawing = f"<p>{html.escape(str(error))}</p>"
        return (
            f"<div style='max-width:640px'>{drawing}</div>"
            f"<details><summary>{html.escape(self.name)}</summary>"
            f"<pre>{html.escape(self.check())}</pre></details>"
        )


def _progress_line(what: str, done: float, left: float) -> None:
    known = "" if math.isnan(left) else f", {left:.0f} s left"
    print(f"\r{100 * done:3.0f} %  {what}{known}".ljust(79)[:79], end="", file=sys.stderr, flush=True)


def _silence(what: str, done: float, left: float) -> None:
    pass


def _groups(names: Sequence[str]) -> List[Any]:
    groups = java_class("org.mechservice.solver.api.result.ColumnGroup")
    known = {str(group.label()): group for group in groups.values()}
    if "all" in names:
        return list(known.values())
    for name in names:
        if name not in known:
            raise MechError(f'"{name}" is no group of columns; there are all, {", ".join(known)}')
    return [known[name] for name in names]


def _made_again(how: Callable[..., Model], given: Tuple[Any, ...], *changes: Any) -> Model:
    """Returns a model that was pickled: what read it, with what, and the changes since then."""
    model = how(*given)
    for verb, values in changes:
        model = (
            model.set(**values) if verb == "set" else getattr(model, verb)(*values)
        )
    return model


def _rows(java: Any) -> Any:
    """Runs a model; Ctrl-C in the main thread stops it. Returns the rows in Java."""
    rows, interrupted = interruptible(java, java_class("org.mechservice.solver.api.run.RunControl")())
    if interrupted:
        raise RunInterrupted(Trajectory(rows))
    return rows


def consent(user_code: Iterable[str], unconfined: bool) -> Any:
    """Returns the Java object that says which classes of forces may run."""
    trusted = java_class("org.mechservice.guard.UserCode")
    named = getattr(trusted, "in_")([java_path(folder) for folder in user_code])
    return named.unconfined() if unconfined else named


def read(
    path: "Union[str, os.PathLike[str]]",
    *,
    user_code: Iterable[str] = (),
    unconfined: bool = False,
) -> Model:
    """Reads a MechML file, or imports a robot whose name ends in .urdf, .sdf or .mjcf.

    user_code: the folders whose classes of forces may run, in confined processes; no others run,
    also if they lie beside the model.
    unconfined: run them also where the operating system cannot confine them.
    """
    there = os.path.abspath(os.fspath(path))
    folders = tuple(os.path.abspath(os.fspath(folder)) for folder in user_code)
    made = (_read, (there, folders, unconfined))
    with python_errors():
        library = java_class("org.mechservice.library.MechModel")
        if there.lower().endswith((".urdf", ".sdf", ".mjcf")):
            return Model(library.importRobot(java_path(path)), made=made)
        return Model(library.read(java_path(path), consent(folders, unconfined)), made=made)


def _read(path: str, user_code: Tuple[str, ...], unconfined: bool) -> Model:
    return read(path, user_code=user_code, unconfined=unconfined)


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
        java = java_class("org.mechservice.library.MechModel").of(name, mechml)
        return Model(java, made=(parse, (mechml, name)))


def sweep(
    model: Model,
    parameter: str,
    values: Iterable[Value],
    *,
    progress: "Union[bool, Callable[[int, int], None]]" = False,
    **options: Any,
) -> List[Tuple[Value, Trajectory]]:
    """Simulates the model once for each value of a parameter; returns values and trajectories.

    progress: whether a line on standard error tells how far it is; or a function that is called
    with the number of runs done and that of all.
    Other keywords are those of ``simulate``. Ctrl-C raises RunInterrupted; its ``runs`` are those
    that were done, its ``rows`` those of the run under way.

    >>> import mechservice
    >>> model = mechservice.read("examples/elements/Parameters.xml")
    >>> for push, rows in mechservice.sweep(model, "push", [1, 2]):
    ...     print(push, rows["slide.q"][-1].round(3))
    1 1.516
    2 2.016
    """
    wanted = list(values)
    runs: List[Tuple[Value, Trajectory]] = []
    try:
        for value in wanted:
            runs.append((value, model.simulate(**{**options, parameter: value})))
            if callable(progress):
                progress(len(runs), len(wanted))
            elif progress:
                print(f"\r{len(runs)} of {len(wanted)}", end="", file=sys.stderr, flush=True)
    except RunInterrupted as interrupted:
        interrupted.runs = runs
        raise
    finally:
        if progress is True:
            print(file=sys.stderr)
    return runs
