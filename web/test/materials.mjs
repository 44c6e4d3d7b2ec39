// A small MagicaVoxel file with every kind of material, written for tests: mirrors, rough metal, plastic, clear and frosted glass, glass that absorbs, mist, light.

const EDGE = 24;
/** Colour (red, green, blue) and properties of the materials, from number 1 on. */
const MATERIALS = [
  [[200, 190, 180], {}],
  [[230, 230, 230], { _type: "_metal", _metal: 1, _rough: 0 }],
  [[220, 160, 60], { _type: "_metal", _metal: 1, _rough: 0.3 }],
  [[200, 40, 40], { _type: "_metal", _metal: 0, _rough: 0.2, _sp: 1 }],
  [[120, 200, 160], { _type: "_glass", _trans: 0.95, _rough: 0, _ri: 1.5, _d: 0.05 }],
  [[230, 230, 240], { _type: "_glass", _trans: 1, _rough: 0.3, _ri: 1.3, _d: 0.02 }],
  [[240, 240, 240], { _type: "_media", _media_type: "_scatter", _d: 0.1, _g: 0.3 }],
  [[255, 220, 160], { _type: "_emit", _emit: 1, _flux: 1 }],
  [[90, 130, 220], { _type: "_media", _media_type: "_absorb", _d: 0.1 }],
  [[240, 140, 120], { _type: "_blend", _metal: 0.4, _trans: 0.4, _rough: 0.2, _ri: 1.4, _d: 0.05 }],
];

const word = (value) => Buffer.from(Int32Array.of(value).buffer);
const text = (value) => Buffer.concat([word(Buffer.byteLength(String(value))), Buffer.from(String(value))]);
const chunk = (name, content, children = Buffer.alloc(0)) => Buffer.concat([Buffer.from(name), word(content.length), word(children.length), content, children]);

/** The material of a voxel, 0 for none: a floor, a grid of blocks on it, one of each material, and a lamp above. */
function materialAt(x, y, z) {
  if (z === 0) return 1;
  const [column, row] = [Math.floor(x / 8), Math.floor(y / 8)];
  const isBlock = x % 8 >= 2 && x % 8 < 7 && y % 8 >= 2 && y % 8 < 7 && z <= 6;
  if (isBlock) return 2 + ((3 * row + column) % (MATERIALS.length - 1));
  return z === EDGE - 1 && x > 8 && x < 15 && y > 8 && y < 15 ? 8 : 0;
}

/** The bytes of the file. */
export function fileOfMaterials() {
  const voxels = [];
  for (let z = 0; z < EDGE; z++) for (let y = 0; y < EDGE; y++) for (let x = 0; x < EDGE; x++) {
    const material = materialAt(x, y, z);
    if (material > 0) voxels.push(x, y, z, material);
  }
  const palette = Buffer.alloc(1024, 255);
  for (const [index, [color]] of MATERIALS.entries()) palette.set(color, 4 * index);
  const materials = MATERIALS.map(([, properties], index) => {
    const pairs = Object.entries(properties);
    return chunk("MATL", Buffer.concat([word(index + 1), word(pairs.length), ...pairs.flatMap(([key, value]) => [text(key), text(value)])]));
  });
  const size = chunk("SIZE", Buffer.concat([EDGE, EDGE, EDGE].map(word)));
  const model = chunk("XYZI", Buffer.concat([word(voxels.length / 4), Buffer.from(voxels)]));
  const main = chunk("MAIN", Buffer.alloc(0), Buffer.concat([size, model, chunk("RGBA", palette), ...materials]));
  return Buffer.concat([Buffer.from("VOX "), word(200), main]);
}
