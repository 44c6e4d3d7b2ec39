//! Cameras as TOML, in the form that `voxtrace render --camera-file` reads: `eye`, `target`, `up`, `fov_y` and `name`. Numbers are as
//! short as they can be and read as the same bits.

use toml::{Table, Value};
use voxtrace::Camera;
use voxtrace::camera::Lens;
use voxtrace::glam::{DVec3, Vec3};

/// Field of view where none is said, degrees.
const FOV_Y: f64 = 45.0;

/// A camera as the text of a camera file.
pub fn camera_toml(camera: &Camera) -> String {
    let vector = |vector: Vec3| array_of(vector).to_string();
    let mut text = format!(
        "name = {}\neye = {}\ntarget = {}\nup = {}\nfov_y = {}\n",
        Value::String(camera.name.clone()),
        vector(camera.eye),
        vector(camera.target),
        vector(camera.up),
        Value::Float(widened(camera.fov_y)),
    );
    if camera.lens != Lens::Pinhole {
        text += &format!("lens = {}\n", Value::String(camera.lens.name().into()));
        text.extend(
            camera
                .lens
                .settings()
                .into_iter()
                .map(|(key, value)| format!("{key} = {}\n", Value::Float(widened(value)))),
        );
    }
    text
}

/// Writes a camera into a table, beside what else is there.
pub(crate) fn write(camera: &Camera, table: &mut Table) {
    table.insert("name".into(), Value::String(camera.name.clone()));
    for (key, vector) in [("eye", camera.eye), ("target", camera.target), ("up", camera.up)] {
        table.insert(key.into(), array_of(vector));
    }
    table.insert("fov_y".into(), Value::Float(widened(camera.fov_y)));
    if camera.lens != Lens::Pinhole {
        table.insert("lens".into(), Value::String(camera.lens.name().into()));
        table.extend(camera.lens.settings().into_iter().map(|(key, value)| (key.into(), Value::Float(widened(value)))));
    }
}

/// Reads a camera from a table; the error says what is wrong.
pub(crate) fn read(table: &Table) -> Result<Camera, String> {
    let required = |key: &str| vector(table, key)?.ok_or_else(|| format!("`{key}` is missing"));
    let fov_y = table.get("fov_y").map_or(Ok(FOV_Y), |value| number(value).ok_or("`fov_y` is not a finite number"))?;
    let camera = Camera {
        name: table.get("name").and_then(Value::as_str).unwrap_or("default").to_owned(),
        eye: required("eye")?,
        target: required("target")?,
        up: vector(table, "up")?.unwrap_or(Vec3::Z),
        fov_y: fov_y as f32,
        lens: match table.get("lens") {
            None => Lens::Pinhole,
            Some(lens) => {
                let lens = lens.as_str().ok_or("`lens` is not a name in quotes")?;
                Lens::from_settings(lens, |key| table.get(key).and_then(number).map(|value| value as f32))?
            }
        },
    };
    camera.check()?;
    match camera.eye == camera.target {
        true => Err("the camera stands on its target".into()),
        false if camera.up == Vec3::ZERO => Err("`up` is no direction".into()),
        false => Ok(camera),
    }
}

pub(crate) fn array_of(vector: Vec3) -> Value {
    Value::Array(vector.to_array().map(|number| Value::Float(widened(number))).to_vec())
}

/// The shortest decimal number that reads as the same bits, which the nearest f64 is usually not: 0.1, and not 0.10000000149011612.
fn widened(value: f32) -> f64 {
    let short = value.to_string().parse().unwrap_or(f64::from(value));
    // Readers round twice, by way of f64.
    if (short as f32).to_bits() == value.to_bits() { short } else { f64::from(value) }
}

fn number(value: &Value) -> Option<f64> {
    let value = value.as_float().or_else(|| value.as_integer().map(|value| value as f64))?;
    (value as f32).is_finite().then_some(value)
}

fn vector(table: &Table, key: &str) -> Result<Option<Vec3>, String> {
    let read = |value: &Value| {
        let numbers: Vec<f64> = value.as_array()?.iter().map(number).collect::<Option<_>>()?;
        <[f64; 3]>::try_from(numbers).ok().map(|numbers| DVec3::from_array(numbers).as_vec3())
    };
    table.get(key).map(|value| read(value).ok_or_else(|| format!("`{key}` is not [x, y, z]"))).transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bits(camera: &Camera) -> Vec<u32> {
        let vectors = [camera.eye, camera.target, camera.up].map(|vector| vector.to_array().map(f32::to_bits));
        vectors.into_iter().flatten().chain([camera.fov_y.to_bits()]).collect()
    }

    #[test]
    fn a_printed_camera_is_short_and_reads_as_the_same_bits() {
        let mut word = 12345u32;
        let mut next = || {
            word = word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let value = f32::from_bits(word);
            if value.is_finite() { value } else { 0.5 }
        };
        for _ in 0..20_000 {
            let mut vector = || Vec3::new(next(), next(), next());
            let (eye, target, up) = (vector(), vector(), vector());
            let camera = Camera { name: "a \"b\"\n\\".into(), eye, target, up, fov_y: 33.3, lens: Lens::Pinhole };
            let read = read(&camera_toml(&camera).parse().unwrap()).unwrap();
            assert_eq!((bits(&read), &read.name), (bits(&camera), &camera.name));
            let other = Camera { eye: Vec3 { x: f32::from_bits(eye.x.to_bits() ^ 1), ..eye }, ..camera.clone() };
            assert_ne!(bits(&other), bits(&camera), "the comparison sees the last bit");
        }
        let lens = Lens::Thin { aperture: 0.1, focus: 33.3, blades: 6, blade_rotation: -0.7 };
        let thin = Camera::look_at(Vec3::ONE, Vec3::ZERO).with_lens(lens);
        assert_eq!(read(&camera_toml(&thin).parse().unwrap()).unwrap(), thin);
        let camera = Camera { fov_y: 0.1, ..Camera::look_at(Vec3::new(0.1, -2.0, 1e-9), Vec3::ZERO) };
        let text = camera_toml(&camera);
        assert!(text.contains("eye = [0.1, -2.0, ") && text.contains("fov_y = 0.1\n"), "{text}");
    }

    #[test]
    fn what_is_missing_or_no_number_is_named() {
        let fails = |text: &str| read(&text.parse().unwrap()).unwrap_err();
        assert!(fails("eye = [1, 2, 3]").contains("`target`"));
        assert!(fails("eye = [1, 2]\ntarget = [0, 0, 0]").contains("`eye`"));
        assert!(fails("eye = [1, 2, nan]\ntarget = [0, 0, 0]").contains("`eye`"));
        assert!(fails("eye = [1, 2, 3]\ntarget = [1, 2, 3]").contains("target"));
        assert!(fails("eye = [1, 2, 3]\ntarget = [0, 0, 0]\nfov_y = 180").contains("field of view"));
        assert!(fails("eye = [1, 2, 3]\ntarget = [0, 0, 0]\nup = [0, 0, 0]").contains("`up`"));
        assert!(read(&"eye = [1, 2, 3]\ntarget = [0, 0, 0]".parse().unwrap()).is_ok());
    }
}
