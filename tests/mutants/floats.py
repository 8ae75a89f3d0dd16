# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas as functions of floating-point numbers, for what has to be evaluated thousands of times."""
import math

import enclosures as N

OPERATORS = {"+": "({} + {})", "*": "({} * {})", "/": "({} / {})", "max": "max({}, {})", "abs": "abs({})"}


def compiled(f, names):
    """A function of the named variables, in this order."""
    lines, known = [], {}
    stack = [f]
    while stack:
        g = stack[-1]
        missing = [a for a in g.args if hasattr(a, "op") and id(a) not in known]
        if id(g) in known:
            stack.pop()
        elif missing:
            stack += missing
        else:
            stack.pop()
            name = known[id(g)] = "t%d" % len(lines)
            lines.append("    %s = %s" % (name, text(g, known, names)))
    scope = {"math": math}
    source = "def f(%s):\n%s\n    return %s\n" % (", ".join("x%d" % i for i in range(len(names))), "\n".join(lines), known[id(f)])
    exec(compile(source, "formula", "exec"), scope)
    return scope["f"]


def text(g, known, names):
    args = [known[id(a)] if hasattr(a, "op") else a for a in g.args]
    if g.op == "const":
        return repr(float(args[0]))
    if g.op == "var":
        return "x%d" % names.index(args[0])
    if g.op in ("known", "solution"):
        return repr(N.to_float(args[-1]))
    if g.op == "pi":
        return "math.pi"
    if g.op in OPERATORS:
        return OPERATORS[g.op].format(*args)
    if g.op == "^":
        return "%s ** %d" % tuple(args)
    if g.op == "root":
        power = "** (1 / %d)" % args[1]
        return "math.copysign(abs({0}) {1}, {0})".format(args[0], power) if args[1] % 2 else "max(%s, 0.0) %s" % (args[0], power)
    return "math.%s(%s)" % (g.op, args[0])
