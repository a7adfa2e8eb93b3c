//! Studies that choose a drive.

use std::sync::Arc;

use bellcrank_doc::Expression;
use bellcrank_multibody::Coordinate;
use bellcrank_sizing::electric::{Drive, Kind};
use bellcrank_sizing::pneumatic::{BucklingLoad, Cylinder, EndCondition, Mount};

/// Which drive to take for a coordinate that carries an effort.
#[derive(Clone, Debug)]
pub(crate) struct Sizing {
    pub(crate) drive: Coordinate,
    /// The rod comes out while the coordinate shrinks.
    pub(crate) reversed: bool,
    pub(crate) stroke_reserve: Option<Expression>,
    pub(crate) actuator: Actuator,
}

#[derive(Clone, Debug)]
pub(crate) enum Actuator {
    Pneumatic(Box<Pneumatic>),
    Electric(Electric),
}

/// A cylinder; what is `None` is as [`bellcrank_sizing::pneumatic::Conditions::new`] has it.
#[derive(Clone, Debug)]
pub(crate) struct Pneumatic {
    pub(crate) supply: Expression,
    pub(crate) atmosphere: Option<Expression>,
    pub(crate) load_factor: Option<Expression>,
    pub(crate) efficiency: Option<Expression>,
    pub(crate) mounting: Mount,
    pub(crate) ends: EndCondition,
    pub(crate) offset: Option<Expression>,
    pub(crate) buckling_safety: Option<Expression>,
    pub(crate) buckling_load: BucklingLoad,
    pub(crate) moved_mass: Option<Expression>,
    pub(crate) arrival_speed: Option<Expression>,
    pub(crate) cycles: Option<Expression>,
    pub(crate) dead_volume: Option<Expression>,
    pub(crate) valve: Option<Valve>,
    pub(crate) cylinders: Arc<[Cylinder]>,
}

/// A valve after ISO 6358.
#[derive(Clone, Debug)]
pub(crate) struct Valve {
    pub(crate) sonic: Expression,
    pub(crate) critical_ratio: Expression,
    pub(crate) index: Option<Expression>,
}

/// An electric drive.
#[derive(Clone, Debug)]
pub(crate) struct Electric {
    pub(crate) kind: Kind,
    pub(crate) safety: Option<Expression>,
    pub(crate) cycle_time: Option<Expression>,
    pub(crate) drives: Arc<[Drive]>,
}

impl Sizing {
    /// Every expression in it.
    pub(super) fn each_expression(&self, visit: &mut dyn FnMut(&Expression)) {
        self.stroke_reserve.iter().for_each(&mut *visit);
        match &self.actuator {
            Actuator::Pneumatic(of) => {
                visit(&of.supply);
                let optional = [
                    &of.atmosphere,
                    &of.load_factor,
                    &of.efficiency,
                    &of.offset,
                    &of.buckling_safety,
                    &of.moved_mass,
                    &of.arrival_speed,
                    &of.cycles,
                    &of.dead_volume,
                ];
                optional.into_iter().flatten().for_each(&mut *visit);
                if let Some(valve) = &of.valve {
                    [&valve.sonic, &valve.critical_ratio].into_iter().chain(&valve.index).for_each(&mut *visit);
                }
            }
            Actuator::Electric(of) => [&of.safety, &of.cycle_time].into_iter().flatten().for_each(visit),
        }
    }
}
