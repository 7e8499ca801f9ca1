"""Exceptions with the codes of docs/errors."""

from __future__ import annotations

import re
from typing import Any, Iterator, Optional
from contextlib import contextmanager

_CODE = re.compile(r"\b([MNS]-\d{3})\b")


class MechError(Exception):
    """Something cannot be used as it is given.

    ``code`` is the entry of the message catalogue, such as ``"S-082"``; empty if there is none.
    """

    def __init__(self, message: str, code: str = "") -> None:
        super().__init__(message)
        found = _CODE.search(message)
        self.code = code or (found.group(1) if found else "")


class ModelError(MechError):
    """A model file, or a name or value given for it, cannot be used.

    ``messages`` are all messages about it: what, where, and what to write instead.
    """

    def __init__(self, message: str, code: str, messages: "list[str]") -> None:
        super().__init__(message, code)
        self.messages = messages


class RunError(MechError):
    """A run could not go on.

    ``time`` is when, s; ``part`` the joint, body or state it happened at; ``advice`` what to do
    about it; ``rows`` the rows up to there, a Trajectory.
    """

    def __init__(
        self, message: str, code: str, time: float, part: str, advice: str, rows: Any
    ) -> None:
        super().__init__(message, code)
        self.time = time
        self.part = part
        self.advice = advice
        self.rows = rows


def translated(error: Any) -> Optional[Exception]:
    """Returns the Python exception for one of Java's; None if there is no fitting one."""
    from ._trajectory import Trajectory

    name = str(error.getClass().getName())
    message = str(error.getMessage())
    if name.endswith(".MechmlException"):
        said = list(error.diagnostics())
        return ModelError(
            message, str(said[0].code().code()), [str(one.toString()) for one in said]
        )
    if name.endswith(".RunFailedException"):
        failure = error.failure()
        rows = error.rows()
        return RunError(
            message,
            str(failure.code().code()),
            float(failure.time()),
            str(failure.part()),
            str(failure.advice()),
            Trajectory(rows.get()) if rows.isPresent() else None,
        )
    if name == "java.nio.file.NoSuchFileException":
        return FileNotFoundError(message)
    if name.startswith("java.nio.file.") or name == "java.io.IOException":
        return OSError(message)
    if name.endswith("ModelBuildException") or name == "java.lang.IllegalArgumentException":
        return MechError(message)
    return None


@contextmanager
def python_errors() -> Iterator[None]:
    """Turns the library's exceptions into those of this module."""
    from ._java import java_exception

    try:
        yield
    except java_exception() as error:
        found = translated(error)
        if found is None:
            raise
        raise found from None
