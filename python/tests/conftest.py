"""What tests share."""

import math
import os
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Iterable
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


@pytest.fixture
def ctrl_c_ends():
    """Checks that Ctrl-C ends a call long before its end: the first of some that takes seconds, as a quick machine needs more work than a busy one."""

    def timed(call: Callable[[], object]) -> float:
        start = time.monotonic()
        call()
        return time.monotonic() - start

    def interrupted(call: Callable[[], object], after: float) -> float:
        """Seconds after which Ctrl-C, which comes after some, has ended a call; without end where the call was quicker."""
        timer = threading.Timer(after, os.kill, [os.getpid(), signal.SIGINT])
        start, took, has_ended = time.monotonic(), math.inf, False
        # Whoever starts tests in the background may have turned it off.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        try:
            timer.start()
            call()
            has_ended = True
            timer.cancel()
            timer.join()
        except KeyboardInterrupt:
            took = math.inf if has_ended else time.monotonic() - start
        finally:
            signal.signal(signal.SIGINT, before)
        return took

    def check(calls: Iterable[Callable[[], object]]) -> None:
        for call in calls:
            whole = timed(call)
            if whole > 2:
                break
        # Calls look for signals 20 times a second.
        assert whole > 0.5, f"{whole} s are too short to be interrupted: give this test a longer call"
        tried = []
        # What else the machine does may begin or end between the two calls.
        for _ in range(3):
            took = interrupted(call, whole / 8)
            if took < whole / 2:
                return
            tried.append(f"{took} s of {whole} s")
            whole = timed(call)
        pytest.fail("; ".join(tried))

    return check


@pytest.fixture(scope="session")
def church() -> voxtrace.Scene:
    return voxtrace.builtin("church", voxels=20_000)
