"""The shaders of pages on a GPU, without a browser: real-time light and films of a scene by WebGPU (wgpu-native), with the milliseconds of each step.

`words gpu SCENE.vxt 1920x1080 FOLDER CAMERA...` of the crate `voxtrace-web` writes FOLDER; `cargo xtask web` the shaders. Needs the package `wgpu`.

    python web/measure/on_gpu.py FOLDER web/wasm [--samples N] [--pictures FOLDER] [--film FILE]

It does what `gpu-scene.ts` and `gpu-real-time.ts` do in pages. The first line says which device traced. `--film` names a film file of the same picture by
`voxtrace render SCENE.vxt --size … --samples N --traversal cpu --checkpoint FILE`: pixels whose words differ are counted, and the exit code is 1 where there are any.
"""

import argparse
import math
import re
import struct
import sys
import time
from pathlib import Path

import wgpu

WORKGROUP = 64
MOST_PATHS = 1 << 18
SCENE = {"cells": 0, "bricks": 1, "brickMaterials": 2, "records": 3, "environment": 19}
READ, WRITTEN, UNIFORM = "read-only-storage", "storage", "uniform"
FILM = {**dict.fromkeys(SCENE.values(), READ), **dict.fromkeys((10, 15, 22), WRITTEN), **dict.fromkeys((9, 16, 23), UNIFORM)}
LOOKS = {**dict.fromkeys((22, 26, 25), WRITTEN), **dict.fromkeys((9, 16, 23, 24), UNIFORM)}
REAL_TIME = {**dict.fromkeys(SCENE.values(), READ), **dict.fromkeys((22, 26, 27), WRITTEN), **dict.fromkeys((9, 16, 23, 24), UNIFORM)}
PIXELS = {29: READ, **dict.fromkeys((22, 26, 27, 25, 12), WRITTEN), **dict.fromkeys((9, 24), UNIFORM)}
FILTER = "filter_begin filter_compare filter_noise filter_tolerance filter_level_0 filter_level_1 filter_level_2 filter_level_3 filter_level_4 filter_end filter_across filter_picture"


class Gpu:
    """Buffers by the numbers of their bindings, modules, and the time that submits take."""

    def __init__(self, largest: int) -> None:
        adapter = wgpu.gpu.request_adapter_sync(power_preference="high-performance")
        limits = {name: min(largest, adapter.limits[name]) for name in ("max-storage-buffer-binding-size", "max-buffer-size")}
        features = ["timestamp-query"] if "timestamp-query" in adapter.features else []
        self.measures = False
        self.device = adapter.request_device_sync(required_limits=limits, required_features=features)
        self.info = adapter.info
        self.buffers: dict[int, wgpu.GPUBuffer] = {}
        self.steps: dict[str, float] = {}
        self.has_clock = bool(features)
        self.queries = self.device.create_query_set(type="timestamp", count=2) if features else None
        self.ticks = self.device.create_buffer(size=16, usage=wgpu.BufferUsage.QUERY_RESOLVE | wgpu.BufferUsage.COPY_SRC)

    def storage(self, binding: int, size: int, usage: int = 0) -> None:
        usage |= wgpu.BufferUsage.STORAGE | wgpu.BufferUsage.COPY_DST | wgpu.BufferUsage.COPY_SRC
        self.buffers[binding] = self.device.create_buffer(size=max(size, 256), usage=usage)

    def uniform(self, binding: int) -> None:
        self.buffers[binding] = self.device.create_buffer(size=1024, usage=wgpu.BufferUsage.UNIFORM | wgpu.BufferUsage.COPY_DST)

    def write(self, binding: int, data: bytes, offset: int = 0) -> None:
        self.device.queue.write_buffer(self.buffers[binding], offset, data)

    def words(self, binding: int, *words: int) -> None:
        self.write(binding, struct.pack(f"<{len(words)}I", *words))

    def read(self, binding: int, size: int) -> memoryview:
        return self.device.queue.read_buffer(self.buffers[binding], 0, size)

    def module(self, code: str, bindings: dict[int, str], constants: dict[int, int]) -> "Module":
        return Module(self, code, bindings, constants)


class Module:
    """A module of shaders: a pipeline for each entry point, made when it is first used."""

    def __init__(self, gpu: Gpu, code: str, bindings: dict[int, str], constants: dict[int, int]) -> None:
        self.gpu, self.bindings, self.pipelines = gpu, bindings, {}
        self.module = gpu.device.create_shader_module(code=code)
        ids = {int(number) for number in re.findall(r"@id\((\d+)\)", code)}
        self.constants = {str(number): float(value) for number, value in constants.items() if number in ids}
        entries = [{"binding": number, "visibility": wgpu.ShaderStage.COMPUTE, "buffer": {"type": kind}} for number, kind in bindings.items()]
        self.layout = gpu.device.create_bind_group_layout(entries=entries)
        self.pipeline_layout = gpu.device.create_pipeline_layout(bind_group_layouts=[self.layout])
        self.group = None

    def pipeline(self, entry: str) -> wgpu.GPUComputePipeline:
        if entry not in self.pipelines:
            compute = {"module": self.module, "entry_point": entry, "constants": self.constants}
            self.pipelines[entry] = self.gpu.device.create_compute_pipeline(layout=self.pipeline_layout, compute=compute)
        return self.pipelines[entry]

    def bind(self) -> None:
        entries = [{"binding": number, "resource": {"buffer": self.gpu.buffers[number], "offset": 0, "size": self.gpu.buffers[number].size}} for number in self.bindings]
        self.group = self.gpu.device.create_bind_group(layout=self.layout, entries=entries)

    def run(self, encoder: wgpu.GPUCommandEncoder, entry: str, groups: int | None, indirect: wgpu.GPUBuffer | None = None) -> None:
        measured = self.gpu.has_clock and self.gpu.measures
        more = {"timestamp_writes": {"query_set": self.gpu.queries, "beginning_of_pass_write_index": 0, "end_of_pass_write_index": 1}} if measured else {}
        pass_ = encoder.begin_compute_pass(**more)
        pass_.set_pipeline(self.pipeline(entry))
        pass_.set_bind_group(0, self.group)
        if indirect is None:
            pass_.dispatch_workgroups(groups)
        else:
            pass_.dispatch_workgroups_indirect(indirect, 0)
        pass_.end()
        if measured:
            encoder.resolve_query_set(self.gpu.queries, 0, 2, self.gpu.ticks, 0)


class Input:
    """What `words gpu` wrote."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.pictures = []
        for line in (folder / "input.txt").read_text().splitlines():
            name, *numbers = line.split()
            values = [int(number) for number in numbers]
            if name == "size":
                self.width, self.height = values
            elif name == "matte":
                self.is_matte = bool(values[0])
            elif name == "constants":
                self.constants = dict(zip(values[::2], values[1::2]))
            else:
                words, cells, tracing, *of_frames = values
                number = len(self.pictures)
                frame, frames = (folder / f"frame-{number}").read_bytes(), (folder / f"frames-{number}").read_bytes()
                # The record, whether light is found again, how many rays only look, the number before theirs.
                each = [(frames[4 * words * at : 4 * words * (at + 1)], *of_frames[3 * at : 3 * at + 3]) for at in range(len(of_frames) // 3)]
                self.pictures.append((frame, each, cells, tracing))
        lens, lens_of, sky, sky_of = struct.unpack("<4I", self.pictures[0][0][-16:])
        self.constants.update({lens: lens_of, sky: sky_of})


class Tracer:
    def __init__(self, given: Input, shaders: Path) -> None:
        self.given = given
        pixels = given.width * given.height
        sizes = {binding: (given.folder / name).stat().st_size for name, binding in SCENE.items()}
        self.gpu = gpu = Gpu(max(*sizes.values(), 128 << 20, 80 * pixels))
        for name, binding in SCENE.items():
            gpu.storage(binding, sizes[binding])
            gpu.write(binding, (given.folder / name).read_bytes())
        for binding in (9, 16, 23, 24):
            gpu.uniform(binding)
        # Films and real-time light of all materials, the steps that trace no rays, real-time light and films of matte things.
        lines = (shaders / "shaders.wgsl").read_text().split("\n")
        self.pixels_code = lines[2]
        self.film_code, self.light_code = (lines[4], lines[3]) if given.is_matte else lines[:2]

    def submit(self, record) -> None:
        """Records and submits. Where steps are measured, each is a submit of its own, whose time is the device's."""
        encoder = self.gpu.device.create_command_encoder()
        record(encoder)
        self.gpu.device.queue.submit([encoder.finish()])

    def step(self, module: Module, entry: str, groups: int | None, indirect=None, name: str | None = None) -> None:
        self.submit(lambda encoder: module.run(encoder, entry, groups, indirect))
        if self.gpu.measures:
            first, last = struct.unpack("<2Q", self.gpu.device.queue.read_buffer(self.gpu.ticks, 0, 16))
            name = name or entry
            self.gpu.steps[name] = self.gpu.steps.get(name, 0.0) + (last - first) * 1e-6

    def prepare_light(self) -> None:
        gpu, given = self.gpu, self.given
        pixels = given.width * given.height
        self.cells, self.tracing = given.pictures[0][2:]
        self.groups = math.ceil(given.width / 8) * math.ceil(given.height / 8)
        rows = 16 if given.is_matte else 23
        self.capacity = max(min(self.groups * WORKGROUP, MOST_PATHS), self.tracing)
        gpu.storage(22, 64 * self.cells + 16 * rows * self.capacity)
        gpu.storage(27, 64 + 12 * self.cells)
        gpu.storage(26, 80 * pixels)
        gpu.storage(25, 64 * pixels)
        gpu.storage(12, 4 * pixels)
        gpu.storage(29, 16)
        gpu.storage(-1, 256, wgpu.BufferUsage.INDIRECT)
        self.paths = gpu.module(self.light_code, REAL_TIME, given.constants)
        self.pixels = gpu.module(self.pixels_code, PIXELS, given.constants)
        self.looks = gpu.module(self.light_code, LOOKS, given.constants)
        for module in (self.paths, self.looks, self.pixels):
            module.bind()

    def follow(self, first: int, count: int, indirect=None) -> None:
        self.gpu.words(16, first, count, 0, 0, 0, 0, 0, 0)
        rounds = ["walk_paths", "shade_paths", "choose_lights", "scatter_paths"] * (12 if self.given.is_matte else 20)
        entries = ["begin_paths", "choose_lights", *rounds, "end_paths"]
        groups = None if indirect is not None else count // WORKGROUP
        if self.gpu.measures:
            for entry in entries:
                self.step(self.paths, entry, groups, indirect)
        else:
            self.submit(lambda encoder: [self.paths.run(encoder, entry, groups, indirect) for entry in entries])

    def look(self, first: int, count: int, turn: int, number: int) -> None:
        """A ray of each pixel looks at what it shows."""
        self.gpu.words(16, first, count, number, turn, 0, 0, 0, 0)
        rounds = ["walk_paths", "shade_paths"] if self.given.is_matte else ["walk_paths", "shade_paths", "scatter_paths"] * 6
        steps = [(self.looks, "begin_looks"), *((self.paths, entry) for entry in rounds), (self.looks, "end_looks")]
        if self.gpu.measures:
            for module, entry in steps:
                self.step(module, entry, count // WORKGROUP, name=f"look: {entry}")
        else:
            self.submit(lambda encoder: [module.run(encoder, entry, count // WORKGROUP) for module, entry in steps])

    def light(self, number: int) -> None:
        """A picture in real-time light."""
        gpu, keys, indirect = self.gpu, self.gpu.buffers[27], self.gpu.buffers[-1]
        frame, frames, *_ = self.given.pictures[number]
        gpu.write(9, frame[:-16])
        gpu.words(23, 0, 0, self.capacity, 0, 0, 0, 0, 0)
        for at, (of_frame, reprojects, looks, before) in enumerate(frames):
            gpu.write(24, of_frame)
            self.submit(lambda encoder: (encoder.clear_buffer(keys, 8, 4), encoder.clear_buffer(keys, 20, 4)))
            self.step(self.pixels, "choose_cells", self.cells // WORKGROUP)
            self.submit(lambda encoder: encoder.copy_buffer_to_buffer(keys, 20, indirect, 0, 4))
            gpu.write(-1, struct.pack("<2I", 1, 1), 4)
            self.follow(0, self.tracing, indirect)
            for first in range(0, self.groups * WORKGROUP, self.capacity):
                self.follow(self.tracing + first, min(self.capacity, self.groups * WORKGROUP - first))
            if reprojects:
                self.step(self.pixels, "reproject", self.groups)
            self.step(self.pixels, "remember", self.groups)
            for look in range(looks):
                for first in range(0, self.groups * WORKGROUP, self.capacity):
                    self.look(first, min(self.capacity, self.groups * WORKGROUP - first), look, before + look + 1)
            self.submit(lambda encoder: encoder.clear_buffer(keys, 0, 8))
            self.step(self.pixels, "end_cells", self.cells // WORKGROUP)
            if at + 1 == len(frames):
                for entry in [*FILTER.split(), "show_picture"]:
                    self.step(self.pixels, entry, self.groups)

    def film(self, samples: int) -> float:
        """Adds samples to a film. Returns the seconds, without the shaders' compiling."""
        gpu, given = self.gpu, self.given
        pixels = given.width * given.height
        capacity = min(pixels, MOST_PATHS)
        gpu.storage(22, capacity * 16 * (15 if given.is_matte else 22))
        gpu.storage(10, 32 * pixels)
        gpu.storage(15, 4)
        module = gpu.module(self.film_code, FILM, given.constants)
        module.bind()
        gpu.write(9, given.pictures[0][0][:-16])
        for entry in ("begin_paths", "walk_paths", "shade_paths", "choose_lights", "scatter_paths"):
            module.pipeline(entry)
        start = time.perf_counter()
        for first in range(0, pixels, capacity):
            count = min(capacity, pixels - first)
            gpu.words(16, first, count, samples, samples, 0, 0, 0, 0)
            left, turn = count, 0
            while left:
                gpu.words(23, min(turn, 1), 0, capacity, 0, 0, 0, 0, 0)

                def rounds(encoder) -> None:
                    for round_ in range(16 if turn else 0):
                        for entry in ("walk_paths", "shade_paths", "choose_lights", "scatter_paths"):
                            module.run(encoder, entry, math.ceil(count / WORKGROUP))
                        if round_ < 15:
                            module.run(encoder, "begin_paths", math.ceil(count / WORKGROUP))
                    encoder.clear_buffer(gpu.buffers[15], 0, 4)
                    module.run(encoder, "begin_paths", math.ceil(count / WORKGROUP))

                self.submit(rounds)
                left, turn = struct.unpack("<I", gpu.read(15, 4))[0], turn + 1
        return time.perf_counter() - start


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("input", type=Path, help="the folder that `words gpu` wrote")
    parser.add_argument("shaders", type=Path, help="the folder with shaders.wgsl")
    parser.add_argument("--samples", type=int, default=4, help="of the film that is measured as well")
    parser.add_argument("--pictures", type=Path, help="where pictures go (PPM)")
    parser.add_argument("--film", type=Path, help="a film file of the processor with as many samples")
    given = parser.parse_args()
    data = Input(given.input)
    tracer = Tracer(data, given.shaders)
    print(f"{tracer.gpu.info['device']}, {tracer.gpu.info['adapter_type']}, {data.width} x {data.height}, {'matte' if data.is_matte else 'all materials'}")
    tracer.prepare_light()
    start = time.perf_counter()
    for entry in ("begin_paths", "walk_paths", "shade_paths", "choose_lights", "scatter_paths", "end_paths"):
        at = time.perf_counter()
        tracer.paths.pipeline(entry)
        print(f"compiled {entry} in {time.perf_counter() - at:.2f} s")
    for entry in ("begin_looks", "end_looks"):
        tracer.looks.pipeline(entry)
    for entry in ("choose_cells", "end_cells", "reproject", "remember", *FILTER.split(), "show_picture"):
        tracer.pixels.pipeline(entry)
    print(f"compiled all in {time.perf_counter() - start:.2f} s")
    size = 4 * data.width * data.height
    for number in range(len(data.pictures)):
        start = time.perf_counter()
        tracer.light(number)
        bytes_ = bytes(tracer.gpu.read(12, size))
        print(f"picture {number}: {1e3 * (time.perf_counter() - start):.2f} ms of {len(data.pictures[number][1])} frames, read back as well")
        if given.pictures:
            given.pictures.mkdir(parents=True, exist_ok=True)
            rgb = bytearray(3 * data.width * data.height)
            for channel in range(3):
                rgb[channel::3] = bytes_[channel::4]
            (given.pictures / f"real-time-{number}.ppm").write_bytes(f"P6 {data.width} {data.height} 255\n".encode() + bytes(rgb))
    if tracer.gpu.has_clock:
        tracer.gpu.measures = True
        tracer.light(len(data.pictures) - 1)
        tracer.gpu.measures = False
        frames = len(data.pictures[-1][1])
        for entry, ms in tracer.gpu.steps.items():
            print(f"{entry}: {ms / frames:.3f} ms")
        print(f"all steps: {sum(tracer.gpu.steps.values()) / frames:.2f} ms a frame")
    seconds = tracer.film(given.samples)
    differs = False
    print(f"film: {given.samples} samples in {1e3 * seconds:.1f} ms, {1e3 * seconds / given.samples:.2f} ms a sample")
    if given.film:
        pixels = data.width * data.height
        ours, file = bytes(tracer.gpu.read(10, 32 * pixels)), given.film.read_bytes()
        theirs = file[-8 - 32 * pixels : -8]
        differing = [at for at in range(0, 32 * pixels, 32) if ours[at : at + 32] != theirs[at : at + 32]]
        # Sums of red, green and blue (units of 2⁻³²), samples, those that met a voxel.
        sums = [[struct.unpack_from("<3Q2I", words, at) for at in differing] for words in (ours, theirs)]
        # What eight bits show at most: by a thousandth of the radiance, and of one.
        seen = sum(any(abs(a - b) > 1e-3 * max(a, b, given.samples << 32) for a, b in zip(one[:3], other[:3])) for one, other in zip(*sums))
        differs = bool(differing)
        print(f"{len(differing)} of {pixels} pixels have other words than the processor's, {seen} of them by more than a thousandth")
    return int(differs)


if __name__ == "__main__":
    sys.exit(main())
