"""The rows of a run."""

from __future__ import annotations

import html
from functools import cached_property
from typing import Any, Dict, List, Optional, Tuple

import numpy as np


class Trajectory:
    """The rows of a run or of an analysis.

    ``motion["j1.q"]`` is a column, ``motion.time`` the first one, ``motion.values`` all of them as
    a matrix of one row per output time. None of them is a copy; write to a copy.
    """

    def __init__(self, java: Any) -> None:
        self._java = java
        rows = int(java.rows())
        view = np.asarray(memoryview(java.values())) if rows else np.empty(0)
        self.values: np.ndarray = view.reshape(rows, int(java.columns().size()))
        self.values.flags.writeable = False

    @cached_property
    def _columns(self) -> List[Tuple[str, str]]:
        return [(str(c.name()), str(c.unit())) for c in self._java.columns()]

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
    def time(self) -> np.ndarray:
        """The time of each row, s."""
        return self.values[:, 0]

    @property
    def report(self) -> Dict[str, Any]:
        """What happened: how the run ended, its steps, its energy balance."""
        facts = self._java.report().asMap()
        return {str(e.getKey()): _plain(e.getValue()) for e in facts.entrySet()}

    @property
    def complete(self) -> bool:
        """Whether the run came to its end; not if Ctrl-C stopped it."""
        return type(self._java.report().outcome()).__name__.endswith("Completed")

    def __getitem__(self, name: str) -> np.ndarray:
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
        return int(self.values.shape[0])

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

    def __repr__(self) -> str:
        return str(self._java.toString())

    def _repr_html_(self) -> str:
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
