//! Where the numbers come from, and the place to sign.

use bellcrank_results::RunResult;

use super::Escaped;
use crate::number;

pub(crate) fn section(run: &RunResult) -> String {
    let from = &run.provenance;
    let seconds: f64 = run.studies.iter().map(|study| study.seconds).sum();
    let rows: String = [
        ("Program", format!("bellcrank {}", from.version)),
        ("Model file", from.file.clone()),
        ("Hash of the model text", from.hash.clone()),
        ("Date", from.date.clone()),
        ("Solution time, all studies", number::duration(seconds)),
    ]
    .iter()
    .map(|(label, text)| format!("<tr><th scope=\"row\">{label}</th><td class=\"wrap\">{}</td></tr>\n", Escaped(text)))
    .collect();
    format!(
        "<section id=\"provenance\">\n<h2>Provenance</h2>\n<table class=\"facts\">\n{rows}</table>\n\
         <p class=\"hint\">All numbers were computed in SI units and double precision. The series \
         and summaries beside this file hold every digit. Curves are drawn with uPlot (MIT \
         licence, © Leon Sorokin).</p>\n</section>\n{SIGNATURE}"
    )
}

const SIGNATURE: &str = "<section id=\"signature\" class=\"signature\">\n<h2>Signature</h2>\n\
    <div class=\"sign\"><span>Prepared by</span><span>Date</span><span>Signature</span></div>\n\
    <div class=\"sign\"><span>Checked by</span><span>Date</span><span>Signature</span></div>\n\
    </section>\n";
