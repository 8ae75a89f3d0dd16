# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas as polynomials in some of their variables; the coefficients are formulas."""
import random
from fractions import Fraction
from math import factorial

import enclosures as N
import formulas as F
from values import Unsupported


def of(f, names, memo=None):
    memo = {} if memo is None else memo
    if id(f) in memo:
        return memo[id(f)]
    none = (0,) * len(names)
    if not f.has & set(names):
        result = {none: f}
    elif f.op == "var":
        result = {tuple(int(name == f.args[0]) for name in names): F.ONE}
    elif f.op == "+":
        result = dict(of(f.args[0], names, memo))
        for key, c in of(f.args[1], names, memo).items():
            result[key] = F.add(result.get(key, F.ZERO), c)
    elif f.op == "*":
        result = product(of(f.args[0], names, memo), of(f.args[1], names, memo))
    elif f.op == "^" and f.args[1] > 0:
        result, base = {none: F.ONE}, of(f.args[0], names, memo)
        for _ in range(f.args[1]):
            result = product(result, base)
    elif f.op == "/" and not f.args[1].has & set(names):
        result = {key: F.div(c, f.args[1]) for key, c in of(f.args[0], names, memo).items()}
    else:
        raise Unsupported("no polynomial")
    memo[id(f)] = result
    return result


def product(a, b):
    result = {}
    for p, c in a.items():
        for q, d in b.items():
            key = tuple(x + y for x, y in zip(p, q))
            result[key] = F.add(result.get(key, F.ZERO), F.mul(c, d))
    return result


def is_zero(f):
    """Zero at a few random points, as far as can be seen."""
    for seed in (1, 2, 3):
        rng = random.Random(seed)
        point = {name: Fraction(rng.randint(1, 97), rng.randint(98, 197)) for name in sorted(f.has)}
        try:
            if N.sign(F.evaluate(f, point, {})) not in (0, None):
                return False
        except N.Undefined:
            continue
    return True


def nonzero(polynomial):
    return {key: c for key, c in polynomial.items() if not is_zero(c)}


def triangle_coefficients(polynomial, degree):
    """Of u^i v^j w^k in Bernstein form, by (i, j)."""
    result = {}
    for i in range(degree + 1):
        for j in range(degree + 1 - i):
            terms = []
            for (k, l), c in polynomial.items():
                if k <= i and l <= j:
                    weight = Fraction(factorial(i) * factorial(j) * factorial(degree - k - l),
                                      factorial(i - k) * factorial(j - l) * factorial(degree))
                    terms.append(F.mul(F.const(weight), c))
            result[i, j] = F.total(terms)
    return result


def line_coefficients(polynomial, degree):
    result = []
    for i in range(degree + 1):
        terms = []
        for (k,), c in polynomial.items():
            if k <= i:
                weight = Fraction(factorial(i) * factorial(degree - k), factorial(i - k) * factorial(degree))
                terms.append(F.mul(F.const(weight), c))
        result.append(F.total(terms))
    return result
