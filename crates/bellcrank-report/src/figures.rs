//! Which figures a study gets.

mod cycle;
mod designs;
mod optimization;
mod sensitivity;
mod tolerance;

use bellcrank_results::{Column, Findings, StudyResult, file_stems};

pub(crate) use cycle::PROGRAMME;

use crate::findings::{drives, family, finding, owner, strongest};
use crate::plot::{Axis, Chart, Curve, Hodograph};

/// A figure of a study, ready to be written.
#[derive(Clone, Debug)]
pub struct FigureFile {
    /// File name without folder and `.svg`.
    pub stem: String,
    /// What it shows.
    pub title: String,
    /// Joint whose force vector it shows, for hodographs.
    pub joint: Option<String>,
    /// The components drawn across and up, as `fx`, for hodographs.
    pub components: Option<(String, String)>,
    /// Which finding it draws, as `tornado`: the report shows it where that is told.
    pub finding: Option<&'static str>,
    /// The picture: an SVG document.
    pub svg: String,
}

impl FigureFile {
    /// A picture of something a study over another study found.
    fn of_finding(finding: &'static str, stem: String, title: String, svg: String) -> Self {
        Self { stem, title, joint: None, components: None, finding: Some(finding), svg }
    }
}

/// Lines in one chart: more cannot be told apart.
const MOST_CURVES: usize = 8;
/// Joints that get a hodograph of their own, strongest first.
const MOST_HODOGRAPHS: usize = 24;

/// The figures of a study: what it found, motion of the joints, drive forces, reactions, force
/// hodographs.
///
/// Empty for a study that has no findings and no rows, or a single position: a picture of one dot
/// shows nothing.
pub fn figures(study: &StudyResult) -> Vec<FigureFile> {
    let mut figures = study.findings.as_ref().map_or_else(Vec::new, |findings| of_findings(study, findings));
    // A choice of a drive has drawn all its rows already.
    let drawn = matches!(study.findings, Some(Findings::Sizing(_) | Findings::Stress(_)));
    if study.table.rows() > 1 && !drawn {
        figures.extend(cycle::figure(study));
        figures.extend(charts(study));
        figures.extend(hodographs(study));
    }
    let stems = file_stems(figures.iter().map(|figure| figure.stem.as_str()));
    for (figure, stem) in figures.iter_mut().zip(stems) {
        figure.stem = stem;
    }
    figures
}

fn of_findings(study: &StudyResult, findings: &Findings) -> Vec<FigureFile> {
    match findings {
        Findings::Sensitivity(found) => sensitivity::figures(found),
        Findings::Optimization(found) => optimization::figures(found),
        Findings::Designs(found) => designs::figures(found),
        Findings::Tolerance(found) => tolerance::figures(found),
        Findings::Modes(_) | Findings::BodyModes(_) => Vec::new(),
        Findings::Sizing(_) | Findings::Stress(_) => over_the_axis(study),
    }
}

/// Everything a sizing study has over its stroke, one chart a unit: working pressure, force, speed.
fn over_the_axis(study: &StudyResult) -> Vec<FigureFile> {
    if study.table.rows() < 2 {
        return Vec::new();
    }
    let all: Vec<&Column> = study.table.columns.iter().filter(|c| !study.axis.contains(&c.name)).collect();
    let unit = |column: &Column| column.unit.symbol.clone();
    let mut units: Vec<String> = all.iter().copied().map(unit).collect();
    let mut seen = Vec::new();
    units.retain(|symbol| {
        !seen.contains(symbol) && {
            seen.push(symbol.clone());
            true
        }
    });
    let of_unit = |symbol: &String| {
        let same: Vec<&Column> = all.iter().copied().filter(|column| column.unit.symbol == *symbol).collect();
        // Columns of one unit go under the name of the first: a pressure beside its supply.
        let title = same.first().map_or("", |column| column.name.as_str());
        FigureFile { finding: Some("stroke"), ..chart(study, format!("stroke-{symbol}"), title, &same) }
    };
    units.iter().map(of_unit).collect()
}

fn charts(study: &StudyResult) -> Vec<FigureFile> {
    let motions = ["position", "velocity", "acceleration"]
        .map(|quantity| (quantity, format!("Joint {quantity}"), joints_first_driven(study, quantity)));
    let drives = [("force", "Drive force"), ("power", "Drive power")]
        .map(|(quantity, title)| (quantity, title.to_owned(), columns(study, "drive", quantity)))
        .map(|(quantity, title, columns)| (stem_of_drive(quantity), title, columns));
    let magnitudes = strongest(study).into_iter().map(|(_, found)| found.column).collect();
    let reactions = ("reaction", "Joint reaction, force magnitude".to_owned(), magnitudes);
    let groups = motions.into_iter().chain(drives).chain([reactions]);
    groups.flat_map(|(stem, title, columns)| by_unit(study, stem, &title, &columns)).collect()
}

fn stem_of_drive(quantity: &str) -> &'static str {
    if quantity == "force" { "drive-force" } else { "drive-power" }
}

fn columns<'a>(study: &'a StudyResult, group: &str, quantity: &str) -> Vec<&'a Column> {
    family(study, group, quantity).into_iter().map(|(_, finding)| finding.column).collect()
}

/// Driven joints come first, as the chart may not hold all.
fn joints_first_driven<'a>(study: &'a StudyResult, quantity: &str) -> Vec<&'a Column> {
    let driven: Vec<&str> = drives(study).into_iter().map(|(joint, _)| joint).collect();
    let mut found = columns(study, "joint", quantity);
    found.sort_by_key(|c| owner(&c.name, "joint", quantity).is_none_or(|j| !driven.contains(&j)));
    found
}

/// One chart for each unit among the columns.
fn by_unit(study: &StudyResult, stem: &str, title: &str, all: &[&Column]) -> Vec<FigureFile> {
    let mut units: Vec<&str> = Vec::new();
    for column in all {
        if !units.contains(&column.unit.symbol.as_str()) {
            units.push(&column.unit.symbol);
        }
    }
    let chart = |unit: &&str| {
        let same: Vec<&Column> = all.iter().copied().filter(|c| c.unit.symbol == **unit).collect();
        let stem = if units.len() == 1 { stem.to_owned() } else { format!("{stem}-{unit}") };
        chart(study, stem, title, &same)
    };
    units.iter().map(chart).collect()
}

fn chart(study: &StudyResult, stem: String, title: &str, columns: &[&Column]) -> FigureFile {
    let unit = columns.first().map_or("", |column| column.unit.symbol.as_str());
    let (x, across) = across(study);
    let drawn = &columns[..columns.len().min(MOST_CURVES)];
    let curves = drawn.iter().copied().map(curve).collect();
    let y = Axis { name: title.to_owned(), unit: unit.to_owned() };
    let title = match columns.len() - drawn.len() {
        0 => title.to_owned(),
        _ => format!("{title} ({} of {} signals)", drawn.len(), columns.len()),
    };
    let svg = Chart { title: title.clone(), x, y, across, curves }.svg();
    FigureFile { stem, title, joint: None, components: None, finding: None, svg }
}

fn curve(column: &Column) -> Curve<'_> {
    let y = column.values.iter().map(|si| column.unit.show(*si)).collect();
    Curve { name: &column.name, y }
}

/// The axis a study is drawn over, and its display numbers: row numbers where it has none.
fn across(study: &StudyResult) -> (Axis, Vec<f64>) {
    let axis = study.axis.first().and_then(|name| study.table.column(name));
    match axis {
        Some(column) => {
            let axis = Axis { name: column.name.clone(), unit: column.unit.symbol.clone() };
            (axis, column.values.iter().map(|si| column.unit.show(*si)).collect())
        }
        None => {
            let axis = Axis { name: "row".to_owned(), unit: String::new() };
            (axis, (0..study.table.rows()).map(|row| row as f64).collect())
        }
    }
}

fn hodographs(study: &StudyResult) -> Vec<FigureFile> {
    let joints = strongest(study).into_iter().map(|(joint, _)| joint).take(MOST_HODOGRAPHS);
    let planes = |joint| [("fx", "fy"), ("fx", "fz")].map(|plane| hodograph(study, joint, plane));
    joints.flat_map(planes).flatten().collect()
}

/// Nothing where the joint lacks one of the components, or carries none of both.
fn hodograph(study: &StudyResult, joint: &str, plane: (&str, &str)) -> Option<FigureFile> {
    let column = |component| finding(study, &format!("joint.{joint}.reaction.{component}"));
    let (across, up) = (column(plane.0)?, column(plane.1)?);
    if across.peak() == 0.0 && up.peak() == 0.0 {
        return None;
    }
    let show = |c: &Column| c.values.iter().map(|si| c.unit.show(*si)).collect();
    let title = format!("{joint}: {} over {}", plane.1, plane.0);
    let unit = across.column.unit.symbol.as_str();
    let (x, y) = (show(across.column), show(up.column));
    let svg = Hodograph { title: title.clone(), axes: plane, unit, x, y }.svg();
    Some(FigureFile {
        stem: format!("hodograph-{joint}-{}", plane.1),
        title,
        joint: Some(joint.to_owned()),
        components: Some((plane.0.to_owned(), plane.1.to_owned())),
        finding: None,
        svg,
    })
}
