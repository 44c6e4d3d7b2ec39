"""Writes clouds and heights in feet and in degrees, and what they are in metres: python units.py FOLDER. Needs laspy, pyproj and
tifffile."""

import json
import sys
from pathlib import Path

import laspy
import numpy as np
import pyproj
import tifffile

folder = Path(sys.argv[1])
random = np.random.default_rng(11)
expected = {}


def write(name, version, point_format, offsets, scales, steps, crs=None, keys=()):
    header = laspy.LasHeader(version=version, point_format=point_format)
    header.offsets, header.scales = offsets, scales
    if crs is not None:
        header.add_crs(crs)
    las = laspy.LasData(header)
    las.X, las.Y, las.Z = steps.T
    las.write(folder / name)
    if keys:
        patch(folder / name, keys)


def patch(path, keys):
    """Puts keys of GeoTIFF into a file without any."""
    las = laspy.read(path)
    vlr = laspy.VLR("LASF_Projection", 34735)
    words = [1, 1, 0, len(keys)] + [word for key, value in keys for word in (key, 0, 1, value)]
    vlr.record_data = np.array(words, "<u2").tobytes()
    las.vlrs.append(vlr)
    las.write(path)


def metres_of(name, places, horizontal, vertical, tolerance=1e-6):
    """The first point's coordinates, and the size of the cloud in metres."""
    size = places.max(axis=0) - places.min(axis=0)
    metres = [size[0] * horizontal, size[1] * horizontal, size[2] * vertical]
    expected[name] = {"first": list(places[0]), "metres": metres, "tolerance": tolerance}


# 1000 by 600 by 90 feet, in hundredths.
steps = random.integers(0, [100_000, 60_000, 9_000], size=(1500, 3))
offsets, scales = [6_000_000.0, 2_000_000.0, 100.0], [0.01] * 3
places = np.array(offsets) + steps * 0.01
US_FOOT, FOOT = 1200 / 3937, 0.3048
for version, point_format in [("1.2", 3), ("1.4", 6)]:
    tag = version.replace(".", "_")
    for ending in ["las", "laz"]:
        name = f"us_feet_{tag}.{ending}"
        write(name, version, point_format, offsets, scales, steps, pyproj.CRS.from_epsg(2227))
        metres_of(name, places, US_FOOT, US_FOOT)
        name = f"feet_{tag}.{ending}"
        write(name, version, point_format, offsets, scales, steps, pyproj.CRS.from_epsg(2222))
        metres_of(name, places, FOOT, FOOT)

# Keys alone: a system of one's own in feet, and one whose heights are metres.
write("own_feet.las", "1.2", 1, offsets, scales, steps, keys=[(1024, 1), (3072, 32767), (3076, 9002)])
metres_of("own_feet.las", places, FOOT, FOOT)
write("feet_and_metres.las", "1.2", 1, offsets, scales, steps, keys=[(1024, 1), (3072, 2227), (3076, 9003), (4099, 9001)])
metres_of("feet_and_metres.las", places, US_FOOT, 1.0)
# The same by WKT: state plane in feet over NAVD88 in metres.
write("wkt_feet_and_metres.laz", "1.4", 6, offsets, scales, steps, pyproj.CRS.from_user_input("EPSG:2227+5703"))
metres_of("wkt_feet_and_metres.laz", places, US_FOOT, 1.0)
write("metres.las", "1.2", 1, offsets, scales, steps, keys=[(1024, 1), (3072, 32632), (3076, 9001)])
metres_of("metres.las", places, 1.0, 1.0)
write("unknown.las", "1.2", 1, offsets, scales, steps)
metres_of("unknown.las", places, 1.0, 1.0)

# A square of 0.01 degrees in Bavaria, with 80 m of heights: its sides by pyproj's geodesics.
steps = random.integers(0, [100_000, 100_000, 8_000], size=(1500, 3))
steps[0], steps[1] = [0, 0, 0], [100_000, 100_000, 8_000]
offsets, scales = [11.57, 48.13, 500.0], [1e-7, 1e-7, 0.01]
places = np.array(offsets) + steps * np.array(scales)
geod = pyproj.Geod(ellps="WGS84")
low, high = places.min(axis=0), places.max(axis=0)
middle = (low[1] + high[1]) / 2
east = geod.inv(low[0], middle, high[0], middle)[2]
north = geod.inv(low[0], low[1], low[0], high[1])[2]
for name, version, point_format, ending in [("a", "1.2", 1, "las"), ("b", "1.4", 6, "laz")]:
    name = f"degrees_{name}.{ending}"
    write(name, version, point_format, offsets, scales, steps, pyproj.CRS.from_epsg(4326))
    expected[name] = {"first": list(places[0]), "metres": [east, north, high[2] - low[2]], "tolerance": 0.05}

# The units of all projected systems of EPSG that a key can name.
units = {}
for info in pyproj.database.query_crs_info(auth_name="EPSG", pj_types=[pyproj.enums.PJType.PROJECTED_CRS], allow_deprecated=True):
    if 1024 <= int(info.code) < 32767:
        units[info.code] = pyproj.CRS.from_epsg(int(info.code)).axis_info[0].unit_conversion_factor
(folder / "epsg.json").write_text(json.dumps(units))

# Heights: 4 x 3 pixels of 10 feet, from 0 to 55 feet; the same with heights in metres.
heights = (np.arange(12, dtype=np.float32) * 5).reshape(3, 4)


def geotiff(name, keys):
    directory = [1, 1, 0, len(keys)] + [word for key, value in keys for word in (key, 0, 1, value)]
    tags = [
        (33550, "d", 3, (10.0, 10.0, 0.0), True),
        (33922, "d", 6, (0.0, 0.0, 0.0, 6_000_000.0, 2_000_000.0, 0.0), True),
        (34735, "H", len(directory), tuple(directory), True),
    ]
    tifffile.imwrite(folder / name, heights, extratags=tags, metadata=None)


geotiff("feet.tif", [(1024, 1), (1025, 1), (3072, 2222), (3076, 9002)])
geotiff("feet_and_metres.tif", [(1024, 1), (1025, 1), (3072, 2222), (3076, 9002), (4099, 9001)])

(folder / "expected.json").write_text(json.dumps(expected))
