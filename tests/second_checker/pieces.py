# SPDX-License-Identifier: GPL-3.0-or-later
"""Proofs of a sign over a product of simplices: trees of splits, down to pieces with coefficients of one sign.

A piece is the region in its own barycentric coordinates: one symbol a corner. Beside the formulas it keeps, for each
corner, in which corners of the undivided factor it has a share (a set of bits), for this decides which of its faces
belong to the domain.
"""
from itertools import product

from polynomial import Polynomial, degree_of, fields
from reading import listed, members, need, only_member, whole
from tower import Open, Refused

COMPLEMENT = {">": "<=", ">=": "<", "<": ">=", "<=": ">", "=": "!=", "!=": "="}


def barycentric(formula, factors, coordinates):
    """A positive multiple of the formula, homogeneous in the coordinates of each factor."""
    for factor, symbols in zip(factors, coordinates):
        forms = []
        for k in range(len(factor.variables) + 1):
            form = Polynomial()
            for corner, symbol in zip(factor.corners, symbols):
                form = form + corner[k] * Polynomial.symbol(symbol)
            forms.append(form)
        parts = formula.by_monomial(factor.variables)
        degree = max(map(degree_of, parts), default=0)
        weights = [Polynomial.constant(1)]
        for _ in range(degree):
            weights.append(weights[-1] * forms[0])
        values = dict(zip(factor.variables, forms[1:]))
        formula = Polynomial()
        by_degree = {}
        for monomial, coefficient in parts.items():
            of_degree = by_degree.setdefault(degree_of(monomial), Polynomial())
            by_degree[degree_of(monomial)] = of_degree + coefficient * Polynomial({monomial: 1}, degree)
        for at, part in by_degree.items():
            formula = formula + part.replace(values) * weights[degree - at]
    return formula


class Piece:
    """`formulas`: the one that is to be shown, then the conditions, None for those that are not looked at."""

    def __init__(self, program, factors, coordinates, formulas, shares):
        self.program, self.factors, self.coordinates = program, factors, coordinates
        self.formulas, self.shares = formulas, shares

    @staticmethod
    def whole(program, factors, formula, conditions):
        coordinates = [[program.fresh() for _ in factor.corners] for factor in factors]
        formulas = []
        for f in [formula, *conditions]:
            if f is not None:
                f = program.tower.reduce(barycentric(f, factors, coordinates)).cleared()
            formulas.append(f)
        return Piece(program, factors, coordinates, formulas, [[1 << i for i in range(len(c))] for c in coordinates])

    def part(self, factor, weights, signs, i):
        """That in which the point Σ wⱼ cornerⱼ takes the place of corner i."""
        tower, symbols = self.program.tower, self.coordinates[factor]
        formulas = []
        for f in self.formulas:
            if f is not None:
                if weights[i] != Polynomial.constant(1):
                    f = f.replace({symbols[i]: Polynomial.symbol(symbols[i]) * weights[i]})
                for j, weight in enumerate(weights):
                    if j != i and signs[j]:
                        f = f.shift(symbols[j], weight, symbols[i])
                f = tower.reduce(f).cleared()
            formulas.append(f)
        shares = [list(masks) for masks in self.shares]
        shares[factor][i] = 0
        for j, sign in enumerate(signs):
            shares[factor][i] |= self.shares[factor][j] if sign else 0
        return Piece(self.program, self.factors, self.coordinates, formulas, shares)

    def signs(self, which):
        """{monomial in the coordinates: sign of its coefficient}, without zeros"""
        if which not in (cache := self.__dict__.setdefault("known", {})):
            symbols = [s for c in self.coordinates for s in c]
            found = {}
            for monomial, coefficient in self.formulas[which].by_monomial(symbols).items():
                if self.program.variables(coefficient):
                    raise Refused("a formula over pieces that holds another variable")
                found[monomial] = self.program.sign(coefficient)
            cache[which] = {m: s for m, s in found.items() if s}
        return cache[which]

    def is_plain(self, which, relation, relations):
        """Whether the coefficients of formula number `which` show the relation over this piece."""
        want = {">": 1, ">=": 1, "<": -1, "<=": -1}.get(relation)
        if want is None:
            return False
        try:
            signs = self.signs(which)
        except Open:
            return False
        if -want in signs.values():
            return False
        if relation in (">=", "<="):
            return True
        for face in self.faces(len(relations) == 0):
            outside = ~fields(face)
            if all(m & outside for m in signs) and not self.excluded(outside, relations):
                return False
        return True

    def faces(self, minimal):
        """Choices of sets of corners, one a factor, whose inner points belong to the factor: lists of symbols."""
        choices = []
        for factor, symbols, shares in zip(self.factors, self.coordinates, self.shares):
            n, good = len(symbols), []
            for subset in sorted(range(1, 1 << n), key=int.bit_count):
                union = 0
                for i in range(n):
                    union |= shares[i] if subset >> i & 1 else 0
                finite = any(union >> i & 1 and w for i, w in enumerate(factor.weights))
                if finite and all(union >> i & 1 for i, is_open in enumerate(factor.open) if is_open):
                    if not (minimal and any(smaller & subset == smaller for smaller in good)):
                        good.append(subset)
            choices.append([[s for i, s in enumerate(symbols) if subset >> i & 1] for subset in good])
        return [sum(choice, []) for choice in product(*choices)]

    def excluded(self, outside, relations):
        """Whether a condition is broken on the inner points of a face."""
        for i, relation in enumerate(relations):
            if self.formulas[1 + i] is None:
                continue
            try:
                there = {s for m, s in self.signs(1 + i).items() if not m & outside}
            except Open:
                continue
            broken = {">": ({-1}, set()), ">=": ({-1},), "=": ({1}, {-1}), "!=": (set(),),
                      "<=": ({1},), "<": ({1}, set())}[relation]
            if there in broken:
                return True
        return False


def shown(piece, relation, relations, steps):
    """Whether the steps, depth first, show of formula 0 that the relation holds on the region."""
    todo = [piece]
    for step in listed(steps):
        if not todo:
            return False
        piece = todo.pop()
        if step == "plain":
            if not piece.is_plain(0, relation, relations):
                return False
        elif isinstance(step, dict) and "split" in step:
            factor, at = members(step, "split", "at")
            factor = whole(factor, 0, len(piece.factors))
            weights = [piece.program.number(whole(t, 0, len(piece.program.nodes)))
                       for t in listed(at, len(piece.coordinates[factor]))]
            try:
                signs = [piece.program.sign(w) for w in weights]
            except Open:
                return False
            if min(signs) < 0 or not any(signs):
                return False
            todo += [piece.part(factor, weights, signs, i) for i in reversed(range(len(signs))) if signs[i]]
        else:
            kind, i = only_member(step)
            need(kind == "outside", "no step")
            i = whole(i, 0, len(relations))
            ways = ("<", ">") if relations[i] == "=" else (COMPLEMENT[relations[i]],)
            if piece.formulas[1 + i] is None or not any(piece.is_plain(1 + i, way, relations) for way in ways):
                return False
    return not todo
