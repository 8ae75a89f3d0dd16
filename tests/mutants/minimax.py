# SPDX-License-Identifier: GPL-3.0-or-later
"""`minimax(E, a, triangle) = v`: looked at in floating point, for some other values of the parameter."""
import floats
import formulas as F
from comparing import LIKELY, UNLIKELY
from extrema import largest
from values import Function, Unsupported


def holds(t, tree, scope, point):
    _, operators, parts, _ = tree
    trees = parts[0][2]
    if operators != ["="] or len(trees) != 3 or trees[1][0] != "name":
        raise Unsupported("minimax in another form")
    m = t.meaning
    name = trees[1][1]
    item = m.definitions.get(name)
    domain = item[3] if item and item[0] == "param" else None
    shape = trees[2][1] if trees[2][0] == "name" else None
    if shape not in ("triangle", "square"):
        raise Unsupported("minimax over another set")
    value = m.value(trees[0], scope)
    f = value.value if isinstance(value, Function) else F.substitute(value, {"u": F.var("#1"), "v": F.var("#2")})
    best = m.scalar(parts[1], scope)
    if f.has - {"#1", "#2", name} or best.has:
        raise Unsupported("minimax with parameters")
    low, high = -1e3, 1e3
    if domain is not None:
        low, high = (F.evaluate_float(m.scalar(x, {}), {}, {}) for x in domain[2:4])

    at = floats.compiled(f, ("#1", "#2", name))

    def error(a):
        return largest(lambda u, v: abs(at(u, v, a)), shape, 12)
    v = F.evaluate_float(best, {}, {})
    if not low <= v <= high:
        return UNLIKELY
    least = error(v)
    others = [v + s * d for d in (1e-4, 1e-2, 0.1, 0.7) for s in (1, -1) if low <= v + s * d <= high]
    return LIKELY if all(error(a) >= least - 1e-9 * (1 + abs(least)) for a in others) else UNLIKELY
