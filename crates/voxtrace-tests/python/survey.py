"""What voxtrace makes of files that others wrote: all of a folder, and those that come with packages of the registries of Python and Rust.

    python3 crates/voxtrace-tests/python/survey.py VOXTRACE FOLDER OUT.md

asks `voxtrace info` about each file with an extension that `voxtrace formats` names, and about DICOM whatever it is called, and writes a table:
how many of each kind were read, and why each of the others was not. Source packages are fetched by pip's index and by cargo, and never built.
Exits with 1 where the program crashed or did not end in time.
"""

import collections
import concurrent.futures
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import urllib.parse
import urllib.request

from pip._internal.models.index import PyPI

# Packages whose source carries files of the formats, at the versions that were looked at.
PYTHON = ["laspy==2.7.0", "nibabel==5.4.2", "pydicom==3.0.2", "pydicom-data==1.0.0"]
RUST = ["dot_vox=5.2.0", "fastanvil=0.32.0", "las=0.11.2", "pcd-rs=0.13.0", "ply-rs=0.1.3", "stl_io=0.11.0", "tiff=0.11.3"]
SECONDS = 120
# Kinds that only voxtrace writes, and those that mostly are no scenes: pictures, and text of any kind.
LEFT_OUT = {".vxf", ".vxt", ".exr", ".png", ".txt", ".raw"}
# Parts of other files, which are asked about instead; the latter where the other file is there.
SIDE = {".bin", ".mtl"}
DATA_OF = {".img": ".hdr", ".rec": ".par"}


def source(package: str, folder: pathlib.Path) -> pathlib.Path:
    """Unpacks the source of a Python package, and gives its folder."""
    name, version = package.split("==")
    page = f"{PyPI.simple_url}/{name}/"
    with urllib.request.urlopen(page) as answer:
        text = answer.read().decode()
    links = [html.unescape(link) for link in re.findall(r'href="([^"]+)"', text)]
    wanted = f"{name}-{version}".replace("-", "_")
    link = next(one for one in links if one.split("#")[0].endswith(".tar.gz") and wanted in one.rsplit("/", 1)[-1].replace("-", "_"))
    archive = folder / f"{name}.tar.gz"
    with urllib.request.urlopen(urllib.parse.urljoin(page, link)) as answer, open(archive, "wb") as out:
        shutil.copyfileobj(answer, out)
    unpacked = folder / package.replace("==", "-")
    with tarfile.open(archive) as tar:
        tar.extractall(unpacked, filter="data")
    return unpacked


def crates(folder: pathlib.Path) -> list[pathlib.Path]:
    """Unpacks the sources of the Rust packages, and gives their folders."""
    wanted = "".join('{} = "={}"\n'.format(*one.split("=")) for one in RUST)
    (folder / "Cargo.toml").write_text(f'[package]\nname = "survey"\nversion = "0.0.0"\n[lib]\npath = "lib.rs"\n[dependencies]\n{wanted}')
    (folder / "lib.rs").write_text("")
    subprocess.run(["cargo", "vendor", "--quiet", "--versioned-dirs", "crates"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return [folder / "crates" / one.replace("=", "-") for one in RUST]


def is_dicom(path: pathlib.Path) -> bool:
    with open(path, "rb") as file:
        return file.read(132)[128:] == b"DICM"


def files_of(folder: pathlib.Path, extensions: set[str]) -> list[pathlib.Path]:
    """The files of a folder that are asked about; folders that are one scene (Zarr) count as one."""
    found, scenes = [], []
    for path in sorted(folder.rglob("*")):
        if any(scene in path.parents for scene in scenes):
            continue
        if path.is_dir() and path.suffix.lower() in extensions:
            scenes.append(path)
            found.append(path)
        elif path.is_file() and not is_part(path) and (kind_of(path, extensions) in extensions or is_dicom(path)):
            found.append(path)
    return found


def is_part(path: pathlib.Path) -> bool:
    """Whether a file is asked about as a part of another, or is a picture of a sky, which has the extension of a volume."""
    suffix = path.suffix.lower()
    head = DATA_OF.get(suffix)
    beside = head and any(path.with_suffix(one).exists() for one in (head, head.upper()))
    if suffix == ".hdr":
        with open(path, "rb") as file:
            return file.read(2) == b"#?"
    return suffix in SIDE or bool(beside)


def kind_of(path: pathlib.Path, extensions: set[str]) -> str:
    """The extension of a file, of two parts where `extensions` has such a one."""
    suffixes = [one.lower() for one in path.suffixes]
    both = "".join(suffixes[-2:])
    return both if both in extensions else (suffixes or [""])[-1]


def ask(voxtrace: pathlib.Path, path: pathlib.Path) -> tuple[int, str]:
    """The exit code and, of an error, its line; -1 where it did not end in time."""
    command = [voxtrace, "info", "--resolution", "64", "--quiet", path]
    try:
        answer = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return -1, f"no end in {SECONDS} s"
    lines = [line for line in answer.stderr.splitlines() if line.startswith("error: ")]
    return answer.returncode, lines[0].removeprefix("error: ") if lines else answer.stderr.strip()


def reason(line: str, path: pathlib.Path) -> str:
    """An error without the file's name and its hint."""
    line = line.replace(f"{path}: ", "").replace(f"{path.parent}/", "").split("; hint:")[0]
    return re.sub(r" \(at byte \d+\)", "", line).replace("|", "\\|")


def main() -> int:
    voxtrace, folder, out = map(pathlib.Path, sys.argv[1:4])
    voxtrace = voxtrace.resolve()
    listed = subprocess.run([voxtrace, "formats", "--json"], capture_output=True, text=True, check=True).stdout
    extensions = {f".{one}" for kind in json.loads(listed)["formats"] if kind["read"] for one in kind["extensions"]} - LEFT_OUT
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        places = {"the project's data": folder.resolve()}
        places |= {package.replace("==", " "): source(package, scratch) for package in PYTHON}
        places |= dict(zip((one.replace("=", " ") for one in RUST), crates(scratch), strict=True))
        asked = [(place, path) for place, root in places.items() for path in files_of(root, extensions)]
        with concurrent.futures.ThreadPoolExecutor() as pool:
            answers = list(pool.map(lambda one: ask(voxtrace, one[1]), asked))
        counts = collections.Counter()
        refused = collections.defaultdict(list)
        crashed = []
        for (place, path), (code, line) in zip(asked, answers, strict=True):
            kind = kind_of(path, extensions)
            kind = kind if kind in extensions else "DICOM"
            counts[place, kind, code == 0] += 1
            if code not in (0, 1, 2, 3, 4):
                crashed.append(f"{path}: exit code {code}: {line}")
            if code != 0:
                refused[place, reason(line, path)].append(path.relative_to(places[place]))
    write(out, counts, refused)
    print("\n".join(crashed))
    return 1 if crashed else 0


def write(out: pathlib.Path, counts: collections.Counter, refused: dict) -> None:
    read, all_files = sum(n for (_, _, ok), n in counts.items() if ok), sum(counts.values())
    lines = [
        "# Files of others",
        "",
        "Made by `python3 crates/voxtrace-tests/python/survey.py target/release/voxtrace ../shared/data docs/formats.md`: `voxtrace info` on each file of the kinds that",
        "`voxtrace formats` names, of the data that the project is tried with, and of packages on the registries of Python and Rust. Many of them are",
        "other projects' tests for damaged or rare files, so not each refusal is a fault.",
        "",
        f"**{all_files} files, {read} read, {all_files - read} refused with a reason, none crashed.**",
        "",
        "| from | kind | read | refused |",
        "|---|---|---:|---:|",
    ]
    rows = sorted({(place, kind) for place, kind, _ in counts})
    lines += [f"| {place} | {kind} | {counts[place, kind, True]} | {counts[place, kind, False]} |" for place, kind in rows]
    lines += ["", "## What was refused", "| from | reason | files |", "|---|---|---|"]
    for (place, why), paths in sorted(refused.items()):
        names = ", ".join(sorted({path.name for path in paths}))
        shown = names if len(names) < 400 else f"{names[:400].rsplit(', ', 1)[0]}, … ({len(paths)} files)"
        lines.append(f"| {place} | {why} | {shown} |")
    out.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    sys.exit(main())
