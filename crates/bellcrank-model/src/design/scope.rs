//! Parameters of the main file and of each subsystem, and values over them.

use bellcrank_doc::{Expression, ParameterSet, Span};

/// A file of the model, by its place in [`super::Design::scopes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ScopeId(pub(crate) usize);

/// The parameters of one file.
#[derive(Debug)]
pub(crate) struct Scope {
    /// `lift.` for the subsystem `lift`; empty for the main file.
    pub(crate) prefix: String,
    pub(crate) parameters: ParameterSet,
    /// The file that includes this one, and what it sets: parameter here, expression there.
    pub(crate) parent: Option<(ScopeId, Vec<(usize, Expression)>)>,
}

/// An expression and the file whose parameters it uses.
#[derive(Clone, Debug)]
pub(crate) struct Quantity {
    pub(crate) scope: ScopeId,
    pub(crate) expression: Expression,
}

impl Quantity {
    /// SI value.
    pub(crate) fn eval(&self, values: &Values) -> f64 {
        self.expression.eval(values.of(self.scope), &[])
    }

    pub(crate) fn span(&self) -> Span {
        self.expression.span()
    }
}

/// SI values of all parameters, by scope.
#[derive(Clone, Debug)]
pub(crate) struct Values(Vec<Vec<f64>>);

impl Values {
    /// Values with the main file's parameters as in `main`; those of subsystems follow.
    pub(crate) fn new(scopes: &[Scope], main: &ParameterSet) -> Values {
        let mut all: Vec<Vec<f64>> = Vec::with_capacity(scopes.len());
        for scope in scopes {
            let values = match &scope.parent {
                None => main.values().to_vec(),
                Some((parent, given)) => {
                    let above = all.get(parent.0).map_or(&[][..], Vec::as_slice);
                    let fixed: Vec<(usize, f64)> = given.iter().map(|(i, e)| (*i, e.eval(above, &[]))).collect();
                    scope.parameters.evaluate(&fixed)
                }
            };
            all.push(values);
        }
        Values(all)
    }

    pub(crate) fn of(&self, scope: ScopeId) -> &[f64] {
        self.0.get(scope.0).map_or(&[], Vec::as_slice)
    }
}
