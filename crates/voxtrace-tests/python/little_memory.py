#!/usr/bin/env python3
"""The CPU tracer where memory is less than the scene: the picture, the time and the bytes read, with all memory and with parts of the file's size.

    sudo python3 little_memory.py target/release/voxtrace city.vxt --size 640x360 --spp 16 --parts 2 4

Linux, as root: each run goes into a control group (version 1 or 2) of its own with a limit on its memory, which counts the pages of the mapped file, after the file was
dropped from the system's cache. Ends with 1 where a picture is another one than with all memory. That the comparison sees a difference is tried with another seed.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time


class Group:
    """A control group with at most so many bytes of memory, or without a limit."""

    def __init__(self, limit):
        two = pathlib.Path("/sys/fs/cgroup/cgroup.controllers").exists()
        self.folder = pathlib.Path("/sys/fs/cgroup") / ("" if two else "memory") / f"voxtrace-{os.getpid()}"
        if two:
            pathlib.Path("/sys/fs/cgroup/cgroup.subtree_control").write_text("+memory")
        self.folder.mkdir()
        if limit:
            (self.folder / ("memory.max" if two else "memory.limit_in_bytes")).write_text(str(limit))

    def enter(self):
        (self.folder / "cgroup.procs").write_text(str(os.getpid()))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.folder.rmdir()


def drop(file):
    """Drops a file from the system's cache."""
    handle = os.open(file, os.O_RDONLY)
    os.fsync(handle)
    os.posix_fadvise(handle, 0, 0, os.POSIX_FADV_DONTNEED)
    os.close(handle)


def run(command, file, limit):
    """Seconds, and bytes read from the disk."""
    drop(file)
    with Group(limit) as group:
        start = time.monotonic()
        process = subprocess.Popen(command, preexec_fn=group.enter)
        _, status, used = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
        process.returncode = status
    if status != 0:
        sys.exit(f"{' '.join(command)} ended with {status}")
    return seconds, used


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("scene")
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--spp", default="16")
    parser.add_argument("--parts", type=int, nargs="+", default=[2, 4], help="parts of the file's bytes that memory is limited to")
    arguments = parser.parse_args()
    whole = os.path.getsize(arguments.scene)
    print(f"{arguments.scene}: {whole / 1e6:.0f} MB, {arguments.size}, {arguments.spp} samples of path")
    print("| memory at most | seconds | of the processors | read | picture |\n|---|---:|---:|---:|---|")
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "picture.png"
        command = [arguments.program, "render", arguments.scene, "-o", str(picture), "--traversal", "cpu", "--quiet"]
        command += ["--integrator", "path", "--size", arguments.size, "--spp", arguments.spp]
        expected = None
        for part in [None, *arguments.parts]:
            seconds, used = run(command, arguments.scene, whole // part if part else None)
            found = picture.read_bytes()
            expected = expected or found
            limit = f"{whole / part / 1e6:.0f} MB, a part of {part}" if part else "all"
            same = "the same" if found == expected else "ANOTHER ONE"
            processor = used.ru_utime + used.ru_stime
            print(f"| {limit} | {seconds:.1f} | {processor:.1f} | {used.ru_inblock * 512 / 1e6:.0f} MB | {same} |", flush=True)
            if found != expected:
                sys.exit(1)
        run([*command, "--seed", "7"], arguments.scene, None)
        if picture.read_bytes() == expected:
            sys.exit("the comparison does not see another seed")


if __name__ == "__main__":
    main()
