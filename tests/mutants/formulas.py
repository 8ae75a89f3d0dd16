# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas as shared graphs: made with folding of exact constants, differentiated by rules, evaluated at points."""
import math
from fractions import Fraction

import enclosures as number

TABLE = {}


class Formula:
    __slots__ = ("op", "args", "has")

    def __init__(self, op, args, has):
        self.op, self.args, self.has = op, args, has  # has: the variables in it


def make(op, *args):
    key = (op,) + tuple(id(a) if isinstance(a, Formula) else a for a in args)
    found = TABLE.get(key)
    if found is None:
        has = frozenset().union(*[a.has for a in args if isinstance(a, Formula)])
        if op == "var":
            has = frozenset([args[0]])
        found = TABLE[key] = Formula(op, args, has)
    return found


def const(x):
    return make("const", Fraction(x))


def var(name):
    return make("var", name)


def value(f):
    return f.args[0] if f.op == "const" else None


ZERO, ONE = const(0), const(1)


def add(a, b):
    if a.op == "const" and b.op == "const":
        return const(a.args[0] + b.args[0])
    if a is ZERO:
        return b
    if b is ZERO:
        return a
    return make("+", a, b)


def neg(a):
    if a.op == "const":
        return const(-a.args[0])
    return mul(const(-1), a)


def sub(a, b):
    return ZERO if a is b else add(a, neg(b))


def mul(a, b):
    if a.op == "const" and b.op == "const":
        return const(a.args[0] * b.args[0])
    if a is ZERO or b is ZERO:
        return ZERO
    if a is ONE:
        return b
    if b is ONE:
        return a
    return make("*", a, b)


def div(a, b):
    if b.op == "const" and b.args[0] != 0:
        return mul(const(1 / b.args[0]), a)
    return make("/", a, b)


def power(a, n):
    if n == 0:
        return ONE
    if n == 1:
        return a
    if a.op == "const" and abs(n) < 200 and (n > 0 or a.args[0] != 0):
        return const(a.args[0] ** n)
    return make("^", a, n)


def root(a, n=2):
    if a.op == "const":
        try:
            exact = number.root(a.args[0], n)
        except number.Undefined:
            exact = None
        if isinstance(exact, Fraction):
            return const(exact)
    return make("root", a, n)


def call(name, a):
    return make(name, a)


def total(fs):
    result = ZERO
    for f in fs:
        result = add(result, f)
    return result


def diff(f, x, memo=None):
    memo = {} if memo is None else memo
    if x not in f.has:
        return ZERO
    if id(f) in memo:
        return memo[id(f)]
    op, args = f.op, f.args
    if op == "var":
        result = ONE
    elif op == "+":
        result = add(diff(args[0], x, memo), diff(args[1], x, memo))
    elif op == "*":
        result = add(mul(diff(args[0], x, memo), args[1]), mul(args[0], diff(args[1], x, memo)))
    elif op == "/":
        a, b = args
        result = div(sub(mul(diff(a, x, memo), b), mul(a, diff(b, x, memo))), mul(b, b))
    elif op == "^":
        result = mul(mul(const(args[1]), power(args[0], args[1] - 1)), diff(args[0], x, memo))
    elif op == "root":
        a, n = args
        result = div(diff(a, x, memo), mul(const(n), power(f, n - 1)))
    elif op == "exp":
        result = mul(f, diff(args[0], x, memo))
    elif op == "log":
        result = div(diff(args[0], x, memo), args[0])
    elif op == "sin":
        result = mul(call("cos", args[0]), diff(args[0], x, memo))
    elif op == "cos":
        result = neg(mul(call("sin", args[0]), diff(args[0], x, memo)))
    else:
        raise NotImplementedError("a derivative of " + op)
    memo[id(f)] = result
    return result


def substitute(f, names, memo=None):
    memo = {} if memo is None else memo
    if not (f.has & names.keys()):
        return f
    if id(f) in memo:
        return memo[id(f)]
    if f.op == "var":
        result = names[f.args[0]]
    else:
        args = [substitute(a, names, memo) if isinstance(a, Formula) else a for a in f.args]
        result = {"+": add, "*": mul, "/": div, "^": power, "root": root}.get(f.op, lambda *a: make(f.op, *a))(*args)
    memo[id(f)] = result
    return result


def evaluate(f, point, memo):
    """An enclosure of the value; `point` gives each variable a number."""
    key = id(f)
    if key in memo:
        return memo[key]
    op, args = f.op, f.args
    if op == "const":
        result = args[0]
    elif op == "var":
        result = point[args[0]]
    elif op == "+":
        result = number.plus(evaluate(args[0], point, memo), evaluate(args[1], point, memo))
    elif op == "*":
        result = number.times(evaluate(args[0], point, memo), evaluate(args[1], point, memo))
    elif op == "/":
        result = number.times(evaluate(args[0], point, memo), number.inverse(evaluate(args[1], point, memo)))
    elif op == "^":
        result = number.power(evaluate(args[0], point, memo), args[1])
    elif op == "root":
        result = number.root(evaluate(args[0], point, memo), args[1])
    elif op == "abs":
        result = number.absolute(evaluate(args[0], point, memo))
    elif op == "max":
        result = number.larger(evaluate(args[0], point, memo), evaluate(args[1], point, memo))
    elif op == "pi":
        result = number.elementary("pi", None)
    elif op == "known":  # an enclosure made elsewhere, such as of an extremum
        result = args[0]
    elif op == "solution":
        result = args[1]
    else:
        result = number.elementary(op, evaluate(args[0], point, memo))
    memo[key] = result
    return result


def evaluate_float(f, point, memo):
    key = id(f)
    if key in memo:
        return memo[key]
    op, args = f.op, f.args
    if op == "const":
        result = float(args[0])
    elif op == "var":
        result = point[args[0]]
    elif op in ("known", "solution"):
        result = number.to_float(args[-1])
    elif op == "pi":
        result = math.pi
    else:
        a = evaluate_float(args[0], point, memo)
        if op in ("+", "*", "/", "max"):
            b = evaluate_float(args[1], point, memo)
            result = a + b if op == "+" else a * b if op == "*" else a / b if op == "/" else max(a, b)
        elif op == "^":
            result = a ** args[1]
        elif op == "root":
            result = math.copysign(abs(a) ** (1 / args[1]), a) if args[1] % 2 else max(a, 0.0) ** (1 / args[1])
        elif op == "abs":
            result = abs(a)
        else:
            result = getattr(math, op)(a)
    memo[key] = result
    return result
