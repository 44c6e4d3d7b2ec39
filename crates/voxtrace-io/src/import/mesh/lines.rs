//! The lines of a file that has no faces: points along them, so close that a grid of the usual resolution shows no gap.

use voxtrace_voxelize::Limits;
use voxtrace_voxelize::mesh::Mesh;

/// Points along the longest side of the box around all lines.
const ALONG: f32 = 1024.0;

/// Pairs of vertices that lines join.
#[derive(Default)]
pub(crate) struct Lines {
    pairs: Vec<[u32; 2]>,
}

impl Lines {
    pub fn len(&self) -> usize {
        self.pairs.len()
    }

    /// Takes a line between two vertices, which must be there before [`Self::draw`].
    pub fn join(&mut self, from: u32, to: u32) {
        self.pairs.push([from, to]);
    }

    /// Takes the vertices of a line of OBJ that goes through all of them: numbers from 1, or from −1 back from the last one, each perhaps
    /// with a texture coordinate behind a slash. What names no vertex is left out.
    pub fn push(&mut self, rest: &[u8], count: usize) {
        let mut before = None;
        for word in rest.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()) {
            let number = word.split(|&byte| byte == b'/').next().unwrap_or_default();
            let number = std::str::from_utf8(number).ok().and_then(|number| number.parse::<i64>().ok());
            let index = number.map(|number| if number < 0 { count as i64 + number } else { number - 1 });
            let vertex = index.and_then(|index| u32::try_from(index).ok()).filter(|&index| (index as usize) < count);
            if let (Some(from), Some(to)) = (before, vertex) {
                self.pairs.push([from, to]);
            }
            before = vertex;
        }
    }

    /// Adds the points between the ends of all lines to the vertices, with the colours between theirs.
    ///
    /// # Errors
    /// How many points there would be, where that is more than allowed.
    pub fn draw(&self, mesh: &mut Mesh, limits: &Limits) -> Result<(), u64> {
        let vertices = self.pairs.iter().flatten().map(|&vertex| mesh.positions[vertex as usize]);
        let Some(low) = vertices.clone().reduce(|a, b| a.min(b)) else { return Ok(()) };
        let high = vertices.fold(low, |a, b| a.max(b));
        let step = (high - low).max_element() / ALONG;
        if step.is_nan() || step <= 0.0 {
            return Ok(());
        }
        let mut count = mesh.positions.len() as u64;
        for pair in &self.pairs {
            let [from, to] = pair.map(|vertex| vertex as usize);
            let (a, b) = (mesh.positions[from], mesh.positions[to]);
            let pieces = ((b - a).length() / step).ceil().max(1.0) as u32;
            count += u64::from(pieces);
            if count > limits.points {
                return Err(count);
            }
            for piece in 1..pieces {
                let share = piece as f32 / pieces as f32;
                mesh.positions.push(a.lerp(b, share));
                if !mesh.colors.is_empty() {
                    mesh.colors.push(mesh.colors[from].lerp(mesh.colors[to], share));
                }
            }
        }
        Ok(())
    }
}
