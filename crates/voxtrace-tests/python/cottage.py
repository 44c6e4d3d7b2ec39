"""Writes the cottage that docs/minecraft.md shows: python cottage.py FOLDER

    voxtrace render FOLDER/cottage.schem --block-size 16 --fov 31 --sun 150,40 --clear-shadows --spp 32 --denoise --size 600x400 -o docs/pictures/blocks.png
"""

import sys

import mcschematic

build = mcschematic.MCSchematic()


def put(x, y, z, block):
    build.setBlock((x, y, z), "minecraft:" + block)


# x east, y up, z south. Ground with a pond and a path.
W, L = 22, 18
for x in range(W):
    for z in range(L):
        put(x, 0, z, "dirt")
        put(x, 1, z, "grass_block")
pond = {(x, z) for x in range(14, 20) for z in range(10, 15)} - {(14, 10), (19, 10), (19, 14), (14, 14), (14, 13)}
for x, z in pond:
    put(x, 0, z, "sand")
    put(x, 1, z, "water[level=0]")
put(16, 2, 12, "lily_pad")
put(18, 2, 13, "lily_pad")
for z in range(11, L):
    put(7, 1, z, "dirt_path")
put(8, 1, 14, "dirt_path")

# Walls of 8 × 7 with logs at the corners, on a base of cobblestone.
x0, x1, z0, z1 = 3, 11, 3, 10
for y in range(2, 6):
    for x in range(x0, x1 + 1):
        for z in (z0, z1):
            put(x, y, z, "cobblestone" if y == 2 else "oak_planks")
    for z in range(z0, z1 + 1):
        for x in (x0, x1):
            put(x, y, z, "cobblestone" if y == 2 else "oak_planks")
    for x in (x0, x1):
        for z in (z0, z1):
            put(x, y, z, "spruce_log[axis=y]")
for x in range(x0 + 1, x1):
    for z in range(z0 + 1, z1):
        put(x, 1, z, "spruce_planks")

# Door, windows, shutters, lanterns, flower boxes.
for half, y in (("lower", 2), ("upper", 3)):
    put(7, y, z1, f"spruce_door[facing=north,half={half},hinge=left,open=true]")
for x in (5, 9):
    for y in (3, 4):
        put(x, y, z1, "glass_pane[north=false,east=true,south=false,west=true]")
    put(x, 3, z1 + 1, "spruce_trapdoor[facing=south,half=top,open=false]")
    put(x, 4, z1 + 1, "air")
put(5, 2, z1 + 1, "grass_block")
put(9, 2, z1 + 1, "grass_block")
put(4, 4, z1 + 1, "spruce_trapdoor[facing=south,half=top,open=true]")
put(10, 4, z1 + 1, "spruce_trapdoor[facing=south,half=top,open=true]")
for x in (6, 8):
    put(x, 4, z1 + 1, "wall_torch[facing=south]")
for z in (5, 8):
    for y in (3, 4):
        put(x1, y, z, "glass_pane[north=true,east=false,south=true,west=false]")
put(7, 1, z1 + 1, "stone_brick_stairs[facing=north,half=bottom,shape=straight]")

# A roof of stairs, its ridge of slabs, its gables of planks.
for step in range(4):
    y, left, right = 5 + step, z0 - 1 + step, z1 + 1 - step
    for x in range(x0 - 1, x1 + 2):
        put(x, y, left, "dark_oak_stairs[facing=south,half=bottom,shape=straight]")
        put(x, y, right, "dark_oak_stairs[facing=north,half=bottom,shape=straight]")
    for x in (x0, x1):
        for z in range(left + 1, right):
            put(x, y, z, "oak_planks")
for x in range(x0 - 1, x1 + 2):
    put(x, 9, 6, "dark_oak_slab[type=bottom]")
    put(x, 9, 7, "dark_oak_slab[type=bottom]")
    put(x, 8, 6, "dark_oak_planks")
    put(x, 8, 7, "dark_oak_planks")
for y in range(7, 12):
    put(9, y, 4, "bricks")
put(9, 12, 4, "brick_wall[north=none,east=none,south=none,west=none,up=true]")

# A fence around the garden, left to its neighbours, with a gate.
for x in range(1, W - 1):
    if x != 7:
        put(x, 2, L - 2, "oak_fence")
for z in range(2, L - 1):
    put(1, 2, z, "oak_fence")
    put(W - 2, 2, z, "oak_fence")
put(7, 2, L - 2, "oak_fence_gate[facing=south,open=true]")
for x in (1, 6, 8, 13, W - 2):
    put(x, 3, L - 2, "lantern[hanging=false]")

# What grows and stands in it.
for x, z, plant in [
    (3, 13, "poppy"),
    (4, 14, "dandelion"),
    (3, 14, "blue_orchid"),
    (5, 13, "short_grass"),
    (9, 13, "short_grass"),
    (11, 14, "fern"),
    (10, 13, "oxeye_daisy"),
    (11, 12, "allium"),
    (12, 14, "red_tulip"),
    (2, 12, "short_grass"),
    (13, 12, "short_grass"),
    (4, 12, "birch_sapling"),
]:
    put(x, 2, z, plant)
for z in range(3, 7):
    for x in range(14, 20):
        put(x, 1, z, "water[level=0]" if z == 5 and x == 19 else "farmland[moisture=7]")
        if (x, z) != (19, 5):
            put(x, 2, z, ["wheat[age=7]", "carrots[age=7]", "wheat[age=4]", "beetroots[age=3]"][z - 3])
put(13, 2, 4, "composter[level=4]")
put(13, 2, 6, "barrel[facing=up]")
put(14, 2, 8, "chest[facing=south,type=single]")
put(15, 2, 8, "crafting_table")
put(17, 2, 8, "anvil[facing=west]")
put(19, 2, 8, "cauldron")
put(12, 2, 8, "hay_block[axis=x]")
put(12, 2, 9, "hay_block[axis=z]")
put(12, 3, 8, "hay_block[axis=x]")
for z in range(9, 15):
    put(13, 1, z, "gravel")
put(16, 1, 15, "cobblestone_slab[type=bottom]")
put(20, 2, 9, "oak_fence")

# A tree.
for y in range(2, 6):
    put(18, y, 1, "birch_log[axis=y]")
for x in range(16, 21):
    for z in range(-1, 4):
        for y in (5, 6):
            if abs(x - 18) + abs(z - 1) < 4 and (x, z, y) != (18, 1, 5) and 0 <= z < L:
                put(x, y, z, "birch_leaves")
for x, z in ((18, 1), (17, 1), (19, 1), (18, 0), (18, 2)):
    put(x, 7, z, "birch_leaves")

build.save(sys.argv[1], "cottage", mcschematic.Version.JE_1_20_1)
