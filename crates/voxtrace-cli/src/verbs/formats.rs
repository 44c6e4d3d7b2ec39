//! `voxtrace formats`: every kind of file that is read or written.

use crate::failure::Failure;
use serde_json::json;

/// A kind of file.
struct Format {
    extension: &'static str,
    read: bool,
    write: bool,
    about: &'static str,
}

const FORMATS: [Format; 27] = [
    Format { extension: "vox", read: true, write: true, about: "MagicaVoxel scene; read also as Slab6 writes it" },
    Format { extension: "vxt", read: true, write: true, about: "voxtrace scene, packed, opened without copying" },
    Format {
        extension: "glb",
        read: true,
        write: false,
        about: "glTF 2.0 mesh, and .gltf: materials, pictures, nodes, cameras",
    },
    Format {
        extension: "obj",
        read: true,
        write: false,
        about: "Wavefront mesh, with MTL materials and pictures; points where it has no faces",
    },
    Format {
        extension: "ply",
        read: true,
        write: false,
        about: "Stanford mesh or points, text or binary, with colours or a picture",
    },
    Format { extension: "stl", read: true, write: false, about: "mesh, text or binary" },
    Format {
        extension: "laz",
        read: true,
        write: false,
        about: "laser scan, and .las: points with colours, intensities, classes",
    },
    Format { extension: "xyz", read: true, write: false, about: "points as text, and .csv, .pts" },
    Format { extension: "pcd", read: true, write: false, about: "points of the Point Cloud Library" },
    Format { extension: "e57", read: true, write: false, about: "points of laser scanners" },
    Format {
        extension: "nii",
        read: true,
        write: false,
        about: "NIfTI-1 and -2 volume, and .nii.gz: the first moment, placed in the world",
    },
    Format { extension: "nrrd", read: true, write: false, about: "volume, and .nhdr: raw, gzip or text" },
    Format { extension: "mha", read: true, write: false, about: "MetaImage volume, and .mhd: raw, zlib or text" },
    Format { extension: "npy", read: true, write: false, about: "NumPy array of up to three axes, the fastest is x" },
    Format { extension: "dcm", read: true, write: false, about: "DICOM, or name the folder of a series" },
    Format {
        extension: "tif",
        read: true,
        write: false,
        about: "slices: pages of a TIFF; or name a folder of TIFF or PNG",
    },
    Format {
        extension: "raw",
        read: true,
        write: false,
        about: "samples without a header: `--raw-shape` says how many there are, and of what kind",
    },
    Format { extension: "vdb", read: true, write: false, about: "OpenVDB: a level set or densities" },
    Format { extension: "zarr", read: true, write: false, about: "Zarr 2 and 3, OME-Zarr: a folder" },
    Format {
        extension: "schem",
        read: true,
        write: false,
        about: "Minecraft build, and .schematic, .litematic: colours by the names of the blocks",
    },
    Format {
        extension: "mca",
        read: true,
        write: false,
        about: "region of a Minecraft world; or name the world's folder",
    },
    Format {
        extension: "qb",
        read: true,
        write: false,
        about: "Qubicle model, and .qbt, .qbcl, .qef: matrices of colours",
    },
    Format {
        extension: "asc",
        read: true,
        write: false,
        about: "heightmap: ESRI grid, .dem of the USGS, one picture (PNG of 8 or 16 bits, TIFF of one page)",
    },
    Format { extension: "binvox", read: true, write: false, about: "voxels without colours" },
    Format {
        extension: "vxf",
        read: true,
        write: true,
        about: "voxtrace film: continue it (render --resume), add it up (merge)",
    },
    Format {
        extension: "png",
        read: true,
        write: true,
        about: "picture, 8 or 16 bits, sRGB, optional alpha; read as a heightmap, a folder of them as slices",
    },
    Format {
        extension: "exr",
        read: false,
        write: true,
        about: "picture, linear, 16- or 32-bit floats, optional layers",
    },
];

/// List the kinds of files that can be read and written
#[derive(clap::Args, Clone, Debug)]
pub struct FormatsArgs {
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl FormatsArgs {
    pub fn run(self) -> Result<(), Failure> {
        if self.json {
            let formats = FORMATS.map(|format| {
                json!({ "extension": format.extension, "read": format.read, "write": format.write, "about": format.about })
            });
            crate::stdout::print(&format!("{:#}\n", json!({ "formats": formats })));
            return Ok(());
        }
        let yes = |yes: bool| if yes { "yes" } else { "-" };
        crate::stdout::print(&format!("{:<7}{:<6}{:<7}{}\n", "kind", "read", "write", "what"));
        for format in FORMATS {
            crate::stdout::print(&format!(
                ".{:<6}{:<6}{:<7}{}\n",
                format.extension,
                yes(format.read),
                yes(format.write),
                format.about
            ));
        }
        Ok(())
    }
}
