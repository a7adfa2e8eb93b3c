//! How an optimization went: the objective above, what is left to do below.

use super::curve;
use super::frame::Frame;
use super::legend::{Legend, stroke};
use super::scale::Scale;
use super::svg::Svg;
use super::{Axis, ticks};

/// One start, display numbers by iteration.
pub(crate) struct Course {
    pub(crate) objective: Vec<f64>,
    pub(crate) violation: Vec<f64>,
    pub(crate) optimality: Vec<f64>,
}

/// The starts of an optimization, the best one first.
pub(crate) struct Progress {
    pub(crate) title: String,
    pub(crate) objective: Axis,
    pub(crate) courses: Vec<Course>,
}

const WIDTH: f64 = 720.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 38.0;
const MIDDLE: f64 = 208.0;
const SECOND: f64 = 252.0;
const BOTTOM: f64 = 402.0;
const OTHER: &str = "stroke=\"#9aa4ae\" stroke-width=\"1.1\"";

impl Progress {
    /// The plot as an SVG document; other starts than the best are thin and grey.
    pub(crate) fn svg(&self) -> String {
        let mut names = vec!["objective", "largest violation", "first-order optimality"];
        if self.courses.len() > 1 {
            names.push("other starts");
        }
        let legend = Legend::new(names, WIDTH - LEFT - RIGHT);
        let mut svg = Svg::new((WIDTH, BOTTOM + 52.0 + legend.height() + 8.0), &self.title, "");
        let longest = self.courses.iter().map(|course| course.objective.len()).max().unwrap_or(0);
        let x = Scale::over((0.0, (longest.max(2) - 1) as f64), "", (LEFT, WIDTH - RIGHT));
        self.draw_objective(&mut svg, &x);
        self.draw_rest(&mut svg, &x);
        legend.draw_with(
            &mut svg,
            (LEFT, BOTTOM + 52.0),
            |index| if index == 3 { OTHER.to_owned() } else { stroke(index) },
        );
        svg.finish()
    }

    fn draw_objective(&self, svg: &mut Svg, x: &Scale) {
        let all = self.courses.iter().flat_map(|course| course.objective.iter().copied());
        let y = Scale::over(ticks::span(all, 0.07), &self.objective.unit, (MIDDLE, TOP));
        let frame = Frame { x, y: &y };
        frame.draw_grid(svg);
        for (index, course) in self.courses.iter().enumerate().rev() {
            let style = if index == 0 { stroke(0) } else { OTHER.to_owned() };
            draw(svg, x, &y, &course.objective, &style, index == 0);
        }
        frame.draw(svg, &self.title, ("", &self.objective.label()));
    }

    /// Violation and optimality of the best start, over powers of ten.
    fn draw_rest(&self, svg: &mut Svg, x: &Scale) {
        let Some(best) = self.courses.first() else { return };
        let y = Scale::logarithmic(best.violation.iter().chain(&best.optimality).copied(), (BOTTOM, SECOND));
        let frame = Frame { x, y: &y };
        frame.draw_grid(svg);
        draw(svg, x, &y, &best.violation, &stroke(1), true);
        draw(svg, x, &y, &best.optimality, &stroke(2), true);
        frame.draw(svg, "", ("iteration", "scaled, 0 at the bottom"));
    }
}

fn draw(svg: &mut Svg, x: &Scale, y: &Scale, values: &[f64], style: &str, dots: bool) {
    let points: Vec<_> = values.iter().enumerate().map(|(i, v)| (x.at(i as f64), y.at(*v))).collect();
    svg.path(&curve::path(&points), style);
    if !dots || points.len() > 80 {
        return;
    }
    let colour = style.split('"').nth(1).unwrap_or("#222");
    for point in points.into_iter().filter(|p| p.1.is_finite()) {
        svg.circle(point, 2.6, &format!("fill=\"{colour}\""));
    }
}
