"""What everything that a cluster makes has in common: parts that go to workers and come back, and scenes that they keep."""

from __future__ import annotations

import contextlib
import hashlib
import os
import stat
import statistics
import tempfile
import threading
import time
import uuid
import warnings
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import _voxtrace
from .._voxtrace import Renderer, Scene, __version__

#: A part that takes so many times as long as others is given to another worker as well.
PATIENCE = 3.0
#: The same, in seconds, before the first part is there.
FIRST_PATIENCE = 30.0

#: Parts of voxels: a worker from which nothing has come for so many seconds is no longer waited for. Dask itself sees sooner that one is gone.
WORK_PATIENCE = 120.0

#: Least memory of a part, in bytes.
LEAST_MEMORY = 64 << 20

#: Seconds between two looks for results.
GLANCE = 0.01

#: Parts for each worker, so that quick ones take more of them.
PARTS_A_WORKER = 4

#: Seconds that a worker's disk keeps a scene that nobody has asked for again.
KEPT = 24 * 3600.0


@dataclass(frozen=True)
class Packed:
    """What workers have to know of a scene besides the bytes of its file."""

    #: The hash of the bytes.
    key: str
    #: `Scene.clip`, which files do not hold.
    clip: tuple[tuple[float, ...], tuple[float, ...]] | None
    #: That of the package which asks.
    version: str


#: Renderers of a worker's process, by the scene, the device and what else they are made with: scenes are sent, unpacked and put on the device once.
_renderers: dict[tuple[Packed, str, str], Renderer] = {}
#: Whose turn it is: Dask gives a worker as many parts at once as it has threads, and a renderer makes one after the other.
_turn = threading.Lock()
#: Where this process keeps scenes on its own, until it ends.
_own_folder: tempfile.TemporaryDirectory[str] | None = None


def check_counts(**counts: int | None) -> None:
    """Raises `ValueError` for a count below 0."""
    for name, count in counts.items():
        if count is not None and count < 0:
            raise ValueError(f"{name} is a whole number from 0 on, not {count}")


def depth_of(levels: int | str | None) -> int:
    """How many levels of detail a file is given, -1 for all of them."""
    if levels == "all":
        return -1
    depth = int(levels or 0)
    check_counts(levels=depth)
    return depth


def number_of_workers(client: Any) -> int:
    """How many workers there are now, at least one."""
    return max(1, len(client.scheduler_info(n_workers=-1)["workers"]))


def usual_parts(client: Any) -> int:
    """How many parts there are for the workers that there are now."""
    return PARTS_A_WORKER * number_of_workers(client)


def memory_of_part(client: Any, memory: int) -> int:
    """What a part may take of the memory, in bytes, that a worker has for all parts that it makes at once."""
    workers = client.scheduler_info(n_workers=-1)["workers"].values()
    at_once = max((worker["nthreads"] for worker in workers), default=1)
    return max(memory // at_once, LEAST_MEMORY)


def threads_of_hosts(client: Any) -> dict[str, int]:
    """For each worker, by its address, how many threads the workers of its host have together."""
    workers = client.scheduler_info(n_workers=-1)["workers"]
    of_hosts: dict[str, int] = {}
    for worker in workers.values():
        of_hosts[worker["host"]] = of_hosts.get(worker["host"], 0) + worker["nthreads"]
    return {address: of_hosts[worker["host"]] for address, worker in workers.items()}


def elsewhere(workers: list[str]) -> dict[str, Any]:
    """Options of `submit`, for work that these workers should do: preferred, not demanded, as the others may be all that is left."""
    return {"workers": workers, "allow_other_workers": True} if workers else {}


def sent_bytes(client: Any, data: bytes, retries: int, workers: list[str]) -> Any:
    """Bytes that many parts need, a scene's, as a result on a worker: unlike what is scattered, it is made anew where that worker is lost."""
    with warnings.catch_warnings():
        # They may be many, and go along once.
        warnings.filterwarnings("ignore", message="Sending large graph")
        return client.submit(bytes, data, pure=False, retries=retries, **elsewhere(workers))


def gathered(
    client: Any,
    submit: Callable[[list[int], list[str]], dict[Any, int]],
    parts: list[int],
    take: Callable[[int, Any], object],
    progress: Callable[[float], object] | None,
    least_patience: float = 2.0,
    rounds: int = 1,
) -> None:
    """Has parts made by the workers, and gives what they are to `take` as they come, each once.

    `submit(parts, workers)` begins parts, preferably on these workers; their results are pairs of the worker's address and what the part is.
    Parts that keep everybody waiting, for `least_patience` seconds at least, are begun a second time elsewhere, and whichever is there first counts. `rounds`: of how many
    tasks one after the other a part is.
    """
    from dask import distributed

    waiting = submit(parts, []) if parts else {}
    # Gives each result once it is here, so that a worker that stands still with what it has made holds up no other's. It has no types.
    as_completed: Any = distributed.as_completed
    results = as_completed(list(waiting), with_results=True)
    there: set[int] = set()
    alive: set[str] = set()
    took: deque[float] = deque(maxlen=64)
    last, silences = time.monotonic(), 0
    try:
        while len(there) < len(parts):
            come = results.next_batch(block=False)
            if not come:
                time.sleep(GLANCE)
            for future, result in come:
                part = waiting.pop(future)
                if future.status != "finished":
                    # Raises what the part has raised.
                    future.result()
                worker, made = result
                if part not in there:
                    take(part, made)
                    there.add(part)
                    alive.add(worker)
                    now = time.monotonic()
                    took.append(now - last)
                    last, silences = now, 0
            if progress:
                progress(len(there) / len(parts))
            rest = [part for part in parts if part not in there]
            patience = max(least_patience, PATIENCE * statistics.median(took) if took else FIRST_PATIENCE * rounds)
            # Twice as long each time: parts may take long, and each time the scene is sent anew.
            is_late = time.monotonic() - last > patience * 2**silences
            if rest and is_late:
                again = submit(rest, sorted(alive))
                results.update(list(again))
                waiting |= again
                alive.clear()
                last, silences = time.monotonic(), silences + 1
    finally:
        # What nobody waits for any more, or after a failure.
        client.cancel(list(waiting), force=True)


def made_by_workers(
    client: Any,
    work: Callable[..., Any],
    common: Any,
    arguments: list[tuple[Any, ...]],
    survey: bytes | None,
    retries: int,
    tell: Callable[[float], object] | None,
) -> list[Any]:
    """What `work(common, survey, *arguments)` makes of each of the arguments on the workers: pairs of their address and a result, or an exception that is raised here."""

    def submit(missing: list[int], workers: list[str]) -> dict[Any, int]:
        sent = None if survey is None else sent_bytes(client, survey, retries, workers)
        # In turns: a worker that may have several at once would be given them all.
        there = workers or sorted(client.scheduler_info(n_workers=-1)["workers"])
        begun: dict[Any, int] = {}
        for at, number in enumerate(missing):
            where = elsewhere([there[at % len(there)]] if there else [])
            begun[client.submit(work, common, sent, *arguments[number], pure=False, retries=retries, **where)] = number
        return begun

    made: dict[int, Any] = {}

    def take(number: int, found: Any) -> None:
        if isinstance(found, Exception):
            raise found
        made[number] = found

    gathered(client, submit, list(range(len(arguments))), take, tell, WORK_PATIENCE)
    return [made[number] for number in range(len(arguments))]


def made_by_one(client: Any, work: Callable[..., Any], common: Any, survey: bytes, arguments: tuple[Any, ...], retries: int) -> Any:
    """What `work(common, survey, threads, *arguments)` makes on one worker, however long it takes, or an exception that is raised here.

    `threads`: the threads of all workers of each host, by the workers' addresses, as those of the same host wait for this one.
    """
    sent = sent_bytes(client, survey, retries, [])
    _, made = client.submit(work, common, sent, threads_of_hosts(client), *arguments, pure=False, retries=retries).result()
    if isinstance(made, Exception):
        raise made
    return made


def write_whole(path: Path, content: bytes) -> None:
    """Writes a file that is there whole or not at all. Processes of several machines may write it at once, and their numbers may be the same."""
    part = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        part.write_bytes(content)
        part.replace(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def removed(place: Path, made: list[Path]) -> None:
    """Removes what was made on the way, what workers that were killed have left too, and nothing else."""
    for file in made:
        file.unlink(missing_ok=True)
        for left in place.glob(f".{file.name}.*"):
            left.unlink(missing_ok=True)
    with contextlib.suppress(OSError):
        place.rmdir()


def packed_scene(scene: Scene) -> tuple[bytes, Packed]:
    """The scene as the bytes of a file, and what else there is to know of it."""
    data = scene.to_bytes()
    clip = scene.clip
    corners = None if clip is None else (tuple(clip[0]), tuple(clip[1]))
    return data, Packed(hashlib.sha256(data).hexdigest(), corners, __version__)


@contextlib.contextmanager
def renderer_of(data: bytes, packed: Packed, device: str, kind: str, **options: Any) -> Iterator[Renderer]:
    """The renderer of this process for the scene of a file's bytes, for one of its threads at a time; `kind` tells apart those of other options."""
    if packed.version != __version__:
        raise RuntimeError(f"a worker has voxtrace {__version__}, and who asks has {packed.version}: their pictures may differ")
    with _turn:
        renderer = _renderers.get((packed, device, kind))
        if renderer is None:
            # One scene at a time lies on a device.
            _renderers.clear()
            scene = _unpacked(data, packed.key)
            scene.clip = packed.clip
            renderer = _renderers[packed, device, kind] = Renderer(scene, device=device, **options)
        yield renderer


def own_threads(threads: dict[str, int]) -> int:
    """The threads for work that the other workers of this host wait for, of `threads_of_hosts`."""
    return threads.get(address_of_worker(), 0)


def address_of_worker() -> str:
    """The address of the worker that this runs on."""
    from dask import distributed

    worker: Any = distributed.get_worker()  # type: ignore[no-untyped-call, unused-ignore]
    return str(worker.address)


def _unpacked(data: bytes, key: str) -> Scene:
    """The scene of a file's bytes, which stays on the worker's disk for the next process that wants it, and not for ever."""
    folder = _folder()
    path = folder / f"{key}.vxt"
    with contextlib.suppress(FileNotFoundError):
        # It is wanted now. Another process that has just found it too old may remove it all the same.
        os.utime(path)
        return _voxtrace.open(path)
    _forget_old(folder)
    write_whole(path, data)
    return _voxtrace.open(path)


def _folder() -> Path:
    """Where scenes stay on the worker's disk: a folder of this user alone, as whoever else writes there would choose what is traced.

    Its name is known, and others may take it before: then this process has a folder of its own.
    """
    global _own_folder
    user = os.getuid() if hasattr(os, "getuid") else None
    folder = Path(tempfile.gettempdir()) / f"voxtrace-{user or 0}"
    with contextlib.suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    # Not what a link leads to.
    found = folder.lstat()
    is_alone = user is None or (found.st_uid == user and not found.st_mode & 0o077)
    if stat.S_ISDIR(found.st_mode) and is_alone:
        return folder
    if _own_folder is None:
        _own_folder = tempfile.TemporaryDirectory(prefix="voxtrace-")
    return Path(_own_folder.name)


def _forget_old(folder: Path) -> None:
    """Removes the scenes that were not asked for lately. Who has one open keeps it."""
    for file in folder.iterdir():
        with contextlib.suppress(OSError):
            if time.time() - file.stat().st_mtime > KEPT:
                file.unlink()
