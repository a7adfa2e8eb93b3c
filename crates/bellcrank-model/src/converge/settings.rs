//! What flexible bodies say of modes and meshes, and other values for it.

use crate::design::{Design, Kept, SolidForm, Study};
use crate::elastic::End;
use crate::flex;
use crate::progress::Progress;

/// Where a file keeps fewer modes, the ladder goes up to this many.
const FEWEST: usize = 4;

/// Settings of the file.
pub(super) struct Own {
    bodies: Vec<OwnBody>,
}

struct OwnBody {
    /// Place in the list of bodies.
    body: usize,
    count: usize,
    /// Of `modes`.
    kept: Kept,
    segments: usize,
    is_solid: bool,
}

impl Own {
    /// Of the flexible bodies of a design; reductions tell how many modes they keep.
    pub(super) fn of(design: &Design, study: &Study, progress: &mut dyn Progress) -> Result<Own, End> {
        let mut bodies = Vec::new();
        for (body, of) in design.bodies.iter().enumerate() {
            let Some(form) = &of.flexible else { continue };
            let is_solid = of.solid.is_some();
            let count = match is_solid {
                true if form.modes.frequency.is_some() => flex::of_body(design, study, body, progress)?.reduced.modes(),
                _ => form.modes.count,
            };
            bodies.push(OwnBody { body, count, kept: form.modes.clone(), segments: form.segments, is_solid });
        }
        Ok(Own { bodies })
    }

    pub(super) fn count(&self) -> usize {
        self.bodies.len()
    }

    /// Of all bodies.
    pub(super) fn most_modes(&self) -> usize {
        self.bodies.iter().map(|own| own.count).max().unwrap_or(0)
    }

    /// Places of those that are solids.
    pub(super) fn solids(&self) -> impl Iterator<Item = usize> + '_ {
        self.bodies.iter().filter(|own| own.is_solid).map(|own| own.body)
    }

    /// Whether each deforms without modes: by its interfaces.
    pub(super) fn all_held_twice(&self, design: &Design) -> bool {
        let interfaces = |body: usize| design.bodies[body].flexible.as_ref().map_or(0, |form| form.interfaces.len());
        self.solids().all(|body| interfaces(body) > 1)
    }

    /// Names of bodies whose meshes are given.
    pub(super) fn with_given_meshes(&self, design: &Design) -> Vec<String> {
        let form = |body: usize| Some(&design.solids.get(design.bodies[body].solid.as_ref()?.solid)?.form);
        let given = |body: &usize| matches!(form(*body), Some(SolidForm::File(_)));
        self.solids().filter(given).map(|body| design.bodies[body].name.clone()).collect()
    }

    /// Has every body keep so many modes.
    pub(super) fn keep(&self, design: &mut Design, count: usize) {
        self.each(design, |_, form| form.modes = Kept { count, frequency: None });
    }

    /// Has every mesh be finer, and every beam have more segments.
    pub(super) fn scale(&self, design: &mut Design, scale: f64) {
        self.each(design, |own, form| {
            form.mesh.scale = Some(scale);
            form.segments = (own.segments as f64 / scale).ceil() as usize;
        });
    }

    /// As the file says.
    pub(super) fn restore(&self, design: &mut Design) {
        self.each(design, |own, form| {
            form.modes = own.kept.clone();
            form.mesh.scale = None;
            form.segments = own.segments;
        });
    }

    fn each(&self, design: &mut Design, change: impl Fn(&OwnBody, &mut crate::design::Flexible)) {
        for own in &self.bodies {
            if let Some(form) = &mut design.bodies[own.body].flexible {
                change(own, form);
            }
        }
    }
}

/// 0, 2, 4, 8 … and at last twice what the file keeps; 0 only where bodies deform without modes.
pub(super) fn counts(own: usize, from_none: bool) -> Vec<usize> {
    let top = (2 * own).max(FEWEST);
    let powers = (1..usize::BITS).map(|power| 1_usize << power).take_while(|count| *count < top);
    from_none.then_some(0).into_iter().chain(powers).chain([top]).collect()
}

#[cfg(test)]
mod tests {
    use super::counts;

    #[test]
    fn counts_double_up_to_twice_the_own() {
        assert_eq!(counts(10, true), [0, 2, 4, 8, 16, 20]);
        assert_eq!(counts(8, false), [2, 4, 8, 16]);
        assert_eq!(counts(0, true), [0, 2, 4]);
        assert_eq!(counts(1, true), [0, 2, 4]);
    }
}
