"""The rows of a run."""

from __future__ import annotations

import html
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._errors import MechError, python_errors
from ._java import java_class

if TYPE_CHECKING:
    from ._model import Model


_SHORT_SECONDS = 2.0


class Trajectory:
    """The rows of a run or of an analysis.

    ``motion["j1.q"]`` is a column, ``motion.time`` the first one, ``motion.values`` all of them as
    a matrix of one row per output time. None of them is a copy; write to a copy.
    """

    def __init__(self, java: Any, model: "Optional[Model]" = None) -> None:
        self._java = java
        self._model = model

    @cached_property
    def values(self) -> npt.NDArray[np.float64]:
        """All numbers, one row per output time and one column per quantity; not to be written to."""
        rows = int(self._java.rows())
        view = np.asarray(memoryview(self._java.values()), dtype=np.float64)
        values = view.reshape(rows, -1 if len(view) else len(self._columns))
        values.flags.writeable = False
        return values

    @cached_property
    def _columns(self) -> List[Tuple[str, str]]:
        return _names_and_units(self._java.columns())

    @cached_property
    def _index(self) -> Dict[str, int]:
        return {name: i for i, (name, _) in enumerate(self._columns)}

    @property
    def columns(self) -> List[str]:
        """The names of the columns, time first."""
        return [name for name, _ in self._columns]

    @property
    def units(self) -> Dict[str, str]:
        """The SI unit of each column, ``"1"`` for a pure number."""
        return dict(self._columns)

    @property
    def time(self) -> npt.NDArray[np.float64]:
        """The time of each row, s."""
        return self.values[:, 0]

    @cached_property
    def report(self) -> Dict[str, Any]:
        """What happened: how the run ended, its steps, its energy balance."""
        facts = self._java.report().asMap()
        return {str(e.getKey()): _plain(e.getValue()) for e in facts.entrySet()}

    @cached_property
    def complete(self) -> bool:
        """Whether the run came to its end; not if Ctrl-C stopped it."""
        return type(self._java.report().outcome()).__name__.endswith("Completed")

    def __getitem__(self, name: str) -> npt.NDArray[np.float64]:
        if name not in self._index:
            known = ", ".join(self.columns[:12])
            more = len(self._columns) - 12
            raise KeyError(
                f'there is no column "{name}"; there are {known}'
                + (f" and {more} more" if more > 0 else "")
            )
        return self.values[:, self._index[name]]

    def unit(self, name: str) -> str:
        """Returns the unit of a column."""
        self[name]
        return self._columns[self._index[name]][1]

    def __len__(self) -> int:
        return len(self.values)

    def __reduce__(self) -> "Tuple[Any, ...]":
        """Pickles the rows, the report and the model, so that they are the same elsewhere."""
        kept = {
            "values": np.array(self.values),
            "_columns": self._columns,
            "report": self.report,
            "complete": self.complete,
            "_text": self._text,
        }
        return _taken_up, (kept, self._model)

    def to_pandas(self) -> Any:
        """Returns a data frame indexed by time, the units in ``attrs["units"]``."""
        import pandas

        time = pandas.Index(self.time, name=self.columns[0])
        frame = pandas.DataFrame(self.values[:, 1:], index=time, columns=self.columns[1:])
        frame.attrs["units"] = self.units
        return frame

    def plot(self, *names: str, ax: Any = None) -> Any:
        """Plots columns over time, all if none is named; returns the axes."""
        if ax is None:
            import matplotlib.pyplot as plt

            ax = plt.subplots()[1]
        shown = names or tuple(self.columns[1:])
        for name in shown:
            ax.plot(self.time, self[name], label=f"{name} [{self.unit(name)}]")
        ax.set_xlabel(f"{self.columns[0]} [{self._columns[0][1]}]")
        ax.legend()
        return ax

    @cached_property
    def _text(self) -> str:
        return str(self._java.toString())

    def __repr__(self) -> str:
        return self._text

    def player(self) -> str:
        """Returns the player with this run: one HTML page with its curves, which fetches nothing.

        Where the rows lack the columns of the bodies, the model runs again with them.

        Raises MechError if these are the rows of an analysis, which has no motion.
        """
        if self._model is None:
            raise MechError("these rows are no motion in time, which a player could show")
        with python_errors():
            model = self._model._in_process()
            pictures = java_class("org.mechservice.view.model.ModelPictures")
            group = java_class("org.mechservice.solver.api.result.ColumnGroup")
            rows = self._java
            if rows is None or not any(name.endswith(".x") for name, _ in self._columns):
                shown = self._model._java.columns([group.BODIES, group.ENERGY])
                rows = shown.until(float(self.time[-1])).simulate()
            return str(pictures.player(model, rows))

    def _repr_html_(self) -> str:
        return self._table() + self._frame()

    def _frame(self) -> str:
        """Returns the player in a frame; nothing if it is not had within seconds."""
        if self._model is None or not len(self) or self.report["wallTime"] > _SHORT_SECONDS:
            return ""
        try:
            page = html.escape(self.player())
        except (MechError, RuntimeError):
            return ""
        return (
            f"<iframe srcdoc='{page}' sandbox='allow-scripts'"
            " style='width:100%;height:560px;border:0'></iframe>"
        )

    def _table(self) -> str:
        shown = self._columns[:8]
        head = "".join(f"<th>{html.escape(n)}<br>{html.escape(u)}</th>" for n, u in shown)
        picked = list(range(min(5, len(self))))
        picked += [i for i in (len(self) - 1,) if i > 4]
        body = "".join(
            "<tr>" + "".join(f"<td>{x:.6g}</td>" for x in self.values[i, : len(shown)]) + "</tr>"
            for i in picked
        )
        return (
            f"<p>{html.escape(repr(self))}</p>"
            f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
        )


def _taken_up(kept: Dict[str, Any], model: "Optional[Model]") -> Trajectory:
    """Returns rows that were pickled."""
    kept["values"].flags.writeable = False
    rows = Trajectory(None, model)
    rows.__dict__.update(kept)
    return rows


@lru_cache(maxsize=64)
def _names_and_units(columns: Any) -> List[Tuple[str, str]]:
    """Returns Java's columns as text; lists that are equal in Java are translated once."""
    return [(str(column.name()), str(column.unit())) for column in columns]


class LinearSystem:
    """The matrices of x' = A x + B u, y = C x + D u, with names and units.

    ``scipy.signal.StateSpace(system.A, system.B, system.C, system.D)`` takes them.
    """

    def __init__(self, java: Any) -> None:
        self.states: Dict[str, str] = _names(java.states())
        self.inputs: Dict[str, str] = _names(java.inputs())
        self.outputs: Dict[str, str] = _names(java.outputs())
        n, m, p = len(self.states), len(self.inputs), len(self.outputs)
        a, b, c, d = (np.array(one, dtype=np.float64) for one in java.matrices())
        self.A: npt.NDArray[np.float64] = a.reshape(n, n)
        self.B: npt.NDArray[np.float64] = b.reshape(n, m)
        self.C: npt.NDArray[np.float64] = c.reshape(p, n)
        self.D: npt.NDArray[np.float64] = d.reshape(p, m)

    def __repr__(self) -> str:
        return (
            f"<mechservice linear system: {len(self.states)} states,"
            f" inputs {list(self.inputs)}, outputs {list(self.outputs)}>"
        )


def _names(variables: Any) -> Dict[str, str]:
    return {str(one.name()): str(one.unit()) for one in variables}


def _plain(value: Any) -> Any:
    """Returns a fact of a report as Python writes it."""
    if value is None:
        return None
    name: Optional[str] = type(value).__name__
    if name in ("java.lang.Long", "java.lang.Integer"):
        return int(value)
    if name == "java.lang.Double":
        return float(value)
    if name == "java.lang.Boolean":
        return bool(value)
    return str(value)
