"""What `voxtrace render --cluster` starts: `python -m voxtrace._program ADDRESS DEVICE SCENE FILM FIRST SAMPLES X0 Y0 X1 Y1 OUT` renders samples
of the picture that FILM shows by the workers of a Dask cluster, prints the share that is done, line by line, and writes the film to OUT."""

from __future__ import annotations

import sys

from dask import distributed

import voxtrace
import voxtrace.dask

#: Seconds until a scheduler that does not answer is one that is not there.
PATIENCE = 20


def main(words: list[str]) -> None:
    address, device, scene, film, *numbers, out = words
    first_sample, samples, x0, y0, x1, y1 = map(int, numbers)
    with open(film, "rb") as file:
        like = voxtrace.Image.from_bytes(file.read())
    try:
        client = distributed.Client(address, timeout=PATIENCE)  # type: ignore[no-untyped-call, unused-ignore]
    except (OSError, ValueError) as error:
        sys.exit(f"no scheduler answers at {address}: {error}")
    with client:
        if not client.scheduler_info(n_workers=-1)["workers"]:
            sys.exit(f"the scheduler at {address} has no workers")
        image = voxtrace.dask.render_like(
            client,
            voxtrace.open(scene),
            like,
            samples=samples,
            first_sample=first_sample,
            region=(x0, y0, x1, y1),
            device=device,
            progress=lambda share: print(share, flush=True),
        )
    image.save(out)


if __name__ == "__main__":
    main(sys.argv[1:])
