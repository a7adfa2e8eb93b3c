//! Where a response falls, and which tolerance is to blame.

use bellcrank_results::{HistogramBin, Tolerance, ToleranceInput};

use super::FigureFile;
use crate::number;
use crate::plot::{Axis, Bar, Bars, Histogram, Mark, MarkStyle};

const MOST_BARS: usize = 24;

pub(super) fn figures(found: &Tolerance) -> Vec<FigureFile> {
    vec![histogram(found), contributions(found)]
}

fn histogram(found: &Tolerance) -> FigureFile {
    let unit = &found.unit;
    let bins: &[HistogramBin] = found.monte_carlo.as_ref().map_or(&[], |run| &run.histogram);
    let samples: u64 = bins.iter().map(|bin| bin.count).sum();
    let share = |bin: &HistogramBin| (unit.show(bin.from), unit.show(bin.to), bin.count as f64 / samples.max(1) as f64);
    let title = "Scatter of the response".to_owned();
    let svg = Histogram {
        title: title.clone(),
        x: Axis { name: found.response.clone(), unit: unit.symbol.clone() },
        bins: bins.iter().map(share).collect(),
        normal: (unit.show(found.nominal), unit.show(found.linear_deviation)),
        marks: marks(found),
    }
    .svg();
    FigureFile::of_finding("histogram", "histogram".to_owned(), title, svg)
}

fn marks(found: &Tolerance) -> Vec<Mark> {
    let worst = found.worst_case_exact.unwrap_or(found.worst_case);
    let all = [
        ("worst case", Some(worst.0), MarkStyle::WorstCase),
        ("worst case", Some(worst.1), MarkStyle::WorstCase),
        ("lower limit", found.limits.0, MarkStyle::Limit),
        ("upper limit", found.limits.1, MarkStyle::Limit),
        ("nominal", Some(found.nominal), MarkStyle::Nominal),
    ];
    let mark = |(name, si, style): (&'static str, Option<f64>, MarkStyle)| {
        let at = found.unit.show(si.filter(|si| si.is_finite())?);
        Some(Mark { name, at, style })
    };
    all.into_iter().filter_map(mark).collect()
}

fn contributions(found: &Tolerance) -> FigureFile {
    let bars: Vec<Bar<'_>> = found.inputs.iter().take(MOST_BARS).map(bar).collect();
    let title = "Contributions of the tolerances".to_owned();
    let kinds = Some(["share of the variance", "share of the worst case"]);
    let svg = Bars { title: title.clone(), label: "share in %".to_owned(), kinds, bars }.svg();
    FigureFile::of_finding("contributions", "contributions".to_owned(), title, svg)
}

fn bar(input: &ToleranceInput) -> Bar<'_> {
    let worst = if input.worst_share.is_finite() { 100.0 * input.worst_share } else { 0.0 };
    Bar {
        name: &input.name,
        value: 100.0 * input.variance_share,
        text: number::part(input.variance_share),
        second: Some(worst),
    }
}
