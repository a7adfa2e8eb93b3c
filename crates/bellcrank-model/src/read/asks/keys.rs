//! The keys of one asking study, before those of the study it is like are put beneath them.

use bellcrank_doc::{Constraint, Diagnostic, Distribution, Expression, Response, Spanned, Value, ValueKind};

use super::designs::{ReadLevels, read_vary};
use super::given::{Given, names as parameter_names, one_in_brackets, told, whole};
use super::objective::{Objective, read_objective};
use super::sizing::SizingKeys;
use super::table::{DesignTable, read_designs};
use super::tolerance::{read_limits, read_tolerances};
use crate::design::{Method, NamedResponse, Scattered, Variable};
use crate::keyed::Keyed;
use crate::names;
use crate::read::study_keys::Referred;
use crate::schema::{ASKING, DIRECTIONS, VARIABLE};

/// What the keys of an asking study say.
#[derive(Clone, Debug, Default)]
pub(crate) struct AskKeys {
    pub(super) of: Given<Spanned<String>>,
    pub(super) response: Given<Response>,
    pub(super) parameters: Given<Vec<usize>>,
    pub(super) points: Given<Spanned<u64>>,
    pub(super) objective: Given<Objective>,
    pub(super) variables: Given<Vec<Variable>>,
    pub(super) subject_to: Given<Vec<Constraint>>,
    pub(super) starts: Given<Spanned<u64>>,
    pub(super) seed: Given<Spanned<u64>>,
    pub(super) tolerance: Given<Expression>,
    pub(super) iterations: Given<Spanned<u64>>,
    pub(super) responses: Given<Vec<Named>>,
    pub(super) vary: Given<Spanned<Vec<ReadLevels>>>,
    pub(super) method: Given<Spanned<Method>>,
    pub(super) table: Given<Spanned<DesignTable>>,
    pub(super) samples: Given<Spanned<u64>>,
    pub(super) pareto: Given<Sides>,
    pub(super) tolerances: Given<Vec<Scattered>>,
    pub(super) limits: Given<[Option<Expression>; 2]>,
    pub(super) sobol: Given<bool>,
    pub(super) distribution: Given<Distribution>,
    pub(super) sizing: Box<SizingKeys>,
}

/// A response with the name of its column and where that stands.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    pub(super) response: NamedResponse,
    pub(super) name: bellcrank_doc::Span,
}

/// Names of responses, and whether each is to be small; where all of it stands.
pub(super) type Sides = Spanned<Vec<(Spanned<String>, bool)>>;

impl AskKeys {
    /// The study that is asked, as named.
    pub(crate) fn of(&self) -> Option<Spanned<&str>> {
        self.of.is().map(|of| Spanned { value: of.value.as_str(), span: of.span })
    }

    /// Reads the keys of a study of known kind; `beneath` are those of the study it is like.
    pub(crate) fn read(keyed: &Keyed<'_>, of: Referred<'_>, beneath: &AskKeys) -> AskKeys {
        if !keyed.kind().is_some_and(|kind| ASKING.contains(&kind)) {
            return AskKeys::default();
        }
        let common = AskKeys { of: read_of(keyed, beneath), seed: whole(keyed, "seed"), ..AskKeys::default() };
        match keyed.kind() {
            Some("sensitivity") => AskKeys {
                response: read_response(keyed, of, beneath),
                parameters: Given::key(keyed, "parameters", |value| {
                    let told = parameter_names(of.part, value, &keyed.named("parameters"))?;
                    Some(told.iter().map(|one| one.parameter).collect())
                }),
                points: whole(keyed, "points"),
                ..common
            },
            Some("optimize") => AskKeys {
                objective: read_objective(keyed, of, beneath),
                variables: Given::needed(keyed, "variables", &beneath.variables, |value| {
                    read_variables(value, keyed, of)
                }),
                subject_to: Given::key(keyed, "subject_to", |value| read_constraints(value, keyed, of)),
                starts: whole(keyed, "starts"),
                tolerance: Given::key(keyed, "tolerance", |_| keyed.quantity("tolerance")),
                iterations: whole(keyed, "iterations"),
                ..common
            },
            Some("sweep") => AskKeys::read_designs(keyed, of, beneath, common),
            Some("tolerance") => AskKeys {
                response: read_response(keyed, of, beneath),
                tolerances: Given::key(keyed, "tolerances", |value| read_tolerances(value, keyed, of)),
                limits: Given::key(keyed, "limits", |value| read_limits(value, keyed, of)),
                samples: whole(keyed, "samples"),
                sobol: Given::key(keyed, "sobol", |_| keyed.boolean("sobol").map(|truth| truth.value)),
                distribution: Given::key(keyed, "distribution", |_| {
                    keyed.choice("distribution").and_then(|name| Distribution::named(name.value))
                }),
                ..common
            },
            Some("sizing") => AskKeys { sizing: Box::new(SizingKeys::read(keyed, of)), ..common },
            _ => AskKeys::default(),
        }
    }

    fn read_designs(keyed: &Keyed<'_>, of: Referred<'_>, beneath: &AskKeys, common: AskKeys) -> AskKeys {
        let table = Given::key(keyed, "table", |_| read_designs(keyed, of));
        let method = Given::key(keyed, "method", |_| {
            keyed.choice("method").map(|word| Spanned { value: method(word.value), span: word.span })
        });
        let designs = [&table, &beneath.table].iter().all(|table| table.is_no());
        let from_table = matches!(method.is().or(beneath.method.is()), Some(Spanned { value: Method::Table, .. }));
        if designs && from_table {
            keyed.needed("table");
        } else if designs && beneath.vary.is_no() {
            keyed.needed("vary");
        }
        AskKeys {
            responses: Given::needed(keyed, "responses", &beneath.responses, |value| read_responses(value, keyed, of)),
            vary: Given::key(keyed, "vary", |value| {
                read_vary(value, keyed, of).map(|vary| Spanned { value: vary, span: value.span })
            }),
            method,
            table,
            samples: whole(keyed, "samples"),
            pareto: Given::key(keyed, "pareto", |value| read_pareto(value, keyed)),
            ..common
        }
    }

    /// These keys, and those of `beneath` where there are none. How designs lie is one choice: a table here hides
    /// ranges beneath, and the other way round; another method hides what does not go with it.
    pub(crate) fn over(self, beneath: AskKeys) -> AskKeys {
        let own_method = self.method.is().map(|method| method.value);
        let sampled = |method| matches!(method, Some(Method::LatinHypercube | Method::Sobol));
        let no_table = !self.vary.is_no() || own_method.is_some_and(|method| method != Method::Table);
        let no_ranges = !self.table.is_no() || own_method == Some(Method::Table);
        let no_method = !self.table.is_no() || !self.vary.is_no() && is_table(&beneath.method);
        let no_samples = no_ranges || own_method == Some(Method::Grid);
        let levels = |beneath: Given<Spanned<Vec<ReadLevels>>>| match beneath {
            Given::Is(mut vary) if sampled(own_method) => {
                vary.value.iter_mut().for_each(ReadLevels::without_points);
                Given::Is(vary)
            }
            other => other,
        };
        AskKeys {
            of: self.of.or(beneath.of),
            response: self.response.or(beneath.response),
            parameters: self.parameters.or(beneath.parameters),
            points: self.points.or(beneath.points),
            objective: self.objective.or(beneath.objective),
            variables: self.variables.or(beneath.variables),
            subject_to: self.subject_to.or(beneath.subject_to),
            starts: self.starts.or(beneath.starts),
            seed: self.seed.or(beneath.seed),
            tolerance: self.tolerance.or(beneath.tolerance),
            iterations: self.iterations.or(beneath.iterations),
            responses: self.responses.or(beneath.responses),
            vary: self.vary.or(unless(no_ranges, levels(beneath.vary))),
            method: self.method.or(unless(no_method, beneath.method)),
            table: self.table.or(unless(no_table, beneath.table)),
            samples: self.samples.or(unless(no_samples, beneath.samples)),
            pareto: self.pareto.or(beneath.pareto),
            tolerances: self.tolerances.or(beneath.tolerances),
            limits: self.limits.or(beneath.limits),
            sobol: self.sobol.or(beneath.sobol),
            distribution: self.distribution.or(beneath.distribution),
            sizing: Box::new(self.sizing.over(*beneath.sizing)),
        }
    }
}

fn unless<T>(hidden: bool, given: Given<T>) -> Given<T> {
    if hidden { Given::No } else { given }
}

fn is_table(method: &Given<Spanned<Method>>) -> bool {
    method.is().is_some_and(|method| method.value == Method::Table)
}

fn method(word: &str) -> Method {
    match word {
        "lhs" => Method::LatinHypercube,
        "sobol" => Method::Sobol,
        "table" => Method::Table,
        _ => Method::Grid,
    }
}

fn read_of(keyed: &Keyed<'_>, beneath: &AskKeys) -> Given<Spanned<String>> {
    Given::needed(keyed, "of", &beneath.of, |_| {
        keyed.text("of").map(|name| Spanned { value: name.value.to_owned(), span: name.span })
    })
}

fn read_response(keyed: &Keyed<'_>, of: Referred<'_>, beneath: &AskKeys) -> Given<Response> {
    Given::needed(keyed, "response", &beneath.response, |value| {
        if matches!(value.kind, ValueKind::List(_)) {
            let message = format!("{} is one response, found a list", keyed.named("response"));
            let hint = "a study for each, with `like` to share the rest";
            keyed.report(Diagnostic::error("wrong-type", value.span, message).hint(hint));
            return None;
        }
        of.response(value, &keyed.named("response"))
    })
}

/// Parameters with bounds of their own, as far as given.
fn read_variables(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<Variable>> {
    let what = keyed.named("variables");
    let told = told(of.part, value, &what)?;
    let one = |one: super::given::Told<'_>| {
        let mut variable = Variable { parameter: one.parameter, span: one.span, min: None, max: None };
        let Some(value) = one.value else { return Some(variable) };
        let fields = of.part.reader.fields(value, &format!("`{}` in {what}", one.name))?;
        let bounds = Keyed::new(fields, &VARIABLE, of.part.space());
        let dimension = of.part.reader.parameters().all().get(one.parameter)?.dimension;
        let bound = |key| Given::key(&bounds, key, |_| bounds.free(key, dimension)).optional();
        let (min, max) = (bound("min"), bound("max"));
        bounds.finish();
        (variable.min, variable.max) = (min?, max?);
        Some(variable)
    };
    Some(told.into_iter().filter_map(one).collect())
}

fn read_constraints(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<Constraint>> {
    let what = keyed.named("subject_to");
    let list = match value.as_str() {
        Some(_) => std::slice::from_ref(value),
        None => of.part.reader.list(value, &what)?,
    };
    Some(list.iter().filter_map(|one| of.constraint(one, &what)).collect())
}

/// A list of responses, each named by its text, or a table of named ones.
fn read_responses(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<Named>> {
    let what = keyed.named("responses");
    let read: Option<Vec<Named>> = match value.as_table() {
        Some(table) => all(table.iter().map(|entry| {
            let fault = names::fault(entry, "response");
            let faulty = fault.is_some();
            fault.into_iter().for_each(|fault| keyed.report(fault));
            let response = of.response(&entry.value, &format!("`{}` in {what}", entry.key))?;
            let named = NamedResponse { name: entry.key.clone(), response };
            (!faulty).then_some(Named { response: named, name: entry.key_span })
        })),
        None => all(of.part.reader.list(one_in_brackets(of.part, value, &what)?, &what)?.iter().map(|one| {
            let response = of.response(one, &what)?;
            let name = response.written().trim().to_owned();
            Some(Named { response: NamedResponse { name, response }, name: one.span })
        })),
    };
    let read = read?;
    if read.is_empty() {
        let message = format!("{what} names no response");
        let hint = "write `responses = [\"max(abs(drive.JOINT.force))\"]`";
        keyed.report(Diagnostic::error("wrong-length", value.span, message).hint(hint));
        return None;
    }
    let errors = of.part.reader.errors();
    for (i, one) in read.iter().enumerate() {
        let before = read[..i].iter().find(|before| before.response.name == one.response.name);
        if let Some(first) = before {
            let message = format!("{what} has two columns `{}`", one.response.name);
            let report = Diagnostic::error("duplicate-name", one.name, message).also(first.name, "first here");
            keyed.report(report.hint("one is enough; two that differ have names: `{ peak = \"...\", low = \"...\" }`"));
        }
    }
    (of.part.reader.errors() == errors).then_some(read)
}

/// Names of responses, each to be small (else large); the names are looked up when they are known.
fn read_pareto(value: &Value, keyed: &Keyed<'_>) -> Option<Sides> {
    let what = keyed.named("pareto");
    if matches!(value.kind, ValueKind::List(_) | ValueKind::String(_)) {
        let message = format!("{what} needs a table, found {}", value.describe());
        let hint = "which way each is good: `pareto = { peak = \"min\", stroke = \"max\" }`";
        keyed.report(Diagnostic::error("wrong-type", value.span, message).hint(hint));
        return None;
    }
    let fields = keyed.reader().fields(value, &what)?;
    let sides = all(fields.table().iter().map(|entry| {
        let side = keyed.reader().one_of(&entry.value, &format!("`{}` in {what}", entry.key), DIRECTIONS)?;
        Some((Spanned { value: entry.key.clone(), span: entry.key_span }, side.value == "min"))
    }))?;
    Some(Spanned { value: sides, span: value.span })
}

/// All of them, or nothing when one is wrong; each is read.
pub(super) fn all<T>(read: impl Iterator<Item = Option<T>>) -> Option<Vec<T>> {
    let read: Vec<Option<T>> = read.collect();
    read.into_iter().collect()
}
