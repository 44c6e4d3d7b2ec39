//! Each function gives what rayon's of its name gives.

/// Asserts that an expression has the same value with rayon's traits and with these; `rayon` names either crate in it.
macro_rules! same {
    ($($what:expr),+ $(,)?) => {$({
        let ours = {
            use crate as rayon;
            #[allow(unused_imports)]
            use rayon::prelude::*;
            $what
        };
        let theirs = {
            #[allow(unused_imports)]
            use rayon::prelude::*;
            $what
        };
        assert_eq!(ours, theirs, "{}", stringify!($what));
    })+};
}

const NUMBERS: [u32; 9] = [31, 4, 15, 9, 2, 65, 35, 8, 97];

#[test]
fn adaptors_are_those_of_rayon() {
    same!(
        NUMBERS.par_iter().map(|n| n * 2).collect::<Vec<_>>(),
        NUMBERS.into_par_iter().filter(|n| n % 2 == 1).collect::<Vec<_>>(),
        NUMBERS.par_iter().with_min_len(2).filter_map(|n| n.checked_sub(10)).collect::<Vec<_>>(),
        NUMBERS.par_iter().enumerate().map(|(i, n)| i as u32 * n).with_max_len(2).sum::<u32>(),
        NUMBERS.par_iter().zip(&NUMBERS[3..]).map(|(a, b)| a * b).collect::<Vec<_>>(),
        NUMBERS.par_iter().zip(NUMBERS.par_iter()).map(|(a, b)| a * b).max(),
        (0..5_u32).into_par_iter().map(|n| vec![n; n as usize]).flatten().collect::<Vec<_>>(),
        (0..5_u32).into_par_iter().map(|n| vec![n; n as usize]).flatten_iter().collect::<Vec<_>>(),
        (0..5_u32).into_par_iter().flat_map_iter(|n| 0..n).collect::<Vec<_>>(),
        (0..5_u32).into_par_iter().map_init(|| 7, |state, n| *state + n).collect::<Vec<_>>(),
        NUMBERS.par_iter().map(|&n| n.checked_sub(3).ok_or(n)).collect::<Result<Vec<_>, _>>(),
        NUMBERS.par_iter().filter(|n| **n > 2).copied().collect::<Vec<_>>(),
    );
}

#[test]
fn consumers_are_those_of_rayon() {
    same!(
        NUMBERS.into_par_iter().fold(|| 0, |sum, n| sum + n).reduce(|| 0, |a, b| a + b),
        NUMBERS.into_par_iter().reduce(|| 0, u32::max),
        NUMBERS.into_par_iter().reduce_with(u32::max),
        (0..0_u32).into_par_iter().reduce_with(u32::max),
        NUMBERS.par_iter().find_map_first(|&n| (n > 20).then_some(n)),
        NUMBERS.par_iter().find_map_any(|&n| (n > 90).then_some(n)),
        NUMBERS.par_iter().position_first(|&n| n == 2),
        NUMBERS.par_iter().filter(|n| **n > 2).count(),
        NUMBERS.par_iter().all(|&n| n > 2),
        NUMBERS.par_iter().all(|&n| n > 1),
        NUMBERS.par_iter().map(|&n| if n > 0 { Ok(n) } else { Err(n) }).try_reduce(|| 0, |a, b| Ok(a + b)),
        NUMBERS.par_iter().map(|&n| if n != 65 { Ok(n) } else { Err(n) }).try_reduce(|| 0, |a, b| Ok(a + b)),
        {
            let mut list = NUMBERS;
            list.par_iter_mut().for_each_init(|| 5, |state, n| *n += *state);
            list
        },
        {
            let mut list = vec![1_u32];
            list.par_extend(NUMBERS.into_par_iter().map(|n| n + 1));
            list.par_iter_mut().for_each(|n| *n *= 2);
            list
        },
    );
}

#[test]
fn slices_are_divided_and_sorted_as_by_rayon() {
    same!(
        NUMBERS.par_chunks(4).map(|part| part.iter().sum::<u32>()).collect::<Vec<_>>(),
        {
            let mut list = NUMBERS;
            list.par_chunks_mut(4).enumerate().for_each(|(i, part)| part[0] = i as u32);
            list.par_chunks_exact_mut(2).for_each(|part| part.swap(0, 1));
            list
        },
        {
            let mut lists = [NUMBERS; 5];
            lists[0].par_sort_unstable();
            lists[1].par_sort_unstable_by(|a, b| b.cmp(a));
            lists[2].par_sort_unstable_by_key(|n| (n % 7, *n));
            lists[3].par_sort_by_key(|n| n % 2);
            lists[4].par_sort_by_cached_key(|n| n % 3);
            lists
        },
    );
}

#[test]
fn threads_are_one() {
    same!(rayon::join(|| 1, || 2), rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap().install(|| 3), {
        let mut parts = NUMBERS;
        rayon::in_place_scope(|scope| {
            for part in parts.chunks_mut(2) {
                scope.spawn(move |_| part[0] += 1);
            }
        });
        parts
    },);
    assert_eq!(crate::current_num_threads(), 1);
}
