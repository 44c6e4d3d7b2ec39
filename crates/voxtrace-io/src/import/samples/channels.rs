//! Several numbers at a place, or several channels of one picture: they become colours, or one of them is chosen.

use voxtrace_voxelize::volume::Volume;

/// Colours of channels that have none: those of ImageJ's composites.
const USUAL: [[u8; 3]; 7] =
    [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255], [0, 255, 255], [255, 0, 255], [255, 255, 0]];
/// Values that are looked at to find how bright a channel is.
const LOOKS: usize = 1 << 20;
/// Share of a channel's values that may be brighter than its full colour.
const BRIGHTEST: f64 = 0.001;

/// Brightness of the darkest hue, from 0 to 1.
const DARKEST: f32 = 0.5;

/// One channel.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Channel {
    /// Its colour, sRGB; `None` takes a usual one.
    pub color: Option<[u8; 3]>,
    /// The values that are black and that have its full colour; `None` takes those that occur.
    pub window: Option<(f32, f32)>,
}

/// The number from 0 on of what people count from 1 on, where there are so many; a sentence where there are fewer.
pub(crate) fn chosen(number: Option<u32>, count: usize, what: &str) -> Result<Option<usize>, String> {
    let Some(number) = number else { return Ok(None) };
    let place = (number as usize).checked_sub(1).filter(|&place| place < count);
    place.map(Some).ok_or_else(|| format!("no {what} {number}: there are {count}, counted from 1 on"))
}

/// As [`chosen`], of the time points or other entries of a file: the first where none is asked for, and what there is to say about it.
pub(crate) fn entry(
    number: Option<u32>,
    count: usize,
    what: &str,
    option: &str,
) -> Result<(usize, Option<String>), String> {
    let place = chosen(number, count, what)?.unwrap_or(0);
    let note = (count > 1 && number.is_none())
        .then(|| format!("the first of {count} {what}s is read; {option} chooses another"));
    Ok((place, note))
}

/// Makes a volume of the channels of a picture: their colours are added, each from nothing to its brightest values, and the hue of the sum
/// is as bright as the brightest channel.
pub(crate) fn composite(size: [usize; 3], channels: &[Vec<f32>], about: &[Channel]) -> Volume {
    let mut values = vec![0.0f32; size.iter().product()];
    let mut sums = vec![[0.0f32; 3]; values.len()];
    for (n, channel) in channels.iter().enumerate() {
        let about = about.get(n).cloned().unwrap_or_default();
        let color = about.color.unwrap_or(USUAL[n % USUAL.len()]).map(f32::from);
        let (low, high) = about.window.filter(|(low, high)| low < high).unwrap_or_else(|| window(channel));
        let scale = if high > low { (high - low).recip() } else { 0.0 };
        for ((value, sum), &own) in values.iter_mut().zip(&mut sums).zip(channel) {
            // What is no number is black.
            let share = ((own - low) * scale).clamp(0.0, 1.0).max(0.0);
            *value = value.max(share * 255.0);
            (0..3).for_each(|at| sum[at] += share * color[at]);
        }
    }
    // Surfaces lie where little is seen of any channel. They keep their hue, from half its brightness on.
    let shown = |(sum, value): ([f32; 3], f32)| {
        let most = sum.iter().copied().fold(0.0, f32::max);
        let scale = if most > 0.0 { (DARKEST + (1.0 - DARKEST) * value / 255.0) * 255.0 / most } else { 0.0 };
        sum.map(|part| (part * scale).round() as u8)
    };
    let colors = sums.into_iter().zip(values.iter().copied()).map(shown).collect();
    let mut volume = Volume::new(size, values);
    volume.colors = colors;
    volume.notes.push(format!("{} channels are shown in their colours; --channel chooses one", channels.len()));
    volume
}

/// The darkest value of a channel, and one that few are brighter than.
fn window(values: &[f32]) -> (f32, f32) {
    let step = values.len().div_ceil(LOOKS).max(1);
    let mut some: Vec<f32> = values.iter().copied().filter(|value| value.is_finite()).step_by(step).collect();
    some.sort_unstable_by(f32::total_cmp);
    let Some((&low, &most)) = some.first().zip(some.last()) else { return (0.0, 0.0) };
    let high = some[((some.len() - 1) as f64 * (1.0 - BRIGHTEST)) as usize];
    // A few bright places among nothing are all that there is.
    (low, if high > low { high } else { most })
}

/// Makes a volume of samples of several numbers each, `components`, which lie one after the other: bytes and words of three or four are
/// red, green, blue and opacity, up to `full`; of others the length is taken, as of a vector. `channel` chooses one instead.
pub(crate) fn of_components(
    size: [usize; 3],
    numbers: Vec<f32>,
    components: usize,
    full: Option<f32>,
    channel: Option<u32>,
) -> Result<Volume, String> {
    if let Some(place) = chosen(channel, components, "channel")? {
        return Ok(Volume::new(size, numbers.into_iter().skip(place).step_by(components.max(1)).collect()));
    }
    if components <= 1 {
        return Ok(Volume::new(size, numbers));
    }
    let samples = numbers.chunks_exact(components);
    let Some(full) = full.filter(|_| matches!(components, 3 | 4)) else {
        let length = |sample: &[f32]| sample.iter().map(|n| f64::from(*n) * f64::from(*n)).sum::<f64>().sqrt() as f32;
        let mut volume = Volume::new(size, samples.map(length).collect());
        volume.notes.push(format!("the lengths of vectors of {components} numbers are shown; --channel chooses one"));
        return Ok(volume);
    };
    let byte = |number: f32| (number / full * 255.0).round().clamp(0.0, 255.0) as u8;
    let brightness = |sample: &[f32]| {
        let opacity = sample.get(3).map_or(1.0, |opacity| (opacity / full).clamp(0.0, 1.0));
        (0.299 * sample[0] + 0.587 * sample[1] + 0.114 * sample[2]) * opacity
    };
    let colors = samples.clone().map(|sample| [sample[0], sample[1], sample[2]].map(byte)).collect();
    let mut volume = Volume::new(size, samples.map(brightness).collect());
    volume.colors = colors;
    Ok(volume)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn channels_add_their_colours_between_their_darkest_and_brightest_values() {
        let channels = [vec![10.0, 20.0, 30.0, 10.0], vec![0.0, 0.0, 4.0, 4.0]];
        let known = Channel { color: None, window: Some((10.0, 30.0)) };
        let about = [known, Channel { color: Some([0, 100, 200]), window: Some((0.0, 8.0)) }];
        let volume = composite([4, 1, 1], &channels, &about);
        assert_eq!(volume.colors, [[0, 0, 0], [191, 0, 0], [255, 50, 100], [0, 96, 191]]);
        assert_eq!(volume.values, [0.0, 127.5, 255.0, 127.5]);
        let flat = composite([2, 1, 1], &[vec![3.0, 3.0], vec![f32::NAN, 1.0]], &[]);
        assert_eq!(flat.colors, [[0; 3]; 2]);
    }

    #[test]
    fn bytes_are_colours_and_other_numbers_vectors() {
        let rgb = of_components([2, 1, 1], vec![255.0, 0.0, 0.0, 10.0, 20.0, 30.0], 3, Some(255.0), None).unwrap();
        assert_eq!((rgb.colors, rgb.notes.len()), (vec![[255, 0, 0], [10, 20, 30]], 0));
        assert!((rgb.values[0] - 76.245).abs() < 1e-3);
        let clear = of_components([1; 3], vec![65_535.0, 65_535.0, 0.0, 0.0], 4, Some(65_535.0), None).unwrap();
        assert_eq!((clear.colors, clear.values), (vec![[255, 255, 0]], vec![0.0]));
        let vector = of_components([1; 3], vec![3.0, 0.0, -4.0], 3, None, None).unwrap();
        assert_eq!((vector.values, vector.colors.len(), vector.notes.len()), (vec![5.0], 0, 1));
        let second = of_components([2, 1, 1], vec![1.0, 2.0, 3.0, 4.0], 2, None, Some(2)).unwrap();
        assert_eq!((second.values, second.notes.len()), (vec![2.0, 4.0], 0));
        for wrong in [0, 3] {
            assert!(of_components([1; 3], vec![1.0, 2.0], 2, None, Some(wrong)).unwrap_err().contains("there are 2"));
        }
    }
}
