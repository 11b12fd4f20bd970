"""Where the cases and the program are, and Ctrl-C."""

import os
import pathlib
import signal
import threading

import pytest


@pytest.fixture(scope="session")
def cases() -> pathlib.Path:
    return pathlib.Path(os.environ["DELABOLE_SOURCE"]) / "cases"


@pytest.fixture(scope="session")
def program() -> pathlib.Path:
    return pathlib.Path(os.environ["DELABOLE_BUILD"]) / "bin" / "delabole"


class Interruption:
    """Ctrl-C while work goes on that has told of its progress."""

    def __init__(self) -> None:
        self._timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
        self._begun = False

    def soon(self, share: float, what: str) -> None:
        if not self._begun:
            self._begun = True
            self._timer.start()
