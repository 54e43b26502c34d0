//! Expressions.

use super::scope::{Around, Found, Item, Scopes};
use super::statement::simple_name;
use super::value::{Callable, Value};
use super::{Lowering, constants};
use crate::ir::{Id, Number, Ratio, Relation};
use quote::{ToTokens, quote};
use std::rc::Rc;
use syn::{BinOp, Expr, ExprBinary, ExprIf, Lit, Member, Path, RangeLimits, UnOp};

const EXPRESSIONS: &str = "an energy is made of numbers, arrays, vectors, `+ - * /`, methods of `f64`, `if … else`, \
                           closures, `for` over ranges, and sums over iterators";

impl Lowering {
    pub(super) fn expr(&mut self, expr: &Expr) -> Value {
        self.evaluations += 1;
        if self.depth >= super::MAX_DEPTH {
            return self.refuse(expr, "this is nested too deeply: bind parts of it with `let`");
        }
        self.depth += 1;
        let value = self.evaluate(expr);
        self.depth -= 1;
        match value {
            Value::Real(id) => self.written(id, expr, || super::place(expr)),
            other => other,
        }
    }

    fn evaluate(&mut self, expr: &Expr) -> Value {
        match expr {
            Expr::Lit(lit) => self.literal(&lit.lit),
            Expr::Path(path) if path.qself.is_none() => self.path(&path.path),
            Expr::Paren(inner) => self.expr(&inner.expr),
            Expr::Group(inner) => self.expr(&inner.expr),
            Expr::Reference(inner) if inner.mutability.is_none() => self.expr(&inner.expr),
            Expr::Reference(inner) => self.refuse(inner, super::statement::THROUGH_REFERENCE),
            Expr::Unary(unary) => {
                let value = self.expr(&unary.expr);
                match (&unary.op, value) {
                    (UnOp::Deref(_), value) => value,
                    (_, Value::Poison) => Value::Poison,
                    (UnOp::Neg(_), Value::Integer(n)) => match n.checked_neg() {
                        Some(n) => Value::Integer(n),
                        None => self.refuse(unary, "this integer is out of bounds"),
                    },
                    (UnOp::Neg(_), Value::Opaque(path)) => Value::Opaque(quote!((-#path))),
                    (UnOp::Neg(_), Value::Vector(ids)) => {
                        Value::Vector(ids.iter().map(|id| self.graph.neg(*id)).collect())
                    }
                    (UnOp::Neg(_), value) => {
                        let id = self.real(&unary.expr, value);
                        Value::Real(self.graph.neg(id))
                    }
                    (UnOp::Not(_), Value::Truth(id)) => Value::Truth(self.graph.not(id)),
                    (_, other) => self.refuse(unary, format!("this operator does not apply to {}", other.kind())),
                }
            }
            Expr::Binary(binary) => match binary.op {
                BinOp::AddAssign(_) | BinOp::SubAssign(_) => self.accumulate(binary),
                BinOp::MulAssign(_) | BinOp::DivAssign(_) | BinOp::RemAssign(_) => self.assign(binary, &binary.left),
                BinOp::And(_) | BinOp::Or(_) => self.connective(binary),
                _ => self.chain(binary),
            },
            Expr::Assign(assign) => self.assign(assign, &assign.left),
            Expr::Block(block) => self.block(&block.block),
            Expr::If(branch) => self.branch(branch),
            Expr::ForLoop(for_loop) => self.for_loop(for_loop),
            Expr::Tuple(tuple) => Value::Tuple(tuple.elems.iter().map(|item| self.expr(item)).collect()),
            Expr::Array(array) => Value::list(array.elems.iter().map(|item| self.expr(item)).collect()),
            Expr::Repeat(repeat) => {
                let (value, length) = (self.expr(&repeat.expr), self.expr(&repeat.len));
                match self.integer(&repeat.len, length) {
                    Some(n @ 0..=10_000) => Value::list(vec![value; n as usize]),
                    Some(_) => self.refuse(&repeat.len, "this length is out of bounds"),
                    None => Value::Poison,
                }
            }
            Expr::Index(index) => {
                let (base, i) = (self.expr(&index.expr), self.expr(&index.index));
                self.index(&index.expr, &index.index, base, i)
            }
            Expr::Field(field) => self.field(field),
            Expr::Range(range) => self.range(range),
            Expr::Cast(cast) => self.cast(cast),
            Expr::Closure(closure) => {
                let callable = Callable {
                    name: None,
                    parameters: closure.inputs.iter().cloned().collect(),
                    body: (*closure.body).clone(),
                };
                Value::Callable(Rc::new(callable), Rc::new(self.scopes.clone()))
            }
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method_call(call),
            Expr::Macro(call) => self.refuse(call, other_macro(&call.mac)),
            Expr::Return(e) => self.refuse(e, "an energy has one exit: make the value the last expression"),
            Expr::While(e) => self.refuse(&e.while_token, "`while` has no derivative; use `for` over a range"),
            Expr::Loop(e) => self.refuse(&e.loop_token, "`loop` has no derivative; use `for` over a range"),
            Expr::Match(e) => self.refuse(&e.match_token, "`match` is not supported; use `if … else if … else`"),
            other => self.refuse(other, format!("this expression is not supported: {EXPRESSIONS}")),
        }
    }

    /// `a + b + c + …`, from the innermost operation on: a long sum is nested as deeply as it is long.
    fn chain(&mut self, outermost: &ExprBinary) -> Value {
        let mut operations = vec![outermost];
        let mut first = &*outermost.left;
        while let Expr::Binary(inner) = first
            && (is_arithmetic(&inner.op) || is_comparison(&inner.op))
        {
            operations.push(inner);
            first = &inner.left;
        }
        let factors = operations.iter().filter(|operation| matches!(operation.op, BinOp::Mul(_) | BinOp::Div(_)));
        if factors.count() > super::MAX_DEPTH {
            return self.refuse(outermost, format!("a product has {} factors at most", super::MAX_DEPTH));
        }
        // A long sum is not looked at from its beginning for every term.
        let (start, _) = super::place(first);
        let mut value = self.expr(first);
        for operation in operations.into_iter().rev() {
            let right = self.expr(&operation.right);
            value = self.arithmetic(operation, &operation.op, value, right);
            if let Value::Real(id) = value {
                value = self.written(id, operation, || (start, super::place(&operation.right).1));
            }
        }
        value
    }

    /// `a && b` and `a || b`: what is on the right exists only if the left does not decide.
    fn connective(&mut self, binary: &ExprBinary) -> Value {
        let left = self.expr(&binary.left);
        if let Value::Truth(id) = left
            && self.graph.as_truth(id) == Some(matches!(binary.op, BinOp::Or(_)))
        {
            return left;
        }
        let before = self.enter_branch();
        let right = self.expr(&binary.right);
        self.leave_branch(before);
        self.arithmetic(binary, &binary.op, left, right)
    }

    fn literal(&mut self, lit: &Lit) -> Value {
        let number = match lit {
            Lit::Float(x) => Number::decimal(x.base10_digits()),
            Lit::Int(n) if n.suffix().starts_with('f') => Number::decimal(n.base10_digits()),
            Lit::Int(n) => {
                return match n.base10_parse() {
                    Ok(n) => Value::Integer(n),
                    Err(_) => self.refuse(lit, "this integer is out of bounds"),
                };
            }
            Lit::Bool(b) => return Value::Truth(self.graph.truth(b.value)),
            _ => None,
        };
        match number {
            Some(number) if number.to_f64().is_finite() => Value::Real(self.graph.number(number)),
            _ => self.refuse(lit, "an energy is made of finite numbers"),
        }
    }

    fn path(&mut self, path: &Path) -> Value {
        let Some(last) = path.segments.last() else { return Value::Poison };
        let name = last.ident.to_string();
        if path.get_ident().is_some() {
            if self.scopes.is_accumulating(&name) {
                return self.refuse(
                    path,
                    format!(
                        "`{name}` is accumulated by this loop and has no value before its end: a loop may only add \
                         to it with `{name} += …`, in terms of other variables"
                    ),
                );
            }
            if let Some(value) = self.named(path, &name) {
                return value;
            }
        }
        if let Some(value) = constants::of_path(path) {
            return Value::Real(self.graph.number(Number::float(value)));
        }
        // A constant outside: the generated code can name it, and rustc knows its value.
        if name.chars().all(|c| c.is_uppercase() || c.is_numeric() || c == '_') {
            return Value::Opaque(path.to_token_stream());
        }
        self.refuse(
            path,
            format!("`{name}` is not known here: an energy sees its arguments, its own variables, and constants"),
        )
    }

    /// What a name is bound to.
    fn named(&mut self, syntax: &impl ToTokens, name: &str) -> Option<Value> {
        Some(match self.scopes.get(name)? {
            Found::Variable(value) | Found::Item(Item::Import(value), _) => value,
            Found::Item(Item::Function(callable), sees) => Value::Callable(callable, Rc::new(sees)),
            Found::Item(Item::Constant(constant), sees) => self.constant_item(syntax, &constant, sees),
        })
    }

    pub(super) fn arithmetic(&mut self, syntax: &impl ToTokens, op: &BinOp, left: Value, right: Value) -> Value {
        use Value::{Integer, Iterator, List, Opaque, Poison, Real, Truth, Tuple, Vector};
        match (left, right) {
            (Poison, _) | (_, Poison) => Poison,
            (Integer(a), Integer(b)) => self.integers(syntax, op, a, b),
            (Truth(a), Truth(b)) => match op {
                BinOp::And(_) => Truth(self.graph.and(a, b)),
                BinOp::Or(_) => Truth(self.graph.or(a, b)),
                _ => self.refuse(syntax, "conditions are combined with `&&`, `||` and `!`"),
            },
            (Vector(a), Vector(b)) if a.len() == b.len() => match op {
                BinOp::Add(_) => Vector(a.iter().zip(&b).map(|(a, b)| self.graph.add(*a, *b)).collect()),
                BinOp::Sub(_) => Vector(a.iter().zip(&b).map(|(a, b)| self.graph.sub(*a, *b)).collect()),
                _ => self.refuse(syntax, "two vectors have a sum, a difference, `dot` and `cross`"),
            },
            (Vector(a), b @ (Real(_) | Opaque(_))) if matches!(op, BinOp::Mul(_) | BinOp::Div(_)) => {
                let b = self.real(syntax, b);
                let factor = if matches!(op, BinOp::Div(_)) { self.graph.recip(b) } else { b };
                Vector(a.iter().map(|a| self.graph.mul(*a, factor)).collect())
            }
            (a @ (Real(_) | Opaque(_)), Vector(b)) if matches!(op, BinOp::Mul(_)) => {
                let a = self.real(syntax, a);
                Vector(b.iter().map(|b| self.graph.mul(a, *b)).collect())
            }
            // Whether these are integers is known to rustc alone, so that it has to do what they decide.
            (Opaque(a), Opaque(b)) if is_arithmetic(op) => Opaque(quote!((#a #op #b))),
            (Opaque(a), Integer(b)) if is_arithmetic(op) => {
                let b = proc_macro2::Literal::i128_unsuffixed(b);
                Opaque(quote!((#a #op #b)))
            }
            (Integer(a), Opaque(b)) if is_arithmetic(op) => {
                let a = proc_macro2::Literal::i128_unsuffixed(a);
                Opaque(quote!((#a #op #b)))
            }
            (a @ (Real(_) | Opaque(_)), b @ (Real(_) | Opaque(_))) => {
                let (a, b) = (self.real(syntax, a), self.real(syntax, b));
                self.reals(syntax, op, a, b)
            }
            (a @ (List(_) | Tuple(_) | Iterator(_)), _) | (_, a) => {
                self.refuse(syntax, format!("this operator does not apply to {}", a.kind()))
            }
        }
    }

    fn reals(&mut self, syntax: &impl ToTokens, op: &BinOp, a: Id, b: Id) -> Value {
        let graph = &mut self.graph;
        Value::Real(match op {
            BinOp::Add(_) => graph.add(a, b),
            BinOp::Sub(_) => graph.sub(a, b),
            BinOp::Mul(_) => graph.mul(a, b),
            BinOp::Div(_) => graph.div(a, b),
            _ => {
                let (relation, a, b, negated) = match op {
                    BinOp::Lt(_) => (Relation::Less, a, b, false),
                    BinOp::Le(_) => (Relation::LessEqual, a, b, false),
                    BinOp::Gt(_) => (Relation::Less, b, a, false),
                    BinOp::Ge(_) => (Relation::LessEqual, b, a, false),
                    BinOp::Eq(_) => (Relation::Equal, a, b, false),
                    BinOp::Ne(_) => (Relation::Equal, a, b, true),
                    _ => return self.refuse(syntax, format!("numbers have no such operator; {EXPRESSIONS}")),
                };
                let truth = graph.compare(relation, a, b);
                return Value::Truth(if negated { graph.not(truth) } else { truth });
            }
        })
    }

    fn integers(&mut self, syntax: &impl ToTokens, op: &BinOp, a: i128, b: i128) -> Value {
        let truth = match op {
            BinOp::Lt(_) => Some(a < b),
            BinOp::Le(_) => Some(a <= b),
            BinOp::Gt(_) => Some(a > b),
            BinOp::Ge(_) => Some(a >= b),
            BinOp::Eq(_) => Some(a == b),
            BinOp::Ne(_) => Some(a != b),
            _ => None,
        };
        if let Some(truth) = truth {
            return Value::Truth(self.graph.truth(truth));
        }
        let result = match op {
            BinOp::Add(_) => a.checked_add(b),
            BinOp::Sub(_) => a.checked_sub(b),
            BinOp::Mul(_) => a.checked_mul(b),
            BinOp::Div(_) => a.checked_div(b),
            BinOp::Rem(_) => a.checked_rem(b),
            _ => None,
        };
        match result {
            Some(n) => Value::Integer(n),
            None => self.refuse(syntax, "this integer cannot be computed; integers have `+ - * / %`"),
        }
    }

    fn branch(&mut self, branch: &ExprIf) -> Value {
        let condition = match self.expr(&branch.cond) {
            Value::Truth(id) => id,
            Value::Poison => return Value::Poison,
            other => {
                return self.refuse(&branch.cond, format!("a condition compares numbers; this is {}", other.kind()));
            }
        };
        // A condition on loop indices is decided now: only one branch exists.
        if let Some(truth) = self.graph.as_truth(condition) {
            return match (&branch.else_branch, truth) {
                (_, true) => self.block(&branch.then_branch),
                (Some((_, other)), false) => self.expr(other),
                (None, false) => Value::unit(),
            };
        }
        let Some((_, otherwise)) = &branch.else_branch else {
            // What the branch would do is to assign; that message is the better one.
            let said = self.errors.len();
            let before = self.enter_branch();
            self.block(&branch.then_branch);
            self.leave_branch(before);
            if self.errors.len() == said {
                self.refuse(&branch.if_token, "give this `if` an `else`: it must have a value on both sides");
            }
            return Value::Poison;
        };
        let before = self.enter_branch();
        let first = self.block(&branch.then_branch);
        let second = self.expr(otherwise);
        self.leave_branch(before);
        self.select(branch, condition, first, second)
    }

    /// `if condition { first } else { second }`, element by element.
    fn select(&mut self, syntax: &ExprIf, condition: Id, first: Value, second: Value) -> Value {
        use Value::{List, Opaque, Poison, Real, Truth, Tuple, Vector};
        match (first, second) {
            (Poison, _) | (_, Poison) => Poison,
            (a @ (Real(_) | Opaque(_)), b @ (Real(_) | Opaque(_))) => {
                let (a, b) = (self.real(syntax, a), self.real(syntax, b));
                Real(self.graph.select(condition, a, b))
            }
            (Vector(a), Vector(b)) if a.len() == b.len() => {
                Vector(a.iter().zip(&b).map(|(a, b)| self.graph.select(condition, *a, *b)).collect())
            }
            (List(a), List(b)) if a.len() == b.len() => {
                let pairs = a.iter().cloned().zip(b.iter().cloned());
                Value::list(pairs.map(|(a, b)| self.select(syntax, condition, a, b)).collect())
            }
            (Tuple(a), Tuple(b)) if a.len() == b.len() => {
                Tuple(a.into_iter().zip(b).map(|(a, b)| self.select(syntax, condition, a, b)).collect())
            }
            (Truth(a), Truth(b)) => {
                let graph = &mut self.graph;
                let (yes, no) = (graph.and(condition, a), graph.not(condition));
                let no = graph.and(no, b);
                Truth(graph.or(yes, no))
            }
            (a, b) => self.refuse(
                &syntax.if_token,
                format!("both sides of an `if` are numbers; here one is {} and the other {}", a.kind(), b.kind()),
            ),
        }
    }

    fn index(&mut self, base_syntax: &Expr, syntax: &Expr, base: Value, index: Value) -> Value {
        if matches!(base, Value::Poison) {
            return Value::Poison;
        }
        let Some(i) = self.integer(syntax, index) else { return Value::Poison };
        let found = match &base {
            Value::List(items) => usize::try_from(i).ok().and_then(|i| items.get(i).cloned()),
            Value::Vector(ids) => usize::try_from(i).ok().and_then(|i| ids.get(i).map(|id| Value::Real(*id))),
            Value::Opaque(path) => {
                let i = proc_macro2::Literal::i128_unsuffixed(i);
                return Value::Opaque(quote!(#path[#i]));
            }
            other => return self.refuse(base_syntax, format!("{} cannot be indexed", other.kind())),
        };
        match found {
            Some(value) => value,
            None => self.refuse(syntax, format!("the index {i} is out of bounds")),
        }
    }

    /// A value as an integer.
    pub(super) fn integer(&mut self, syntax: &impl ToTokens, value: Value) -> Option<i128> {
        match value {
            Value::Integer(n) => return Some(n),
            Value::Poison => {}
            Value::Opaque(_) => {
                self.refuse(syntax, "this bound is not known to the macro: write the number, or a `const` in the body");
            }
            Value::Real(_) => {
                self.refuse(
                    syntax,
                    "a bound or index that depends on data is not supported: it must be an integer constant",
                );
            }
            other => {
                self.refuse(syntax, format!("expected an integer, found {}", other.kind()));
            }
        }
        None
    }

    fn field(&mut self, field: &syn::ExprField) -> Value {
        let base = self.expr(&field.base);
        match (&field.member, base) {
            (_, Value::Poison) => Value::Poison,
            (Member::Named(name), Value::Vector(ids)) => {
                let i = ["x", "y", "z", "w"].iter().position(|axis| name == axis);
                match i.and_then(|i| ids.get(i)) {
                    Some(id) => Value::Real(*id),
                    None => {
                        self.refuse(&field.member, format!("a vector of length {} has no such component", ids.len()))
                    }
                }
            }
            (Member::Unnamed(index), Value::Tuple(items)) => match items.into_iter().nth(index.index as usize) {
                Some(value) => value,
                None => self.refuse(&field.member, "the tuple has no such component"),
            },
            (_, other) => self.refuse(field, format!("{} has no such field", other.kind())),
        }
    }

    fn range(&mut self, range: &syn::ExprRange) -> Value {
        let (Some(start), Some(end)) = (&range.start, &range.end) else {
            return self.refuse(range, "a range needs both ends, as in `0..3`");
        };
        let (low, high) = (self.expr(start), self.expr(end));
        let (Some(low), Some(high)) = (self.integer(start, low), self.integer(end, high)) else {
            return Value::Poison;
        };
        let high = if matches!(range.limits, RangeLimits::Closed(_)) { high.saturating_add(1) } else { high };
        if high.saturating_sub(low) > 100_000 {
            return self.refuse(
                range,
                "this range is too long: loops are unrolled, and rustc could not compile that in good time",
            );
        }
        self.evaluations += (high - low).max(0) as usize;
        Value::iterator((low..high).map(Value::Integer))
    }

    fn cast(&mut self, cast: &syn::ExprCast) -> Value {
        let value = self.expr(&cast.expr);
        if matches!(value, Value::Poison) {
            return Value::Poison;
        }
        let target = match &*cast.ty {
            syn::Type::Path(path) => path.path.get_ident().map(ToString::to_string).unwrap_or_default(),
            _ => String::new(),
        };
        match (value, target.as_str()) {
            (value, "f64" | "f32") => self.cast_to_float(cast, &target, value),
            (Value::Integer(n), target) => match wrapped(n, target) {
                Some(n) => Value::Integer(n),
                None => self.refuse(&cast.ty, "integers can be cast to `f64` and to integers in whose bounds they lie"),
            },
            (Value::Opaque(path), _) => {
                let ty = &cast.ty;
                Value::Opaque(quote!((#path as #ty)))
            }
            _ => self.refuse(cast, "only integers can be cast: a number cast to an integer has no derivative"),
        }
    }

    fn cast_to_float(&mut self, cast: &syn::ExprCast, target: &str, value: Value) -> Value {
        if target != self.float {
            return self.refuse(&cast.ty, format!("all numbers of an energy have one type, here `{}`", self.float));
        }
        match value {
            Value::Integer(n) => Value::Real(self.graph.number(Number::float(n as f64))),
            // It is a number from here on, so that `/` is no longer that of integers.
            Value::Opaque(path) => Value::Real(self.constant(path)),
            Value::Real(id) if self.graph.as_number(id).is_some() => Value::Real(id),
            Value::Real(_) => {
                let float = &self.float;
                let message = format!("this is a number of type `{float}` already: leave the cast out");
                self.refuse(cast, message)
            }
            other => self.refuse(cast, format!("{} cannot be cast to a number", other.kind())),
        }
    }

    /// xʸ: closed forms for exponents that are integers or halves.
    pub(super) fn power(&mut self, base: Id, exponent: Id) -> Id {
        let half_integer = self.graph.as_number(exponent).and_then(|exponent| match exponent {
            Number::Exact(ratio) if ratio.denominator <= 2 && ratio.numerator.abs() <= 64 => Some(ratio),
            _ => None,
        });
        match half_integer {
            Some(ratio) => self.graph.pow(base, ratio),
            None => self.graph.call(crate::ir::Function::Powf, &[base, exponent]),
        }
    }

    pub(super) fn integer_power(&mut self, base: Id, n: i64) -> Id {
        self.graph.pow(base, Ratio::integer(n))
    }

    /// Calls a closure or nested function.
    pub(super) fn apply(
        &mut self,
        syntax: &impl ToTokens,
        (callable, sees): (&Rc<Callable>, &Scopes),
        arguments: Vec<Value>,
    ) -> Value {
        if callable.parameters.len() != arguments.len() {
            let n = callable.parameters.len();
            return self.refuse(syntax, format!("this takes {n} arguments"));
        }
        if self.calls.iter().any(|other| Rc::ptr_eq(other, callable)) {
            let name = callable.name.as_deref().unwrap_or("this closure");
            return self
                .refuse(syntax, format!("`{name}` calls itself: nested functions are inlined and cannot recur"));
        }
        let before = std::mem::replace(&mut self.scopes, sees.clone());
        self.calls.push(callable.clone());
        // What is captured may be read, not assigned to.
        self.scopes.close(Around::Function);
        self.scopes.enter();
        for (pattern, argument) in callable.parameters.iter().zip(arguments) {
            self.bind(pattern, argument);
        }
        let value = self.expr(&callable.body);
        self.calls.pop();
        self.scopes = before;
        value
    }

    fn call(&mut self, call: &syn::ExprCall) -> Value {
        if let Some(name) = simple_name(&call.func)
            && let Some(found) = self.named(&call.func, &name)
        {
            let arguments = call.args.iter().map(|argument| self.expr(argument)).collect();
            return match found {
                Value::Callable(callable, sees) => self.apply(&call.func, (&callable, &sees), arguments),
                Value::Poison => Value::Poison,
                other => self.refuse(&call.func, format!("only functions can be called; this is {}", other.kind())),
            };
        }
        let Expr::Path(path) = &*call.func else {
            return self.refuse(&call.func, "only nested functions and closures can be called");
        };
        let segments: Vec<_> = path.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        let arguments: Vec<Value> = call.args.iter().map(|argument| self.expr(argument)).collect();
        let (owner, function) = match &segments[..] {
            [.., owner, function] => (owner.as_str(), function.as_str()),
            _ => ("", ""),
        };
        match (owner, function) {
            ("f64" | "f32", _) if segments.len() == 2 && owner != self.float => {
                let message = format!("all numbers of an energy have one type, here `{}`", self.float);
                self.refuse(&call.func, message)
            }
            ("f64" | "f32", "from") if segments.len() == 2 && arguments.len() == 1 => {
                match arguments.into_iter().next() {
                    Some(Value::Integer(n)) => Value::Real(self.graph.number(Number::float(n as f64))),
                    Some(Value::Opaque(path)) => Value::Real(self.constant(path)),
                    value => value.unwrap_or(Value::Poison),
                }
            }
            ("f64" | "f32", method) if segments.len() == 2 && !arguments.is_empty() => {
                let mut arguments = arguments.into_iter();
                let receiver = arguments.next().unwrap_or(Value::Poison);
                let id = self.real(call, receiver);
                self.method_of_real(&call.func, method, id, arguments.collect())
            }
            (owner, "new") if vector_length(owner) == Some(arguments.len()) => {
                Value::Vector(arguments.into_iter().map(|value| self.real(call, value)).collect())
            }
            (owner, "zeros") if arguments.is_empty() && vector_length(owner).is_some() => {
                let zero = self.graph.zero();
                Value::Vector(vec![zero; vector_length(owner).unwrap_or_default()])
            }
            (owner, "from") if (owner == "SVector" || vector_length(owner).is_some()) && arguments.len() == 1 => {
                let items = match arguments.into_iter().next() {
                    Some(Value::List(items)) => items,
                    _ => return self.refuse(call, "a vector is made from an array"),
                };
                Value::Vector(items.iter().map(|value| self.real(call, value.clone())).collect())
            }
            _ => self.refuse(
                &call.func,
                "the macro cannot see into functions outside of the energy: make this a nested `fn` or a closure",
            ),
        }
    }
}

/// Says that a macro inside the body is not understood.
pub(super) fn other_macro(call: &syn::Macro) -> String {
    let name = call.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
    format!("this attribute cannot see into `{name}!`: check arguments where the function is called; {EXPRESSIONS}")
}

/// The length of a vector type of nalgebra that has its length in its name.
fn vector_length(name: &str) -> Option<usize> {
    name.strip_prefix("Vector")?.parse().ok().filter(|n| (1..=6).contains(n))
}

fn is_arithmetic(op: &BinOp) -> bool {
    matches!(op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) | BinOp::Rem(_))
}

fn is_comparison(op: &BinOp) -> bool {
    matches!(op, BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) | BinOp::Eq(_) | BinOp::Ne(_))
}

/// `n as target`: the bits that fit. Of `usize` and `isize` only what fits on every processor.
fn wrapped(n: i128, target: &str) -> Option<i128> {
    match target {
        "i8" => Some((n as i8).into()),
        "i16" => Some((n as i16).into()),
        "i32" => Some((n as i32).into()),
        "i64" => Some((n as i64).into()),
        "i128" => Some(n),
        "u8" => Some((n as u8).into()),
        "u16" => Some((n as u16).into()),
        "u32" => Some((n as u32).into()),
        "u64" => Some((n as u64).into()),
        "usize" => u32::try_from(n).ok().map(Into::into),
        "isize" => i32::try_from(n).ok().map(Into::into),
        _ => None,
    }
}
