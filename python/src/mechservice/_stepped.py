"""A run that a program advances by steps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import jpype
import numpy as np
import numpy.typing as npt

from ._errors import MechError, python_errors
from ._interrupts import stepping

if TYPE_CHECKING:
    from ._model import Model


class Stepped:
    """A run that your program advances by steps of communication.

    ``run["force"] = 3`` sets an input for the steps from here on, ``run["slide.q"]`` reads a column
    at the time reached. In a fast loop use the arrays: ``run.inputs`` has a place for each of
    ``run.input_names``, ``run.row`` one for each of ``run.columns``; both share the memory of the
    run, and ``step`` looks at the one and fills the other.
    """

    def __init__(self, java: Any, made: "Tuple[Model, float]") -> None:
        self._java = java
        self._made = made
        self._inputs = [(str(one.name()), str(one.unit())) for one in java.inputs()]
        self._columns = [(str(one.name()), str(one.unit())) for one in java.columns()]
        self._input_index = {name: i for i, (name, _) in enumerate(self._inputs)}
        self._column_index = {name: i for i, (name, _) in enumerate(self._columns)}
        self.inputs, self._given = _shared(java.inputValues())
        self.row, self._then = _shared(java.row())
        self._step = java.step
        self._stop = java.interrupt
        self._running = bool(java.isRunning())

    @property
    def input_names(self) -> List[str]:
        """The names of the inputs."""
        return list(self._input_index)

    @property
    def columns(self) -> List[str]:
        """The names of the columns, time first."""
        return list(self._column_index)

    @property
    def units(self) -> Dict[str, str]:
        """The units of columns and inputs."""
        return {**dict(self._inputs), **dict(self._columns)}

    @property
    def running(self) -> bool:
        """Whether the end time is not reached yet."""
        return self._running

    @property
    def time(self) -> float:
        """The time reached, s."""
        return float(self._java.time())

    def step(self) -> None:
        """Advances by one step with the present inputs; Ctrl-C ends it, and the run with it.

        Raises MechError if an input is not finite or the run has ended, RunError if it cannot go
        on.
        """
        if not self._running:
            raise MechError(f"the run has ended at {self.time} s; it takes no further steps")
        try:
            self._running = stepping(self._stop, self._step, self._given, self._then)
        except KeyboardInterrupt:
            self._running = bool(self._java.isRunning())
            raise
        except jpype.JException:
            with python_errors():
                raise

    @property
    def state(self) -> npt.NDArray[np.float64]:
        """The state [q; v; s] from which the next step begins; a copy.

        Setting it takes effect at once, also in ``row`` and ``inputs``. Coordinates that you change
        are held, and the loops make the others follow; MechError is raised, and the state is that
        before, if the loops do not close so.
        """
        return np.array(self._java.state(), dtype=np.float64)

    @state.setter
    def state(self, values: npt.ArrayLike) -> None:
        with python_errors():
            self._java.state(jpype.JArray(jpype.JDouble)(np.asarray(values, dtype=np.float64)))
        self._look()

    def reset(self, state: Optional[npt.ArrayLike] = None) -> None:
        """Goes back to where this run began, in microseconds: time, state and inputs.

        state: another state to begin from there, as of ``state``.
        """
        with python_errors():
            self._java.reset()
        self._running = bool(self._java.isRunning())
        self._look()
        if state is not None:
            self.state = state

    def _look(self) -> None:
        self.row[:] = self._java.row()
        self.inputs[:] = self._java.inputValues()

    def __reduce__(self) -> "Tuple[Any, ...]":
        """Pickles the run between two steps, with its model: it goes on elsewhere, bit by bit."""
        return _taken_up, (*self._made, self.save(), np.array(self.inputs))

    def save(self) -> bytes:
        """Returns the run between two steps, for ``Model.stepped(step, saved=...)``."""
        with python_errors():
            return bytes(self._java.save())

    def __getitem__(self, name: str) -> float:
        index = self._column_index.get(name)
        if index is None:
            if name in self._input_index:
                return float(self.inputs[self._input_index[name]])
            raise KeyError(f'there is no column "{name}"; there are {", ".join(self.columns)}')
        return float(self.row[index])

    def __setitem__(self, name: str, value: float) -> None:
        index = self._input_index.get(name)
        if index is None:
            known = ", ".join(self.input_names) or "none in this model"
            raise KeyError(f'there is no input "{name}"; there are {known}')
        self.inputs[index] = value

    def __repr__(self) -> str:
        return f"<mechservice run at {self.time} s, inputs {self.input_names}>"


def _taken_up(
    model: "Model", step: float, saved: bytes, inputs: npt.NDArray[np.float64]
) -> Stepped:
    """Returns a run that was pickled."""
    run = model.stepped(step, saved=saved)
    run.inputs[:] = inputs
    return run


def _shared(values: Any) -> "Tuple[npt.NDArray[np.float64], Any]":
    """Returns an array and the buffer of Java in the same memory, with these values."""
    array = np.array(values, dtype=np.float64)
    if not array.size:
        array = np.zeros(1)[:0]
        buffer = jpype.JClass("java.nio.DoubleBuffer").allocate(0)
        return array, buffer
    octets = jpype.nio.convertToDirectBuffer(array.data.cast("B"))
    order = jpype.JClass("java.nio.ByteOrder").nativeOrder()
    return array, octets.order(order).asDoubleBuffer()
