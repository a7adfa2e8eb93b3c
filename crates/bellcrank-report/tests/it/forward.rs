//! Studies in time from forces, and modes: page, files and terminal text.

use bellcrank_report::{Exports, Style, render_html, terminal_summary, write_run};

use crate::markup::{assert_balanced, between};
use crate::sample::forward;

const PLAIN: Style = Style { color: false, width: 100 };

#[test]
fn events_and_modes_at_a_glance() {
    let expected = "\
lift: Assist manipulator: parallel six-bar lift

fall  dynamics, 7 rows, time 0 … 0.6 s, 0 µs
  Ended at 0.6 s, where `time > 0.6 s` became true.
  12 events: 10 impacts, 1 contact and 1 condition.
          at  event   of     where
       0.2 s  impact  floor  lower limit of slide  speed 2000 mm/s, impulse 3 N·s
      0.35 s  impact  floor  lower limit of slide  speed 1000 mm/s, impulse 1.5 N·s
";
    let text = terminal_summary(&forward::run(), &PLAIN);
    assert!(text.starts_with(expected), "{text}");
    let rest = [
        "  and 4 more events in the report",
        "The slowest oscillation about equilibrium has 0.700327 Hz, damping ratio 0.01136.",
        "3 of 4 modes are listed of 2 degrees of freedom: 2 oscillate and 1 decays.",
        "2      1.44831 Hz        0  oscillates  hinge 1 rad, wrist 0.361 rad at 124 deg",
    ];
    for part in rest {
        assert!(text.contains(part), "{part} in\n{text}");
    }
}

#[test]
fn the_page_tells_them() {
    let page = render_html(&forward::run());
    assert_balanced(&page);
    let fall = between(&page, "id=\"study-fall\"", "</section>");
    assert_eq!(fall.matches("<td>impact</td>").count(), 10);
    assert!(fall.contains("<td>lower limit of slide</td>") && fall.contains("Ended at 0.6\u{a0}s"), "{fall}");
    let ring = between(&page, "id=\"study-ring\"", "</section>");
    assert!(ring.contains("−0.05 ± 4.4 i") && ring.contains("<td>decays</td>"), "{ring}");
}

#[test]
fn the_cycle_chart_has_a_lane_for_each_axis() {
    let run = forward::run();
    let page = render_html(&run);
    let fall = between(&page, "id=\"study-fall\"", "</section>");
    let chart = between(fall, "data-cycle=\"0\"", "</figure>");
    // The frame begins where that of the other charts does, and ends with the rows.
    assert!(chart.contains("data-x0=\"78\" data-x1=\"702\" data-t0=\"0\" data-t1=\"0.6\""), "{chart}");
    for text in [">lift.<", ">slide<", ">spindle<", "+80 mm, poly5", ">lift&lt;up&gt;<", "from 0.5 rad", "holds 80 mm"]
    {
        assert!(chart.contains(text), "{text} in {chart}");
    }
    // Three bars beside the white ground, the last two to the end of the study; a hold is a line.
    assert_eq!(chart.matches("<rect").count(), 4);
    assert_eq!(chart.matches("stroke-dasharray").count(), 1);
    assert!(fall.contains("<summary>Moves in the order of time</summary>") && fall.contains("<td>velocity</td>"));
    assert!(!between(&page, "id=\"study-ring\"", "</section>").contains("Programme"));
}

#[test]
fn names_are_no_markup() {
    let mut run = forward::run();
    let evil = "</script><img src=x onerror=alert(1)>";
    for event in &mut run.studies[0].events.as_mut().expect("events").list {
        event.name = evil.to_owned();
        event.joint = evil.to_owned();
    }
    run.studies[0].events.as_mut().expect("events").ended.as_mut().expect("an end").by = evil.to_owned();
    let page = render_html(&run);
    assert_balanced(&page);
    assert!(!page.contains("<img"));
}

#[test]
fn events_have_a_file() {
    let dir = std::env::temp_dir().join(format!("bellcrank-events-{}", std::process::id()));
    write_run(&forward::run(), &dir, Exports::default()).expect("files");
    let read = |name: &str| std::fs::read_to_string(dir.join(name)).expect("a file");
    let (events, modes) = (read("fall/events.csv"), read("ring/modes.csv"));
    std::fs::remove_dir_all(&dir).expect("a folder to remove");
    let mut lines = events.lines();
    assert_eq!(lines.next(), Some("time [s],event,name,joint,side,speed,speed unit,impulse,impulse unit"));
    assert_eq!(lines.next(), Some("0.2,impact,floor,slide,lower,2000,mm/s,3,N*s"));
    assert_eq!(lines.last(), Some("0.6,condition,time > 0.6 s,,,,,,"));
    assert!(modes.starts_with("mode,frequency [Hz],damping,re [1/s],im [1/s],what,hinge [rad],hinge phase [deg],"));
}
