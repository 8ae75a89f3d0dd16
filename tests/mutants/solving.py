# SPDX-License-Identifier: GPL-3.0-or-later
"""`solve`: that the listed solutions are solutions, and, for one unknown, that no other is seen."""
import math
from fractions import Fraction

import enclosures as N
import formulas as F
from comparing import LIKELY, TRUE, UNKNOWN, UNLIKELY, ordered, printed
from values import Unsupported


def holds(t, tree, scope, point):
    kind, bindings, system, condition, solutions = tree
    names = [n for b in bindings for n in b[0]]
    domains = [b[1] for b in bindings for n in b[0]]
    if any(b[2] is not None or len(b[0]) > 1 and b[1] is not None for b in bindings):
        raise Unsupported("unknowns with a condition of their own")
    if kind == "solve one":
        if len(names) != 1:
            return UNKNOWN
        roots = seen(t, names[0], domains[0], system, condition, scope, point)
        if roots is None:
            return UNKNOWN
        if len(roots) != 1:
            return UNLIKELY
        if solutions is None:
            return LIKELY
        margin = Fraction(1, 10 ** 8)
        text, middle = solutions[1], Fraction(roots[0])
        value = t.meaning.scalar(solutions[2], scope)
        near = N.interval(N.plus(middle, N.minus(t.evaluate(value, point))))
        wide = N.Interval(near.low - int(margin * N.ONE), near.high + int(margin * N.ONE))
        return max(-1, min(1, printed(wide, text, False)))
    result = TRUE
    listed = []
    for solution in solutions:
        value = t.meaning.value(solution, scope)
        entries = [value] if isinstance(value, F.Formula) else list(value)
        if len(entries) != len(names):
            raise Unsupported("solutions of another length")
        inner = {**scope, **dict(zip(names, entries))}
        result = min(result, t.holds(system, inner, point))
        if condition is not None:
            result = min(result, t.holds(condition, inner, point))
        for x, domain in zip(entries, domains):
            result = min(result, inside(t, x, domain, scope, point))
        listed.append([N.to_float(t.evaluate(x, point)) for x in entries])
    if result < 0:
        return result
    if len(names) != 1 or not solutions:
        others = linear(t, names, system, scope, point)
        if others is not None and len(solutions) == others:
            return min(result, LIKELY)
    if len(names) != 1:
        return UNKNOWN
    roots = seen(t, names[0], domains[0], system, condition, scope, point)
    if roots is None:
        return UNKNOWN
    others = [r for r in roots if all(abs(r - x[0]) > 1e-5 * (1 + abs(r)) for x in listed)]
    return UNLIKELY if others else min(result, LIKELY)


def linear(t, names, system, scope, point):
    """How many solutions a linear system has, 0 or 1; None: it is not linear, or has more."""
    symbols = ["#x%d" % k for k in range(len(names))]
    equations = equations_of(t, system, {**scope, **dict(zip(names, map(F.var, symbols)))}, 7)
    if equations is None:
        return None
    rows = []
    for f in equations:
        slopes = [F.diff(f, s) for s in symbols]
        if any(g.has & set(symbols) for g in slopes):
            return None
        rest = F.substitute(f, {s: F.ZERO for s in symbols})
        rows.append([t.evaluate(g, point) for g in slopes] + [t.evaluate(rest, point)])
    rank = 0
    for k in range(len(names) + 1):
        pivot = next((r for r in range(rank, len(rows)) if N.sign(rows[r][k]) in (1, -1)), None)
        if pivot is None:
            continue
        if k == len(names):
            return 0
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        over = N.inverse(rows[rank][k])
        for r in range(rank + 1, len(rows)):
            factor = N.minus(N.times(rows[r][k], over))
            rows[r] = [N.plus(x, N.times(factor, y)) for x, y in zip(rows[r], rows[rank])]
        rank += 1
    return 1 if rank == len(names) else None


def equations_of(t, tree, scope, copies):
    """What has to be 0; a statement for all u becomes some statements of single values. None: the system has another form."""
    if tree[0] == "and":
        parts = [equations_of(t, part, scope, copies) for part in tree[1:]]
        return None if None in parts else parts[0] + parts[1]
    if tree[0] == "relation" and tree[1] == ["="]:
        return [f for f in t.differences(tree, scope)[0] if f is not F.ZERO]
    if tree[0] == "for" and tree[1] == "all" and all(b[1] is None and b[2] is None for b in tree[2]):
        names, found = [n for b in tree[2] for n in b[0]], []
        for k in range(copies):
            values = {n: F.const(Fraction(3 * k + 2 * j + 1, 17)) for j, n in enumerate(names)}
            part = equations_of(t, tree[3], {**scope, **values}, copies)
            if part is None:
                return None
            found += part
        return found
    return None


def inside(t, x, domain, scope, point):
    if domain is None:
        return TRUE
    if domain[0] != "interval":
        raise Unsupported("an unknown over this set")
    low, high = (t.meaning.scalar(y, scope) for y in domain[2:4])
    left = ordered(">=" if domain[1] == "[" else ">", t.evaluate(F.sub(x, low), point))
    right = ordered("<=" if domain[4] == "]" else "<", t.evaluate(F.sub(x, high), point))
    return min(left, right)


def seen(t, name, domain, system, condition, scope, point):
    """Where the equations, looked at in floating point, change their signs; None: they have no such form."""
    inner = {**scope, name: F.var("#x")}
    equations = equations_of(t, system, inner, 3)
    if not equations:
        return None
    for f in equations:
        t.needed(F.substitute(f, {"#x": F.ZERO}), point)
    low, high = -60.0, 60.0
    if domain is not None:
        low, high = (N.to_float(t.evaluate(t.meaning.scalar(y, scope), point)) for y in domain[2:4])
    floats = {k: N.to_float(v) for k, v in point.items()}

    def at(f, x):
        try:
            return F.evaluate_float(f, {**floats, "#x": x}, {})
        except (ZeroDivisionError, ValueError, OverflowError):
            return math.nan
    first = next((f for f in equations if "#x" in f.has), None)
    if first is None:
        return None
    n = 1501
    grid = [low + (high - low) * (k + 0.37) / n for k in range(n)]
    if domain is None:
        grid = sorted(grid + [x / 30 for x in grid])
    if domain is not None and domain[1] == "[":
        grid = [low] + grid
    if domain is not None and domain[4] == "]":
        grid = grid + [high]
    values = [at(first, x) for x in grid]
    roots = []
    for a, b, fa, fb in zip(grid, grid[1:], values, values[1:]):
        if not (math.isfinite(fa) and math.isfinite(fb)):
            continue
        if fa == 0:
            root = a
        elif fa * fb < 0:
            for _ in range(80):
                middle = (a + b) / 2
                if fa * at(first, middle) <= 0:
                    b = middle
                else:
                    a = middle
            root = (a + b) / 2
            if abs(at(first, root)) > 1e-6 * (1 + abs(fa) + abs(fb)):
                continue  # a pole
        else:
            continue
        if all(abs(at(f, root)) < 1e-6 for f in equations) and meets(t, condition, name, root, scope, point):
            if all(abs(root - r) > 1e-7 for r in roots):
                roots.append(root)
    return roots


def meets(t, condition, name, root, scope, point):
    if condition is None:
        return True
    try:
        return t.holds(condition, {**scope, name: F.const(Fraction(root))}, dict(point)) >= 0
    except N.Undefined:
        return False
