//! Frames in several directions, as localizers have them: those in one direction are a stack, and one stack is read.

use super::place_of;
use super::stack::Slice;

/// The slices in one direction, and what there is to say about the others. `wanted` is the number of the stack, from 1 on in the order
/// of their first frames; else it is the largest.
pub(super) fn choose(slices: Vec<Slice>, wanted: Option<i64>) -> Result<(Vec<Slice>, Option<String>), String> {
    let mut stacks: Vec<Vec<Slice>> = Vec::new();
    for slice in slices {
        match place_of(slice.directions, stacks.iter().map(|stack| stack[0].directions)) {
            Some(place) => stacks[place].push(slice),
            None => stacks.push(vec![slice]),
        }
    }
    let sizes: Vec<usize> = stacks.iter().map(Vec::len).collect();
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
    let stack = stacks.into_iter().nth(chosen).unwrap_or_default();
    Ok((stack, note))
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

    #[test]
    fn directions_that_differ_in_their_last_digits_are_one() {
        // A tilt of 0.1235 is rounded to 0.123 or to 0.124, as its next digits say.
        let turned = |sine: f64| (DVec3::X, DVec3::new(0.0, (1.0 - sine * sine).sqrt(), sine));
        let slices = [0.123_499_9, 0.123_500_1, 0.123_499_8, 0.2].map(|sine| Slice {
            position: None,
            directions: turned(sine),
            number: 0.0,
            frame: 0,
            values: vec![0.0],
        });
        let (stack, note) = choose(slices.into(), None).unwrap();
        assert_eq!(stack.len(), 3);
        assert!(note.is_some_and(|note| note.contains("2 directions")));
        // What is like two that are not alike belongs to the nearer.
        let slices = [0.0, 0.0018, 0.000_95].map(|sine| Slice {
            position: None,
            directions: turned(sine),
            number: 0.0,
            frame: 0,
            values: vec![sine as f32],
        });
        let (stack, _) = choose(slices.into(), None).unwrap();
        assert_eq!(stack.iter().map(|slice| slice.values[0]).collect::<Vec<_>>(), [0.0018, 0.000_95]);
    }
}
