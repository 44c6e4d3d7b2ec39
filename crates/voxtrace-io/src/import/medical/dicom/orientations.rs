//! Frames in several directions, as localizers have them: those in one direction are a stack, and one stack is read.

use super::stack::Slice;

/// The slices in one direction, and what there is to say about the others. `wanted` is the number of the stack, from 1 on in the order
/// of their first frames; else it is the largest.
pub(super) fn choose(slices: Vec<Slice>, wanted: Option<i64>) -> Result<(Vec<Slice>, Option<String>), String> {
    let mut stacks: Vec<([i64; 6], Vec<Slice>)> = Vec::new();
    for slice in slices {
        let key = directions(&slice);
        match stacks.iter_mut().find(|(own, _)| *own == key) {
            Some((_, stack)) => stack.push(slice),
            None => stacks.push((key, vec![slice])),
        }
    }
    let sizes: Vec<usize> = stacks.iter().map(|(_, stack)| stack.len()).collect();
    let all = || {
        sizes.iter().zip(1..).map(|(size, number)| format!("{number}: {size} frames")).collect::<Vec<_>>().join(", ")
    };
    let largest = sizes.iter().max().and_then(|most| sizes.iter().position(|size| size == most)).unwrap_or(0);
    let chosen = match wanted {
        Some(number) if sizes.len() > 1 => number
            .checked_sub(1)
            .and_then(|place| usize::try_from(place).ok())
            .filter(|&place| place < sizes.len())
            .ok_or_else(|| format!("no stack {number} among the directions of the frames: there are {}", all()))?,
        _ => largest,
    };
    let note = (sizes.len() > 1).then(|| {
        format!(
            "frames lie in {} directions: stack {} is read; --series chooses another: {}",
            sizes.len(),
            chosen + 1,
            all()
        )
    });
    let stack = stacks.into_iter().nth(chosen).map(|(_, stack)| stack).unwrap_or_default();
    Ok((stack, note))
}

/// Directions of columns and rows in thousandths.
fn directions(slice: &Slice) -> [i64; 6] {
    let (x, y) = slice.directions;
    [x.x, x.y, x.z, y.x, y.y, y.z].map(|value| (value * 1000.0).round() as i64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn slices() -> Vec<Slice> {
        let slice = |frame: usize| {
            let directions = if frame < 2 { (DVec3::X, DVec3::Y) } else { (DVec3::Y, DVec3::NEG_Z) };
            Slice { position: None, directions, number: 0.0, frame, values: vec![frame as f32] }
        };
        (0..5).map(slice).collect()
    }

    #[test]
    fn the_largest_stack_is_read_or_the_one_that_is_asked_for() {
        let frames = |wanted| {
            let (stack, note) = choose(slices(), wanted).unwrap();
            assert!(note.is_some_and(|note| note.contains("1: 2 frames, 2: 3 frames")));
            stack.iter().map(|slice| slice.frame).collect::<Vec<_>>()
        };
        assert_eq!((frames(None), frames(Some(1)), frames(Some(2))), (vec![2, 3, 4], vec![0, 1], vec![2, 3, 4]));
        for wrong in [0, 3, -1, i64::MIN] {
            assert!(choose(slices(), Some(wrong)).is_err());
        }
        // Where there is one, the number is that of its series.
        let one = choose(slices().drain(..2).collect(), Some(9)).unwrap();
        assert_eq!((one.0.len(), one.1), (2, None));
    }
}
