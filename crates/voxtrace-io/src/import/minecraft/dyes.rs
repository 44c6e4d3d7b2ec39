//! Colours of what is dyed and of what is made of wood, in sRGB, chosen by us.

/// The dyes: name, and the colours of what is made with them: wool, concrete, terracotta.
pub(super) const DYES: [(&str, [u32; 3]); 16] = [
    ("white", [0xe9ecec, 0xcfd5d6, 0xd1b2a1]),
    ("orange", [0xf07613, 0xe06101, 0xa15325]),
    ("magenta", [0xbd44b3, 0xa9309f, 0x95586c]),
    ("light_blue", [0x3aafd9, 0x2389c7, 0x716c89]),
    ("yellow", [0xf8c527, 0xf1af15, 0xba8523]),
    ("lime", [0x70b919, 0x5ea918, 0x677535]),
    ("pink", [0xed8dac, 0xd6658f, 0xa14e4e]),
    ("gray", [0x3e4447, 0x36393d, 0x392a23]),
    ("light_gray", [0x8e8e86, 0x7d7d73, 0x876a61]),
    ("cyan", [0x158991, 0x157788, 0x565b5b]),
    ("purple", [0x792aac, 0x64209c, 0x764656]),
    ("blue", [0x35399d, 0x2d2f8f, 0x4a3b5b]),
    ("brown", [0x724728, 0x603c20, 0x4d3323]),
    ("green", [0x546d1b, 0x495b24, 0x4c532a]),
    ("red", [0xa12722, 0x8e2121, 0x8f3d2e]),
    ("black", [0x141519, 0x080a0f, 0x251610]),
];

/// The woods: name, and the colours of bark, planks and leaves.
pub(super) const WOODS: [(&str, [u32; 3]); 12] = [
    ("dark_oak", [0x3c2e1a, 0x422b14, 0x3d6b1f]),
    ("pale_oak", [0x585049, 0xe3d9d7, 0x747a70]),
    ("oak", [0x6d5532, 0xa2834f, 0x4a7a28]),
    ("spruce", [0x3a2510, 0x725430, 0x3f5f3f]),
    ("birch", [0xd8d7d2, 0xc0af79, 0x67864a]),
    ("jungle", [0x554319, 0xa07351, 0x3f8a1f]),
    ("acacia", [0x676157, 0xa85a32, 0x5f8f2a]),
    ("mangrove", [0x544329, 0x753630, 0x5c8a2c]),
    ("cherry", [0x36212c, 0xe2b3ad, 0xe7acc5]),
    ("bamboo", [0x7f903a, 0xc1ad50, 0x6a8f2a]),
    ("crimson", [0x5c191d, 0x653147, 0x7a1515]),
    ("warped", [0x3a3a4e, 0x2b6963, 0x167e86]),
];
