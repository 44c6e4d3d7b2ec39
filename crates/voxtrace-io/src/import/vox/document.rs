//! A .vox file as a document: every chunk in the order of the file, known ones taken apart and unknown ones kept as they
//! are, so that a file that is parsed and encoded again has the same bytes. Source: MagicaVoxel's file format texts
//! (`MagicaVoxel-file-format-vox.txt`, `-vox-extension.txt`) and files that MagicaVoxel 0.97 to 0.99.7 wrote.

use std::borrow::Cow;

/// A MagicaVoxel file, borrowed from its bytes where it can be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VoxFile<'a> {
    /// Format version: 150, since MagicaVoxel 0.99.7 200.
    pub version: u32,
    /// Content of the MAIN chunk, empty in every file seen.
    pub main: Cow<'a, [u8]>,
    /// The chunks inside MAIN.
    pub chunks: Vec<Chunk<'a>>,
    /// What follows MAIN, normally nothing.
    pub trailing: Cow<'a, [u8]>,
}

/// One chunk.
#[derive(Clone, Debug, PartialEq)]
pub struct Chunk<'a> {
    /// Byte offset of the chunk in the file it was read from, for error messages.
    pub offset: u64,
    /// What it says.
    pub body: Body<'a>,
    /// Bytes of its content after `body`, normally none.
    pub extra: Cow<'a, [u8]>,
    /// Its children, not taken apart; only MAIN has any in the files seen.
    pub children: Cow<'a, [u8]>,
}

/// What a chunk says. Ids and reserved numbers are kept as the file gives them.
#[derive(Clone, Debug, PartialEq)]
pub enum Body<'a> {
    /// `PACK`: number of models; old files with an animation have one model for each frame.
    Pack(u32),
    /// `SIZE`: voxels along x, y and z of the model whose `XYZI` follows.
    Size([u32; 3]),
    /// `XYZI`: x, y, z and colour index (0 is empty) of each voxel.
    Voxels(Cow<'a, [[u8; 4]]>),
    /// `RGBA`: entry i is the colour of index i + 1.
    Palette(Box<[[u8; 4]; 256]>),
    /// `MATL`: material of a colour index; ids are 1 to 256, or 0 to 255 in older files.
    Material(Numbered<'a>),
    /// `MATT`: material of a colour index, before MagicaVoxel 0.99.
    OldMaterial(OldMaterial),
    /// `nTRN`: a transform node.
    Transform(TransformNode<'a>),
    /// `nGRP`: a group node.
    Group(GroupNode<'a>),
    /// `nSHP`: a shape node.
    Shape(ShapeNode<'a>),
    /// `LAYR`: a layer and its reserved number (−1).
    Layer(Numbered<'a>, i32),
    /// `rOBJ`: a setting of the renderer, named by `_type`.
    RenderObject(Dict<'a>),
    /// `rCAM`: a camera.
    Camera(Numbered<'a>),
    /// `NOTE`: names of the palette's rows.
    Notes(Vec<Text<'a>>),
    /// `IMAP`: the order in which an editor shows the palette.
    IndexMap(Box<[u8; 256]>),
    /// Any other chunk, for example `META`: its name and content.
    Unknown([u8; 4], Cow<'a, [u8]>),
}

/// A dictionary with an id: `MATL`, `LAYR` and `rCAM`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Numbered<'a> {
    /// The id.
    pub id: i32,
    /// Its properties.
    pub properties: Dict<'a>,
}

/// `MATT`: a material before MagicaVoxel 0.99.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OldMaterial {
    /// Colour index.
    pub id: i32,
    /// 0 diffuse, 1 metal, 2 glass, 3 emissive.
    pub kind: u32,
    /// How much of the kind, in (0, 1]; the rest is diffuse.
    pub weight: f32,
    /// Which properties follow: bit 0 plastic, 1 roughness, 2 specular, 3 refraction, 4 attenuation, 5 power, 6 glow;
    /// bit 7 is a flag without a value.
    pub properties: u32,
    /// The values of the properties that are there, in the order of their bits.
    pub values: Vec<f32>,
}

/// `nTRN`: places its child.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TransformNode<'a> {
    /// Node id.
    pub id: i32,
    /// `_name`, `_hidden`, …
    pub attributes: Dict<'a>,
    /// Id of the child, a group or a shape.
    pub child: i32,
    /// −1.
    pub reserved: i32,
    /// Id of the layer, −1 for none.
    pub layer: i32,
    /// `_r`, `_t` and `_f` of each key frame; one entry where nothing moves.
    pub frames: Vec<Dict<'a>>,
}

/// `nGRP`: holds children.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GroupNode<'a> {
    /// Node id.
    pub id: i32,
    /// Attributes.
    pub attributes: Dict<'a>,
    /// Ids of the children, transform nodes.
    pub children: Vec<i32>,
}

/// `nSHP`: shows a model, or one for each key frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShapeNode<'a> {
    /// Node id.
    pub id: i32,
    /// Attributes.
    pub attributes: Dict<'a>,
    /// Index of the model in the order of the file, and its attributes (`_f`).
    pub models: Vec<(i32, Dict<'a>)>,
}

/// Text is kept as bytes: names may be in any encoding.
pub type Text<'a> = Cow<'a, [u8]>;

/// Key and value pairs in the order of the file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Dict<'a>(pub Vec<(Text<'a>, Text<'a>)>);

impl<'a> Dict<'a> {
    /// The value of a key, `None` where there is none.
    pub fn get(&self, key: &str) -> Option<&[u8]> {
        self.0.iter().find(|(name, _)| name.as_ref() == key.as_bytes()).map(|(_, value)| value.as_ref())
    }

    /// Appends a pair.
    pub fn push(&mut self, key: &'static str, value: impl Into<String>) {
        self.0.push((Cow::Borrowed(key.as_bytes()), Cow::Owned(value.into().into_bytes())));
    }
}

impl<'a> Chunk<'a> {
    /// A chunk of its body alone.
    pub fn new(body: Body<'a>) -> Self {
        Self { offset: 0, body, extra: Cow::Borrowed(&[]), children: Cow::Borrowed(&[]) }
    }

    /// The four letters of the chunk.
    pub fn name(&self) -> [u8; 4] {
        match &self.body {
            Body::Pack(_) => *b"PACK",
            Body::Size(_) => *b"SIZE",
            Body::Voxels(_) => *b"XYZI",
            Body::Palette(_) => *b"RGBA",
            Body::Material(_) => *b"MATL",
            Body::OldMaterial(_) => *b"MATT",
            Body::Transform(_) => *b"nTRN",
            Body::Group(_) => *b"nGRP",
            Body::Shape(_) => *b"nSHP",
            Body::Layer(..) => *b"LAYR",
            Body::RenderObject(_) => *b"rOBJ",
            Body::Camera(_) => *b"rCAM",
            Body::Notes(_) => *b"NOTE",
            Body::IndexMap(_) => *b"IMAP",
            Body::Unknown(name, _) => *name,
        }
    }
}
