"""Models built in code."""

from __future__ import annotations

import os
from typing import Any, Callable, Union

from ._errors import python_errors
from ._java import java_class, java_path
from ._model import Model, parse, read

_LIBRARY = "org.mechservice.library."


class Element:
    """An element of a model that is built: each verb is that of the class in Java."""

    def __init__(self, java: Any) -> None:
        self._java = java

    def __getattr__(self, verb: str) -> Callable[..., Any]:
        if verb.startswith("_") or not hasattr(self._java, verb):
            raise AttributeError(f'{type(self).__name__} has no verb "{verb}"')
        method = getattr(self._java, verb)

        def call(*values: Any) -> Any:
            with python_errors():
                return self._python(method(*values))

        return call

    def _python(self, java: Any) -> Any:
        if java is self._java or java == self._java:
            return self
        if isinstance(java, java_class(_LIBRARY + "MechModel")):
            return Model(java, made=(parse, (str(java.mechml()), str(java.name()))))
        if isinstance(java, java_class(_LIBRARY + "BuiltElement")):
            kind = _KINDS.get(str(java.getClass().getSimpleName()), Element)
            return kind(java)
        return str(java)

    def __reduce__(self) -> "str":
        raise TypeError("what is being built cannot be pickled; pickle its model() or its mechml()")

    def __repr__(self) -> str:
        return f"<{self._java.getClass().getSimpleName()}>"


class BodyElement(Element):
    """A body or the root."""


class ConnectionElement(Element):
    """A joint, a constraint or a force between two bodies."""


class SimulationElement(Element):
    """A simulation."""


class OtherElement(Element):
    """An element that has no verbs besides ``set``, ``unit`` and ``element``."""


_KINDS = {
    kind.__name__: kind
    for kind in (BodyElement, ConnectionElement, SimulationElement, OtherElement)
}


class Builder(Element):
    """Builds a model with the verbs of ``MechanismBuilder`` in docs/library.md.

    mass_units, length_units: those of bare numbers, as in MechML.

    >>> import mechservice
    >>> arm = mechservice.Builder("Pendulum")
    >>> ground = arm.root("ground")
    >>> rod = arm.body("bar").cylinder(0.01, "0;0;0", "0;0;-1").set("mass", 2)
    >>> hinge = arm.joint("hinge", "R").between("ground", "bar").at(0, 0, 0).axis(0, 1, 0)
    >>> run = arm.gravity(0, 0, -9.81).dynamic(1, 0.5)
    >>> start = arm.start("hinge", 0.3, 0)
    >>> arm.model().simulate()["hinge.q"].round(3).tolist()
    [0.3, -0.099, -0.235]
    >>> try:
    ...     arm.joint("wrist", "RR")
    ... except mechservice.MechError as error:
    ...     print(error.code)
    M-009

    Raises MechError at once for an element, attribute, word or unit that is none, and ModelError
    in ``model()`` and ``mechml()`` for what is wrong with the whole.
    """

    def __init__(self, name: str, mass_units: str = "kg", length_units: str = "m") -> None:
        with python_errors():
            super().__init__(
                java_class(_LIBRARY + "MechanismBuilder").of(name, mass_units, length_units)
            )

    def writeMechml(self, path: "Union[str, os.PathLike[str]]") -> Model:
        """Writes the model to a file and reads it from there."""
        with python_errors():
            self._java.writeMechml(java_path(path))
        return read(path)
