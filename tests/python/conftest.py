"""Where the cases and the program are."""

import os
import pathlib

import pytest


@pytest.fixture(scope="session")
def cases() -> pathlib.Path:
    return pathlib.Path(os.environ["DELABOLE_SOURCE"]) / "cases"


@pytest.fixture(scope="session")
def program() -> pathlib.Path:
    return pathlib.Path(os.environ["DELABOLE_BUILD"]) / "bin" / "delabole"
