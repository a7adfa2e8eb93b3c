//! Parameters of the main file and of each subsystem, and values over them.

use bellcrank_doc::{Expression, ParameterSet, Span};

use crate::scalar::Scalar;

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
    pub(crate) fn eval<T: Scalar>(&self, values: &Values<T>) -> T {
        T::of(self.expression.eval(values.of(self.scope), &[]))
    }

    pub(crate) fn span(&self) -> Span {
        self.expression.span()
    }
}

/// SI values of all parameters, by scope.
#[derive(Clone, Debug)]
pub(crate) struct Values<T: Scalar = f64> {
    scopes: Vec<Vec<T::Number>>,
    /// What the scope at work is given from outside; kept for its memory.
    given: Vec<(usize, T::Number)>,
}

impl<T: Scalar> Values<T> {
    /// Values with the main file's parameters as in `main`; those of subsystems follow.
    pub(crate) fn new(scopes: &[Scope], main: &ParameterSet) -> Values<T> {
        Values::with(scopes, main, &[])
    }

    /// The values with those of `fixed` (parameters of the main file) in place of their definitions, and all that
    /// depends on them. Seeded numbers in `fixed` give derivatives everywhere.
    pub(crate) fn with(scopes: &[Scope], main: &ParameterSet, fixed: &[(usize, T)]) -> Values<T> {
        let mut values = Values { scopes: Vec::new(), given: Vec::new() };
        values.update(scopes, main, fixed);
        values
    }

    /// As [`Values::with`], in the memory of the values before.
    pub(crate) fn update(&mut self, scopes: &[Scope], main: &ParameterSet, fixed: &[(usize, T)]) {
        self.scopes.resize_with(scopes.len(), Vec::new);
        for (index, scope) in scopes.iter().enumerate() {
            self.given.clear();
            let (above, own) = self.scopes.split_at_mut(index);
            let parameters = match &scope.parent {
                None => {
                    self.given.extend(fixed.iter().map(|&(i, value)| (i, value.number())));
                    main
                }
                Some((parent, set)) => {
                    let above = above.get(parent.0).map_or(&[][..], Vec::as_slice);
                    self.given.extend(set.iter().map(|(i, expression)| (*i, expression.eval(above, &[]))));
                    &scope.parameters
                }
            };
            parameters.evaluate_into(&self.given, &mut own[0]);
        }
    }

    pub(crate) fn of(&self, scope: ScopeId) -> &[T::Number] {
        self.scopes.get(scope.0).map_or(&[], Vec::as_slice)
    }
}
