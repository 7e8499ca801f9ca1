"""Models at a server."""

from __future__ import annotations

import os
from types import TracebackType
from typing import Any, Iterable, Optional, Type, Union

from ._errors import python_errors
from ._java import java_class, java_path
from ._model import Model, consent


class Connection:
    """A connection to a MechService: ``read`` and ``parse`` return models that run there."""

    def __init__(self, java: Any) -> None:
        self._java = java

    @property
    def server(self) -> str:
        """The name and version of the server."""
        service = self._java.service()
        return f"{service.name()} {service.version()}"

    def read(
        self,
        path: "Union[str, os.PathLike[str]]",
        *,
        user_code: Iterable[str] = (),
        unconfined: bool = False,
    ) -> Model:
        """Sends a MechML file to the server; the model has the verbs of ``mechservice.read``.

        user_code: the folders whose classes of forces are sent; no others are, also if they lie
        beside the model.
        unconfined: run them also here, in steps, where the operating system cannot confine them.
        """
        with python_errors():
            file = java_path(path)
            trusted = consent(user_code, unconfined)
            library = java_class("org.mechservice.library.MechModel")
            return Model(self._java.read(file, trusted), lambda: library.read(file, trusted))

    def parse(self, mechml: str, name: str = "model") -> Model:
        """Sends MechML text to the server."""
        with python_errors():
            library = java_class("org.mechservice.library.MechModel")
            return Model(self._java.of(name, mechml), lambda: library.of(name, mechml))

    def close(self) -> None:
        """Ends the connection and its models at the server."""
        self._java.close()

    def __enter__(self) -> "Connection":
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<mechservice connection to {self.server}>"


def connect(
    url: str, *, identity: "Union[str, os.PathLike[str], None]" = None
) -> Connection:
    """Connects to a server, where models then run with the same bits.

    url: ``host:port`` or the URL that the server prints; several, separated by commas, where the
    next is used when one is gone.
    identity: folder with the keys of this client, for a server over TLS.

    Raises ServerError if no server answers there.
    """
    with python_errors():
        connection = java_class("org.mechservice.client.MechConnection")
        if identity is None:
            return Connection(connection.open(url))
        keys = java_class("org.mechservice.orb.tls.TlsIdentity").load(java_path(identity))
        cache = java_class("org.mechservice.client.jar.JarCache").ofUser()
        optional = java_class("java.util.Optional")
        return Connection(connection.open(url, cache, optional.of(keys)))
