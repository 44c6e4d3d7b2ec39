"""What stands in docstrings and stubs is so."""

import doctest
import subprocess
import sys
from pathlib import Path

import pytest

import voxtrace

FOLDER = Path(__file__).parent.parent


def test_every_example_of_a_docstring_works():
    finder = doctest.DocTestFinder(recurse=True)
    runner = doctest.DocTestRunner()
    found = finder.find(voxtrace, "voxtrace", module=False)
    for name in voxtrace.__all__:
        if isinstance(value := getattr(voxtrace, name), type):
            found += finder.find(value, name, module=False, globs={})
    with_examples = [example for example in found if example.examples]
    assert len(with_examples) >= 9
    for example in with_examples:
        assert runner.run(example).failed == 0, example.name


def test_everything_public_has_a_docstring():
    for name in voxtrace.__all__:
        value = getattr(voxtrace, name)
        if name in ("BUILTIN_SCENES", "__version__"):
            continue
        assert value.__doc__, name
        for member in vars(value) if isinstance(value, type) else []:
            if not member.startswith("_"):
                assert getattr(value, member).__doc__, f"{name}.{member}"


@pytest.mark.parametrize(
    "checker",
    [
        ["mypy", "--strict", "-p", "voxtrace"],
        ["mypy", "--strict", "tests/typing_of_users.py"],
        ["mypy.stubtest", "voxtrace._voxtrace", "--concise"],
        ["pyright", "--pythonpath", sys.executable, "tests/typing_of_users.py"],
    ],
    ids=["mypy", "mypy-of-users", "stubtest", "pyright"],
)
def test_types_are_what_checkers_accept(checker):
    pytest.importorskip(checker[0].split(".")[0])
    done = subprocess.run([sys.executable, "-m", *checker], cwd=FOLDER, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
