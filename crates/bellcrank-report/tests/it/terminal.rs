use bellcrank_report::{Style, terminal_summary};

use crate::sample::{lift, stewart};

const PLAIN: Style = Style { color: false, width: 100 };

#[test]
fn a_study_at_a_glance() {
    let mut run = lift::run();
    run.studies.remove(0);
    let expected = "\
lift: Assist manipulator: parallel six-bar lift

massless  inverse-dynamics, 601 rows, joint.B.position -30 … 30 deg, 612 µs
  drive and stroke             min       at        max       at       range
  drive.slide.force      4680.32 N   30 deg  4844.52 N  -30 deg    164.20 N
  joint.B.position         -30 deg  -30 deg     30 deg   30 deg      60 deg
  joint.slide.position  -79.648 mm  -30 deg  80.283 mm   30 deg  159.931 mm
  reaction             max force       at  max moment  at
  B         revolute   4855.37 N  -30 deg           –
  O         revolute   4844.52 N  -30 deg           –
  N         revolute   4844.52 N  -30 deg           –
  E         revolute   1105.82 N   30 deg           –
  A         revolute    461.88 N  -30 deg           –
  H         revolute    461.88 N  -30 deg           –
  slide     prismatic        0 N  -30 deg           –
  loop closure 3e-16 m ok · power balance 8e-15 ok
";
    assert_eq!(terminal_summary(&run, &PLAIN), expected);
}

#[test]
fn trouble_is_told() {
    let text = terminal_summary(&lift::troubled(), &Style { color: false, width: 60 });
    for part in [
        "  warning: body `link2` has no mass",
        "  stopped: at `joint.B.position` = -8.1 deg",
        "    try: end the sweep at -8 deg",
        "revolute, fx not unique",
        "loop closure 0.0001 m TOO LARGE",
    ] {
        assert!(text.contains(part), "{part} in\n{text}");
    }
    let sentences = text.lines().filter(|line| line.contains("stopped:") || line.contains("warning:"));
    assert!(sentences.into_iter().all(|line| line.chars().count() <= 60));
}

#[test]
fn colour_comes_only_when_asked_for() {
    let run = lift::run();
    assert!(!terminal_summary(&run, &PLAIN).contains('\u{1b}'));
    assert!(terminal_summary(&run, &Style { color: true, width: 100 }).contains("\u{1b}[32mok\u{1b}[0m"));
}

#[test]
fn names_do_not_command_the_terminal() {
    let mut run = lift::run();
    run.title = "\u{1b}[2Jgone\r\n".to_owned();
    run.studies[0].name = "a\u{7}b".to_owned();
    let text = terminal_summary(&run, &PLAIN);
    assert!(!text.contains(['\u{1b}', '\r', '\u{7}']));
}

#[test]
fn without_rows_there_is_no_table() {
    let mut run = stewart::run();
    for column in &mut run.studies[0].table.columns {
        column.values.clear();
    }
    let text = terminal_summary(&run, &PLAIN);
    assert_eq!(text, "stewart: Stewart platform\n\nwave  inverse-dynamics, 0 rows, 4 ms\n");
}

#[test]
fn a_single_position_is_told_in_values() {
    let mut run = lift::run();
    run.studies.remove(0);
    let study = &mut run.studies[0];
    study.axis.clear();
    study.table.columns.iter_mut().for_each(|column| column.values.truncate(1));
    let summary = terminal_summary(&run, &PLAIN);
    assert!(
        summary.contains("  drive or position            value\n  drive.slide.force        4844.52 N\n"),
        "{summary}"
    );
    assert!(!summary.contains("row 0"), "{summary}");
    let page = bellcrank_report::render_html(&run);
    assert!(page.contains("<th scope=\"col\">Drive or position</th>"));
    for absent in ["data-curves=\"0\"", "<h3>Force hodographs", "at </td>"] {
        assert!(!page.contains(absent), "{absent}");
    }
}
