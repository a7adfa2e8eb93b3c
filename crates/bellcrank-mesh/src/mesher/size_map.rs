//! Sizes at scattered places, for example from the error of every element of a mesh.

/// Places with a wanted size each; asked for the size at the nearest one.
///
/// Made for [`crate::Sizes::background`]: `let background = |at| map.at(at)`.
#[derive(Clone, Debug)]
pub struct SizeMap {
    low: [f64; 3],
    /// Side of a box in m, and number of boxes along each axis.
    side: f64,
    counts: [usize; 3],
    /// Where the places of each box begin in `places`.
    starts: Vec<usize>,
    places: Vec<([f64; 3], f64)>,
}

/// Places in a box, on average.
const IN_A_BOX: f64 = 4.0;

impl SizeMap {
    /// Sorts places (in m) with their sizes into boxes. Places and sizes that are not finite are left out.
    pub fn new(wanted: impl IntoIterator<Item = ([f64; 3], f64)>) -> SizeMap {
        let sound = |(at, size): &([f64; 3], f64)| at.iter().all(|c| c.is_finite()) && size.is_finite() && *size > 0.0;
        let mut places: Vec<([f64; 3], f64)> = wanted.into_iter().filter(sound).collect();
        let bound = |i: usize, of: fn(f64, f64) -> f64| places.iter().map(|(at, _)| at[i]).reduce(of).unwrap_or(0.0);
        let low: [f64; 3] = std::array::from_fn(|i| bound(i, f64::min));
        let span: [f64; 3] = std::array::from_fn(|i| bound(i, f64::max) - low[i]);
        let longest = span.iter().fold(0.0_f64, |most, &s| most.max(s)).max(f64::MIN_POSITIVE);
        // Flat parts have boxes in two directions only.
        let volume: f64 = span.iter().map(|s| s.max(longest / 100.0)).product();
        let side = (volume * IN_A_BOX / places.len().max(1) as f64).cbrt().max(longest / 500.0);
        let counts = span.map(|s| (s / side) as usize + 1);
        let mut map = SizeMap { low, side, counts, starts: Vec::new(), places: Vec::new() };
        places.sort_by_key(|(at, _)| map.number(map.index(*at)));
        let total = counts.iter().product::<usize>();
        map.starts = vec![0; total + 1];
        for (at, _) in &places {
            let number = map.number(map.index(*at));
            map.starts[number + 1] += 1;
        }
        (1..=total).for_each(|k| map.starts[k] += map.starts[k - 1]);
        map.places = places;
        map
    }

    fn index(&self, at: [f64; 3]) -> [usize; 3] {
        std::array::from_fn(|i| (((at[i] - self.low[i]) / self.side).max(0.0) as usize).min(self.counts[i] - 1))
    }

    fn number(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.counts[1] + j) * self.counts[2] + k
    }

    /// Size in m at the place nearest to this one; infinite when there is none.
    pub fn at(&self, at: [f64; 3]) -> f64 {
        let center = self.index(at);
        let (mut nearest, mut size) = (f64::INFINITY, f64::INFINITY);
        let most = self.counts.iter().max().copied().unwrap_or(1);
        for ring in 0..=most {
            // Boxes of a ring are at least that far, as seen from within the middle box.
            let least = (ring as f64 - 1.0).max(0.0) * self.side;
            if least * least > nearest {
                break;
            }
            self.ring(center, ring, |(place, wanted)| {
                let square: f64 = (0..3).map(|i| (place[i] - at[i]).powi(2)).sum();
                if square < nearest {
                    (nearest, size) = (square, *wanted);
                }
            });
        }
        size
    }

    /// Visits the places in the boxes that are `ring` boxes from the middle one.
    fn ring(&self, center: [usize; 3], ring: usize, mut visit: impl FnMut(&([f64; 3], f64))) {
        let range = |i: usize| center[i].saturating_sub(ring)..(center[i] + ring + 1).min(self.counts[i]);
        for i in range(0) {
            for j in range(1) {
                for k in range(2) {
                    let far = i.abs_diff(center[0]).max(j.abs_diff(center[1])).max(k.abs_diff(center[2]));
                    if far == ring {
                        let number = self.number([i, j, k]);
                        self.places[self.starts[number]..self.starts[number + 1]].iter().for_each(&mut visit);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::SizeMap;

    #[test]
    fn the_nearest_place_is_found() {
        let coordinate = |seed: usize, scale: f64| ((seed * 7919 + 13) % 1009) as f64 / 1009.0 * scale;
        let places: Vec<([f64; 3], f64)> = (0..500)
            .map(|k| ([coordinate(k, 0.7), coordinate(k * 31 + 5, 0.3), coordinate(k * 17 + 3, 0.02)], 1.0 + k as f64))
            .collect();
        let map = SizeMap::new(places.clone());
        for k in 0..300 {
            let at = [coordinate(k + 77, 1.0) - 0.1, coordinate(k * 3 + 2, 0.4), coordinate(k * 11, 0.05)];
            let square = |place: [f64; 3]| (0..3).map(|i| (place[i] - at[i]).powi(2)).sum::<f64>();
            let nearest = places.iter().min_by(|a, b| square(a.0).total_cmp(&square(b.0))).expect("there are places");
            assert_eq!(map.at(at), nearest.1);
        }
        assert_eq!(SizeMap::new([]).at([0.0; 3]), f64::INFINITY);
    }
}
