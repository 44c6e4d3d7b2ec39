"""What tests share."""

import os
import subprocess
from pathlib import Path

import numpy
import pytest

import voxtrace


@pytest.fixture
def command_line() -> Path:
    """The program of this repository: the other way to the same pictures."""
    program = os.environ.get("VOXTRACE_PROGRAM")
    if not program:
        pytest.skip("VOXTRACE_PROGRAM names no program")
    return Path(program)


@pytest.fixture
def run(command_line: Path):
    def run(*arguments: object) -> str:
        words = [str(command_line), *map(str, arguments)]
        return subprocess.run(words, check=True, capture_output=True, text=True).stdout

    return run


@pytest.fixture
def random() -> numpy.random.Generator:
    return numpy.random.default_rng(7)


@pytest.fixture(scope="session")
def church() -> voxtrace.Scene:
    return voxtrace.builtin("church", voxels=20_000)
