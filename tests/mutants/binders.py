# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of the language whose arguments bind names, or are expressions in variables."""
from fractions import Fraction

import enclosures as N
import extrema
import formulas as F
import polynomials
import values as W
from meaning import Range
from values import Function, Items, Patch, Surface, Unsupported, Vector


def gathered(m, name, trees, scope):
    if len(trees) == 1 and trees[0][0] == "each":
        bindings = trees[0][2]
        if name in ("max", "min") and any(b[1] is None or is_continuous(m, b[1], scope) for b in bindings):
            return extrema.over(m, name, trees[0], scope)
        return combine(name, m.each(trees[0], scope))
    values = [m.value(t, scope) for t in trees]
    if name in ("max", "min") and len(values) == 1 and isinstance(values[0], (Function, extrema.OnSurface)):
        return extrema.of(name, values[0])
    if len(values) == 1 and isinstance(values[0], Surface):
        raise Unsupported("a count of a surface")
    if len(values) == 1 and isinstance(values[0], (Items, Range)):
        values = list(values[0])
    return combine(name, values)


def is_continuous(m, domain, scope):
    if domain[0] == "interval":
        return domain[1] == "(" or domain[4] == ")" or isinstance(m.value(domain[2], scope), F.Formula)
    return domain in (("name", "triangle"), ("name", "square")) or domain[0] == "call"


def combine(name, values):
    if name == "count":
        return F.const(len(values))
    if name == "sum":
        if values and isinstance(values[0], list):
            result = values[0]
            for v in values[1:]:
                result = type(result)(F.add(a, b) for a, b in zip(result, v))
            return result
        return F.total(values)
    if name == "product":
        result = F.ONE
        for v in values:
            result = F.mul(result, v)
        return result
    if not values or not all(isinstance(v, F.Formula) for v in values):
        raise Unsupported(name + " of these")
    result = values[0]
    for v in values[1:]:
        result = F.make("max", result, v) if name == "max" else F.neg(F.make("max", F.neg(result), F.neg(v)))
    return result


def variable_name(m, tree, scope):
    value = m.value(tree, scope)
    if isinstance(value, F.Formula) and value.op == "var":
        return value.args[0]
    raise Unsupported("expected a variable")


def diff(m, name, trees, scope):
    times = m.integer(trees[2], scope) if len(trees) > 2 else 1
    return W.derivative(m.value(trees[0], scope), variable_name(m, trees[1], scope), times)


def subst(m, name, trees, scope):
    names = {}
    for tree in trees[1:]:
        if tree[0] != "named":
            raise Unsupported("subst")
        names[variable_name(m, ("name", tree[1]), scope)] = m.scalar(tree[2], scope)
    memo = {}
    return W.transform(m.value(trees[0], scope), lambda f: F.substitute(f, names, memo))


def limit(m, name, trees, scope):
    if len(trees) != 1 or trees[0][0] != "limit" or trees[0][3] != ("infinity",):
        raise Unsupported("a limit elsewhere")
    f = m.scalar(trees[0][1], {**scope, trees[0][2]: F.var("#n")})
    if f.has != {"#n"}:
        raise Unsupported("a limit with parameters")
    far, farther = (N.interval(F.evaluate(f, {"#n": Fraction(10) ** k}, {})) for k in (30, 34))
    margin = 2 * abs(far.low - farther.low) + (N.ONE >> 80)
    if margin > N.ONE >> 60:
        raise Unsupported("a limit that is not seen")
    return F.make("known", N.Interval(farther.low - margin, farther.high + margin))


def coefficients_in_bernstein_form(m, name, trees, scope):
    value = m.value(trees[0], scope)
    over = trees[1][1] if trees[1][0] == "name" else None
    if over == "square":
        raise Unsupported("a Bernstein form on the square")
    if over == "triangle":
        names = ("u", "v")
        if isinstance(value, Function):
            value = W.at(value.value, [F.var("u"), F.var("v")])
    else:
        names = (variable_name(m, trees[1], scope),)
    polynomial = [polynomials.nonzero(polynomials.of(f, names)) for f in W.flat(value)]
    own = max((sum(k) for p in polynomial for k in p), default=0)
    degree = m.integer(trees[2], scope) if len(trees) > 2 else own
    if degree < own:
        raise Unsupported("a degree below its own")
    wrap = (lambda xs: xs[0]) if isinstance(value, F.Formula) else Vector
    if over != "triangle":
        columns = [polynomials.line_coefficients(p, degree) for p in polynomial]
        return Items(wrap(list(x)) for x in zip(*columns))
    tables = [polynomials.triangle_coefficients(p, degree) for p in polynomial]
    return Items(wrap([t[i, j] for t in tables]) for j in range(degree + 1) for i in range(degree + 1 - j))


def degree(m, name, trees, scope):
    if len(trees) == 1:
        p = m.value(trees[0], scope)
        if not isinstance(p, Patch) or p.degree is None:
            raise Unsupported("a degree of no patch")
        return Vector(F.const(d) for d in p.degree) if isinstance(p.degree, tuple) else F.const(p.degree)
    x = variable_name(m, trees[1], scope)
    powers = polynomials.nonzero(polynomials.of(m.scalar(trees[0], scope), (x,)))
    return F.const(max((k for k, in powers), default=0))


def coefficients(m, name, trees, scope):
    x = variable_name(m, trees[1], scope)
    powers = polynomials.nonzero(polynomials.of(m.scalar(trees[0], scope), (x,)))
    return Items(powers.get((k,), F.ZERO) for k in range(max((k for k, in powers), default=0) + 1))
