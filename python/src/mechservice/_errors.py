"""Exceptions with the codes of docs/errors."""

from __future__ import annotations

import re
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Iterator, List, Optional, Tuple, Union

if TYPE_CHECKING:
    from ._trajectory import Trajectory

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
        self,
        message: str,
        code: str,
        time: float,
        part: str,
        advice: str,
        rows: "Optional[Trajectory]",
    ) -> None:
        super().__init__(message, code)
        self.time = time
        self.part = part
        self.advice = advice
        self.rows = rows


class ServerError(MechError):
    """A server cannot be reached, or refuses a call."""


class RunInterrupted(KeyboardInterrupt):
    """Ctrl-C has ended a run.

    ``rows`` are those up to there, a Trajectory; ``runs`` the values and trajectories that a sweep
    had done before.
    """

    def __init__(self, rows: "Trajectory") -> None:
        super().__init__(f"the run was interrupted; its {len(rows)} rows are kept in .rows")
        self.rows = rows
        self.runs: "List[Tuple[Union[float, str], Trajectory]]" = []


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
    if name.endswith(".InvalidModelException"):
        told = list(error.messages())
        code = str(told[0].code() if told else error.code())
        return ModelError(message, code, [str(one.toString()) for one in told])
    if name.startswith("org.mechservice.client.failure."):
        code = str(error.code())
        kind = MechError if name.endswith(".InvalidOptionException") else ServerError
        return kind(message if message.startswith(code) else f"{code} {message}", code)
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
    if name.endswith("ModelBuildException") or name in (
        "java.lang.IllegalArgumentException",
        "java.lang.IllegalStateException",
    ):
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
