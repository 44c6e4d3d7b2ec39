//! Choosing one of many by weight in constant time: Vose, "A Linear Algorithm for Generating Random Numbers with a Given
//! Distribution", IEEE Transactions on Software Engineering 1991.

/// One column of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Share of the column that is its own.
    pub threshold: f32,
    /// To whom the rest belongs.
    pub alias: u32,
}

/// The table of weights, of which none is negative and one is more than 0: each column is as likely as the others.
pub fn alias_table(weights: &[f64]) -> Vec<Column> {
    let scale = weights.len() as f64 / weights.iter().sum::<f64>();
    let mut left: Vec<f64> = weights.iter().map(|weight| weight * scale).collect();
    let (mut small, mut large): (Vec<u32>, Vec<u32>) =
        (0..weights.len() as u32).partition(|&index| left[index as usize] < 1.0);
    // What remains when one of the lists is empty is 1, but for rounding.
    let mut columns: Vec<Column> = (0..weights.len() as u32).map(|alias| Column { threshold: 1.0, alias }).collect();
    while let (Some(&of), Some(&from)) = (small.last(), large.last()) {
        small.pop();
        columns[of as usize] = Column { threshold: left[of as usize] as f32, alias: from };
        left[from as usize] -= 1.0 - left[of as usize];
        if left[from as usize] < 1.0 {
            large.pop();
            small.push(from);
        }
    }
    // Rounding may leave one that has no weight: it is never to be chosen.
    let heaviest = (0..weights.len()).max_by(|&a, &b| weights[a].total_cmp(&weights[b])).unwrap_or(0) as u32;
    for (column, &weight) in columns.iter_mut().zip(weights) {
        if weight <= 0.0 && column.threshold > 0.0 {
            *column = Column { threshold: 0.0, alias: heaviest };
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Probabilities that a table gives.
    fn probabilities(columns: &[Column]) -> Vec<f64> {
        let mut probabilities = vec![0.0; columns.len()];
        for (index, column) in columns.iter().enumerate() {
            probabilities[index] += f64::from(column.threshold) / columns.len() as f64;
            probabilities[column.alias as usize] += (1.0 - f64::from(column.threshold)) / columns.len() as f64;
        }
        probabilities
    }

    #[test]
    fn each_is_as_likely_as_its_weight() {
        let many: Vec<f64> = (0..1000).map(|index| f64::from(index * index % 97) + 1e-3).collect();
        for weights in [vec![3.0], vec![0.0, 1.0, 0.0], vec![1.0, 1e6, 1.0, 2.0], vec![1e-30; 5], many] {
            let sum: f64 = weights.iter().sum();
            let check = |columns: &[Column]| {
                let pairs = probabilities(columns).into_iter().zip(&weights);
                pairs.into_iter().all(|(probability, weight)| {
                    (probability - weight / sum).abs() < 1e-7 && (probability > 0.0) == (*weight > 0.0)
                })
            };
            let mut columns = alias_table(&weights);
            assert!(check(&columns), "{columns:?}");
            columns[0].threshold = 0.5 * columns[0].threshold + 0.25;
            columns[0].alias = weights.len() as u32 - 1;
            assert!(weights.len() == 1 || !check(&columns));
        }
    }
}
