"""Ctrl-C while Java is at work."""

from __future__ import annotations

import signal
import socket
import threading
from functools import lru_cache
from importlib import import_module
from queue import SimpleQueue
from typing import Any, Callable, Optional, Tuple

_LOOK_SECONDS = 0.05

# Without the enumerations of the module signal, whose look-up takes ten times as long.
_handler_of: Callable[[int], Any] = import_module("_signal").getsignal
_set_handler: Callable[[int, Any], Any] = import_module("_signal").signal

_wake_up: Callable[..., int] = import_module("_signal").set_wakeup_fd
_thread = threading.get_ident
_MAIN = threading.main_thread().ident

_OTHER_SIGNALS = [
    int(getattr(signal, name))
    for name in ("SIGALRM", "SIGTERM", "SIGHUP", "SIGUSR1", "SIGUSR2", "SIGVTALRM", "SIGPROF")
    if hasattr(signal, name)
]


class _Worker:
    """A thread that runs models while the main thread listens to signals.

    It lives as long as the process: a thread that Java does not know yet costs a tenth of a
    millisecond.
    """

    def __init__(self) -> None:
        self._jobs: "SimpleQueue[Tuple[Any, Any, _Answer]]" = SimpleQueue()
        threading.Thread(target=self._work, name="mechservice-run", daemon=True).start()

    def _work(self) -> None:
        while True:
            java, control, answer = self._jobs.get()
            try:
                answer.rows = java.simulate(control)
            except BaseException as error:  # handed to the caller's thread
                answer.error = error
            answer.done.release()
            del java, control, answer

    def simulate(self, java: Any, control: Any) -> Tuple[Any, bool]:
        """Runs a model; returns its rows in Java and whether Ctrl-C stopped it."""
        answer = _Answer()
        self._jobs.put((java, control, answer))
        interrupted = False
        while True:
            try:
                if answer.done.acquire(timeout=_LOOK_SECONDS):
                    break
            except KeyboardInterrupt:
                interrupted = True
                control.stop()
        if answer.error is not None:
            raise answer.error
        return answer.rows, interrupted


class _Answer:
    """What a run has given, once its lock can be acquired."""

    def __init__(self) -> None:
        self.done = threading.Lock()
        self.done.acquire()
        self.rows: Any = None
        self.error: Optional[BaseException] = None


class _Listener:
    """A thread that hears of Ctrl-C while the main thread itself is at work in Java.

    Python's own handler is called when the work has come back, but the number of a signal is sent to
    this thread's socket as soon as it arrives. Without a switch between threads a run of a third of
    a millisecond takes a fifth less time than in a ``_Worker``.
    """

    def __init__(self) -> None:
        self._heard, self._told = socket.socketpair()
        self._told.setblocking(False)
        self._place = self._told.fileno()
        self._stop: "Optional[Callable[[], Any]]" = None
        self._stopped: "Optional[Callable[[], Any]]" = None
        self._acted = threading.Semaphore(0)
        threading.Thread(target=self._listen, name="mechservice-signals", daemon=True).start()

    def _listen(self) -> None:
        while True:
            for number in self._heard.recv(64):
                stop = self._stop
                if number == signal.SIGINT and stop is not None:
                    self._stopped = stop
                    stop()
                    self._acted.release()

    def call(self, stop: Callable[[], Any], work: Callable[..., Any], *given: Any) -> Any:
        """Does work, and calls ``stop`` as soon as Ctrl-C is pressed.

        None, and nothing is done, if another package hears of signals in this way.
        """
        self._stop = stop
        other = _wake_up(self._place, warn_on_full_buffer=False)
        try:
            return work(*given) if other == -1 else None
        finally:
            _wake_up(other)
            self._stop = None

    def simulate(self, java: Any, control: Any) -> "Optional[Tuple[Any, bool]]":
        """Runs a model; returns its rows in Java and whether Ctrl-C stopped it.

        None, and nothing has run, if another package hears of signals in this way.
        """
        presses = 0

        def pressed(*_: Any) -> None:
            nonlocal presses
            presses += 1

        stop = control.stop
        # Python's own handler would raise KeyboardInterrupt between the end of the run and the place
        # of its rows, which were lost then.
        kept = _set_handler(signal.SIGINT, pressed)
        try:
            rows = self.call(stop, java.simulate, control)
        finally:
            _set_handler(signal.SIGINT, kept)
        if presses:
            self._acted.acquire(timeout=1)
        return None if rows is None else (rows, presses > 0 or self._stopped is stop)


def cancellable(work: Callable[[], Any], stop: threading.Event) -> Any:
    """Does work in a thread of its own; Ctrl-C sets the event and is raised when the work ends."""
    answer = _Answer()

    def run() -> None:
        try:
            answer.rows = work()
        except BaseException as error:  # handed to the caller's thread
            answer.error = error
        answer.done.release()

    threading.Thread(target=run, name="mechservice-report", daemon=True).start()
    while True:
        try:
            if answer.done.acquire(timeout=_LOOK_SECONDS):
                break
        except KeyboardInterrupt:
            stop.set()
    if stop.is_set():
        raise KeyboardInterrupt("the report was interrupted; what was measured is kept")
    if answer.error is not None:
        raise answer.error
    return answer.rows


@lru_cache(maxsize=None)
def _worker() -> _Worker:
    return _Worker()


@lru_cache(maxsize=None)
def _listener() -> _Listener:
    return _Listener()


def _only_interrupts() -> bool:
    """Returns whether Ctrl-C raises KeyboardInterrupt and no other signal calls Python."""
    return _handler_of(signal.SIGINT) is signal.default_int_handler and not any(
        map(callable, map(_handler_of, _OTHER_SIGNALS))
    )


def interruptible(java: Any, control: Any) -> Tuple[Any, bool]:
    """Runs a model; Ctrl-C in the main thread stops it.

    Returns its rows in Java, and whether it was stopped so.
    """
    if threading.current_thread() is not threading.main_thread():
        return java.simulate(control), False
    done = _listener().simulate(java, control) if _only_interrupts() else None
    return done or _worker().simulate(java, control)


def stepping(stop: Callable[[], Any], step: Callable[..., bool], *given: Any) -> bool:
    """Takes a step in Java; Ctrl-C in the main thread calls ``stop`` while it is under way."""
    if _thread() == _MAIN and _handler_of(signal.SIGINT) is signal.default_int_handler:
        goes_on = _listener().call(stop, step, *given)
        if goes_on is not None:
            return bool(goes_on)
    return bool(step(*given))
