# SPDX-License-Identifier: GPL-3.0-or-later
"""Points given as evidence: a value for each variable and each function of an obligation."""
from polynomial import Polynomial
from reading import listed, members, text, whole
from tower import Refused

AT_ONE_PLACE = {"exp": (0, 1), "cos": (0, 1), "sin": (0, 0), "log": (1, 0)}


def read_point(program, value, terms, needed, bound=()):
    """{symbol: number}; refused if it lacks a variable that is needed, or gives a function what is not its value.
    Those that are `bound` need none."""
    names, values = members(value, "variables", "values")
    if len(listed(names)) != len(listed(values)) or len(set(map(text, names))) != len(names):
        raise Refused("a point with a value too many or too few")
    point = {program.symbol(name): program.number(whole(term, 0, len(program.nodes)))
             for name, term in zip(names, values)}
    if any(s in program.generators for s in point):
        raise Refused("a point that changes a generator")
    functions = program.functions_of(terms)
    written = program.written(terms + [program.functions[f][2] for f in functions])
    needed = set(needed) | {s for s in written if s not in program.generators} | set(functions)
    if not needed - set(bound) <= set(point):
        raise Refused("a point without a value for a variable")
    for function in functions:
        if not is_value(program, function, point):
            raise Refused("a point where a function has another value")
    return point


def is_value(program, function, point):
    tower = program.tower
    kind, inside, _ = program.functions[function]
    inside, value = tower.reduce(inside.replace(point)), point[function]
    if isinstance(kind, int):
        return tower.sign(value) >= 0 and not tower.reduce(value ** kind - inside)
    place, there = AT_ONE_PLACE[kind]
    if inside == Polynomial.constant(place):
        return value == Polynomial.constant(there)
    return any(value == Polynomial.symbol(g) and entry == (kind, inside)
               for g, entry in program.generators.items() if entry)
