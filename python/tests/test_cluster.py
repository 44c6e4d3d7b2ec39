"""Pictures by many workers: the same bytes as one process gives, whatever happens to the workers."""

import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import pytest

import voxtrace

distributed = pytest.importorskip("dask.distributed")


@pytest.fixture(scope="module")
def client():
    with distributed.LocalCluster(n_workers=4, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


def test_cameras_and_pictures_travel(church):
    camera = voxtrace.Camera((1, 2, 3), (0.1, 0.2, 0.3), fov=33, name="a", lens="thin-lens", aperture=0.5, focus=3.0)
    assert pickle.loads(pickle.dumps(camera)) == camera
    image = voxtrace.render(church, samples=2, size=(20, 10), device="cpu")
    again = pickle.loads(pickle.dumps(image))
    assert again.to_bytes() == image.to_bytes() and (again.sums == image.sums).all()
    assert (again.denoise(church).radiance == image.denoise(church).radiance).all()
    with pytest.raises(voxtrace.ReadError):
        voxtrace.Image.from_bytes(b"no film")
    other = voxtrace.builtin("city", voxels=20_000)
    with pytest.raises(ValueError, match="another scene"):
        image.denoise(other)


def test_pictures_merge_where_their_samples_join(church):
    renderer = voxtrace.Renderer(church, device="cpu")
    part = lambda first, count: renderer.render(
        samples=count, first_sample=first, size=(20, 10), denoise=False
    )
    whole = part(0, 6).to_bytes()
    assert voxtrace.Image.merge([part(3, 1), part(0, 3), part(4, 2)]).to_bytes() == whole
    for wrong in [[part(0, 3), part(4, 2)], [part(0, 3), part(2, 4)], []]:
        with pytest.raises(ValueError):
            voxtrace.Image.merge(wrong)
    with pytest.raises(ValueError, match="different frames"):
        voxtrace.Image.merge([part(0, 3), renderer.render(samples=1, first_sample=3, size=(20, 10), seed=1)])


def test_a_cluster_gives_the_bytes_of_one_process(client, church):
    from voxtrace import dask

    options = {"samples": 13, "size": (48, 27), "seed": 4, "device": "cpu", "denoise": False}
    alone = voxtrace.render(church, **options)
    shares = []
    for parts in [None, 1, 13, 50]:
        image = dask.render(client, church, parts=parts, progress=shares.append, **options)
        assert image.to_bytes() == alone.to_bytes()
    assert max(shares) == 1
    by_name = dask.render(client, church, church.cameras[1].name, **options)
    assert by_name.to_bytes() == voxtrace.render(church, church.cameras[1], **options).to_bytes() != alone.to_bytes()
    denoised = dask.render(client, church, **{**options, "denoise": True})
    here = voxtrace.render(church, **{**options, "denoise": True})
    assert denoised.to_bytes() == here.to_bytes() and (denoised.radiance == here.radiance).all()
    with pytest.raises(ValueError, match="there are"):
        dask.render(client, church, "nobody", **options)


def test_the_command_line_renders_by_a_cluster(client, tmp_path, command_line, monkeypatch):
    monkeypatch.setenv("VOXTRACE_PYTHON", sys.executable)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(sys.path))
    address = client.scheduler.address

    def run(*words: object) -> subprocess.CompletedProcess[str]:
        words = (command_line, "render", "church", "--voxels", 20_000, "--size", "48x27", "--traversal", "cpu", *words)
        return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300)

    # What only the command line can say goes along: bounces by kind, light, cuts, lines and a crop.
    options = ["--spp", 6, "--seed", 2, "--sun", "40,30,2", "--clip-plane=0,0,1,20", "--edges=0.1", "--crop", "3,40,2,20"]
    options += ["--diffuse-bounces", 3, "--aovs", "--denoise", "-o"]
    for number, more in enumerate([[], ["--cluster", address]]):
        outputs = [tmp_path / f"{number}.vxf", "-o", tmp_path / f"{number}.exr"]
        ended = run(*more, *options, *outputs)
        assert ended.returncode == 0, ended.stderr
    for kind in ["vxf", "exr"]:
        assert (tmp_path / f"0.{kind}").read_bytes() == (tmp_path / f"1.{kind}").read_bytes(), kind
    assert f"tracing on the workers of {address}" in ended.stderr
    # What is missing is said in one line.
    ended = run("--cluster", address, "--spp", 2, "--noise", 0.1, "-o", tmp_path / "a.png")
    assert ended.returncode == 2 and "--noise" in ended.stderr
    monkeypatch.setenv("PYTHONPATH", "")
    monkeypatch.setenv("VOXTRACE_PYTHON", "/usr/bin/python3")
    ended = run("--cluster", address, "--spp", 2, "-o", tmp_path / "a.png")
    assert ended.returncode == 1 and "pip install voxtrace[cluster]" in ended.stderr.splitlines()[-1], ended.stderr
    monkeypatch.setenv("VOXTRACE_PYTHON", str(tmp_path / "nothing"))
    ended = run("--cluster", address, "--spp", 2, "-o", tmp_path / "a.png")
    assert ended.returncode == 1 and "VOXTRACE_PYTHON" in ended.stderr.splitlines()[-1], ended.stderr
    assert not list(tmp_path.glob("*.png"))


def test_workers_may_be_lost_and_may_stand_still(client, church):
    from voxtrace import dask

    options = {"samples": 160, "size": (160, 90), "device": "cpu", "denoise": False}
    alone = voxtrace.render(church, **options)
    lost, paused = list(client.run(os.getpid).values())[:2]

    def strike() -> None:
        time.sleep(0.7)
        os.kill(lost, signal.SIGKILL)
        os.kill(paused, signal.SIGSTOP)

    thread = threading.Thread(target=strike)
    thread.start()
    try:
        image = dask.render(client, church, parts=20, **options)
    finally:
        thread.join()
        os.kill(paused, signal.SIGCONT)
    assert image.to_bytes() == alone.to_bytes()
