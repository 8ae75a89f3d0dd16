# SPDX-License-Identifier: GPL-3.0-or-later
"""That a system of n equations in n unknowns has exactly one solution in a domain, and where.

There is one in the inner box by the theorem of Poincaré and Miranda; at most one in the outer box, because the
Jacobian is strictly diagonally dominant there; and none elsewhere, which trees over the whole domain show.
"""
from itertools import product

from domain import Domain, Simplex, determinant
from polynomial import Polynomial
from reading import listed, members, rational, text, whole
from reductions import ONE, Region, shows_safely
from solutions import coefficients
from tower import Open, Refused


class Box:
    def __init__(self, program, unknowns, value):
        low, high = members(value, "low", "high")
        self.low, self.high = ([rational(x) for x in listed(ends, len(unknowns))] for ends in (low, high))
        if any(a >= b for a, b in zip(self.low, self.high)):
            raise Refused("an empty box")
        self.segments = []
        for x, a, b in zip(unknowns, self.low, self.high):
            corners = [[ONE, Polynomial.constant(a)], [ONE, Polynomial.constant(b)]]
            self.segments.append(Simplex(program, [x], corners, [False, False]))

    def corners(self, unknowns):
        for ends in product(*zip(self.low, self.high)):
            yield {x: Polynomial.constant(end) for x, end in zip(unknowns, ends)}

    def within(self, low, high):
        return all(a <= b for a, b in zip(low, self.low)) and all(a >= b for a, b in zip(high, self.high))

    def apart(self, low, high):
        return any(b < a for a, b in zip(low, self.high)) or any(b > a for a, b in zip(high, self.low))


class Obligation:
    def __init__(self, program, content):
        system, unknowns, for_all, factors, where, low, high = members(
            content, "system", "unknowns", "for_all", "factors", "where", "low", "high")
        self.program = program
        self.unknowns = [program.symbol(text(name)) for name in listed(unknowns)]
        self.domain = Domain(program, factors, where, program.of_statement)
        self.equations = coefficients(program, system, for_all, program.of_statement)
        stated = Box(program, self.unknowns, {"low": low, "high": high})
        self.low, self.high = stated.low, stated.high
        if sorted(self.unknowns) != sorted(self.domain.variables()):
            raise Refused("unknowns that are not the variables of the domain")
        if program.functions_of([whole(t, 0, program.of_statement) for t in system] + self.domain.terms):
            raise Refused("a system with functions")
        if any(program.variables(f) - set(self.unknowns) for f in self.equations + [f for f, _ in self.domain.conditions]):
            raise Refused("a system with another variable")

    def shown(self, factors, conditions, formula, relation, tree):
        return shows_safely(Region(self.program, factors, conditions), formula, relation, {"pieces": tree})

    def decided(self, evidence):
        matrix, inner, outer, faces, conditions, dominance, cover = members(
            evidence, "combination", "inner", "outer", "faces", "conditions", "dominance", "cover")
        n = len(self.unknowns)
        cut = self.domain.conditions + [(f, "=") for f in self.equations]
        if not listed(matrix):
            tree, = listed(cover, 1)
            return False if self.shown(self.domain.factors, cut, -ONE, ">=", tree) else None
        matrix = [[Polynomial.constant(rational(x)) for x in listed(row, n)] for row in listed(matrix, n)]
        if len(self.equations) != n or not determinant(matrix):
            return None
        combined = []
        for row in matrix:
            total = Polynomial()
            for factor, f in zip(row, self.equations):
                total = total + factor * f
            combined.append(total)
        inner = Box(self.program, self.unknowns, inner)
        if not self.has_solution(inner, combined, listed(faces, 2 * n), listed(conditions)):
            return None
        if inner.apart(self.low, self.high):
            return False
        outer = Box(self.program, self.unknowns, outer)
        cut = cut + [(g, "=") for g in combined]
        sides = []
        for x, a, b in zip(self.unknowns, outer.low, outer.high):
            sides += [Polynomial.symbol(x) - Polynomial.constant(a), Polynomial.constant(b) - Polynomial.symbol(x)]
        good = (inner.within(self.low, self.high) and inner.within(outer.low, outer.high)
                and self.is_dominant(outer, combined, listed(dominance, n << (n - 1)))
                and all(self.shown(self.domain.factors, cut, side, ">=", tree)
                        for side, tree in zip(sides, listed(cover, 2 * n))))
        return True if good else None

    def has_solution(self, inner, combined, faces, conditions):
        if not all(self.domain.in_factors(corner) for corner in inner.corners(self.unknowns)):
            return False
        faces = iter(faces)
        for i, (x, g) in enumerate(zip(self.unknowns, combined)):
            others = inner.segments[:i] + inner.segments[i + 1:]
            for end, relation in ((inner.low[i], "<"), (inner.high[i], ">")):
                if not self.shown(others, [], g.replace({x: Polynomial.constant(end)}), relation, next(faces)):
                    return False
        return len(conditions) == len(self.domain.conditions) and all(
            self.shown(inner.segments, [], f, r, tree) for (f, r), tree in zip(self.domain.conditions, conditions))

    def is_dominant(self, outer, combined, trees):
        trees = iter(trees)
        for x, g in zip(self.unknowns, combined):
            others = [y for y in self.unknowns if y != x]
            for n in range(1 << len(others)):
                total = g.derivative(x)
                for k, y in enumerate(others):
                    slope = g.derivative(y)
                    total = total - slope if n >> k & 1 else total + slope
                if not self.shown(outer.segments, [], total, ">", next(trees)):
                    return False
        return True


def judge(program, content, evidence):
    """True: holds; False: fails; None: open."""
    obligation = Obligation(program, content)
    try:
        return obligation.decided(evidence)
    except Open:
        return None
