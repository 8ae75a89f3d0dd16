# SPDX-License-Identifier: GPL-3.0-or-later
"""Proofs that *formula relation 0* on a region: pieces, a number, or a reduction to such proofs about other formulas."""
from domain import Simplex
from pieces import Piece, shown
from polynomial import NotJudged, Polynomial
from program import RELATIONS, relation_holds
from reading import listed, members, need, whole
from tower import Open, Refused

ONE, ZERO = Polynomial.constant(1), Polynomial()
DIRECTION = {">": 1, ">=": 1, "=": 0, "!=": 0, "<=": -1, "<": -1}
EXCLUDE_ZERO = (">", "!=", "<")
KINDS = ("multiplier", "conjugate", "both", "cases", "condition", "factors", "excluded", "squares", "combination")
DEEPEST = 60


class Region:
    """A product of simplices cut by conditions (polynomial, relation), in variables and functions. `lines` are the
    variables of the obligation that belong to no factor."""

    def __init__(self, program, factors, conditions, lines=()):
        self.program, self.factors, self.conditions, self.lines = program, factors, conditions, set(lines)

    @staticmethod
    def of(program, factors, conditions, functions, lines=()):
        """Larger than the domain: each function is one coordinate more, and what defines it is a condition."""
        factors, conditions = list(factors), list(conditions)
        for f in functions:
            kind, inside, _ = program.functions[f]
            symbol = Polynomial.symbol(f)
            if isinstance(kind, int):
                factors.append(Simplex(program, [f], [[ONE, ZERO], [ZERO, ONE]], [False, False]))
                conditions.append((symbol ** kind - inside, "="))
            elif kind == "exp":
                factors.append(Simplex(program, [f], [[ONE, ZERO], [ZERO, ONE]], [False, True]))
            elif kind in ("sin", "cos"):
                factors.append(Simplex(program, [f], [[ONE, -ONE], [ONE, ONE]], [False, False]))
                cosine = program.cosine_before(program.functions, kind, inside)
                if cosine is not None:
                    conditions.append((symbol ** 2 + Polynomial.symbol(cosine, 2) - ONE, "="))
        return Region(program, factors, conditions, lines)

    def with_condition(self, formula, relation):
        return Region(self.program, self.factors, self.conditions + [(formula, relation)], self.lines)

    def bounds(self, formula):
        """Whether all that stands in it, beside generators, are coordinates of the region."""
        return formula.support() <= {v for f in self.factors for v in f.variables} | set(self.program.generators)

    def holds(self, formula):
        """Whether it is a formula in the variables and functions of the region. A logarithm has no coordinate."""
        others = {s for s in formula.support() if s not in self.lines}
        return others <= {v for f in self.factors for v in f.variables} | set(self.program.generators)

    def for_pieces(self):
        """The conditions that pieces count, None for one that is not looked at since it has a logarithm."""
        kept = [(f if self.bounds(f) else None, r) for f, r in self.conditions]
        return [(f, r) for f, r in kept if f is not None] if self.lines else kept


def shows(region, formula, relation, proof, depth=0):
    """Whether the proof shows that formula relation 0 on the region."""
    return depth <= DEEPEST and Step(region, formula, relation, depth).shown_by(proof)


class Step:
    def __init__(self, region, formula, relation, depth):
        need(relation in RELATIONS, "no relation")
        self.region, self.relation, self.depth = region, relation, depth
        self.program = region.program
        self.formula = self.program.tower.reduce(formula)

    def term(self, index):
        term = self.program.term(whole(index, 0, len(self.program.nodes)))
        if not self.region.holds(term):
            raise Refused("a term that holds another variable than the region")
        return term

    def terms(self, indices):
        return [self.term(index) for index in listed(indices)]

    def known(self, indices):
        """Conditions of the region by their numbers."""
        return [self.region.conditions[whole(i, 0, len(self.region.conditions))] for i in listed(indices)]

    def also(self, formula, relation, proof, region=None):
        return shows(region or self.region, formula, relation, proof, self.depth + 1)

    def is_zero(self, formula):
        return not self.program.tower.reduce(formula)

    def shown_by(self, proof):
        if proof == "computation":
            known = self.program.is_number(self.formula)
            return known and relation_holds(self.program.sign(self.formula), self.relation)
        need(isinstance(proof, dict) and proof, "no proof")
        if "pieces" in proof:
            return self.pieces(members(proof, "pieces")[0])
        kind = next((k for k in KINDS if k in proof), None)
        if kind is None:
            raise NotJudged("a reduction: " + next(iter(proof)))
        return getattr(self, kind)(proof)

    def pieces(self, content):
        if "square" in content:
            side, steps, square, cofactor = members(content, "side", "steps", "square", "cofactor")
        else:
            (side, steps), square = members(content, "side", "steps"), None
        formula, relation = self.formula, self.relation
        if relation == "!=":
            relation = side
            if side not in (">", "<"):
                return False
        if square is not None:
            square, cofactor = self.term(square), self.term(cofactor)
            if relation not in (">=", "<=") or not self.is_zero(square * square * cofactor - formula):
                return False
            formula = cofactor
        if not self.region.bounds(formula):
            return False
        conditions = self.region.for_pieces()
        relations = [r for _, r in conditions]
        piece = Piece.whole(self.program, self.region.factors, formula, [f for f, _ in conditions])
        return shown(piece, relation, relations, steps)

    def multiplier(self, proof):
        h, positive, rest = members(proof, "multiplier", "positive", "product")
        h = self.term(h)
        if self.relation == "!=":  # h f is not 0, so f is not
            return self.also(h * self.formula, "!=", rest)
        return self.also(h, ">", positive) and self.also(h * self.formula, self.relation, rest)

    def conjugate(self, proof):
        """If f < 0 at a point where f + h >= 0, then h > 0 and f h < 0 there; and so on."""
        h, total, rest = members(proof, "conjugate", "sum", "product")
        h, direction = self.term(h), DIRECTION[self.relation]
        if direction == 0:
            return False
        wanted = self.relation if direction == 1 else ">" if self.relation == "<" else ">="
        return (self.also(self.formula + h, ">=" if direction == 1 else "<=", total)
                and self.also(self.formula * h, wanted, rest))

    def both(self, proof):
        above, below = listed(members(proof, "both")[0], 2)
        return self.relation == "=" and self.also(self.formula, ">=", above) and self.also(self.formula, "<=", below)

    def cases(self, proof):
        a, above, below = members(proof, "cases", "above", "below")
        a = self.term(a)
        return (self.also(self.formula, self.relation, above, self.region.with_condition(a, ">="))
                and self.also(self.formula, self.relation, below, self.region.with_condition(a, "<")))

    def condition(self, proof):
        i, times = members(proof, "condition", "times")
        (formula, relation), = self.known([i])
        times = self.term(times)
        if not self.program.is_number(times) or not self.is_zero(self.formula - times * formula):
            return False
        signs = {s * self.program.sign(times) for s in (-1, 0, 1) if relation_holds(s, relation)}
        return all(relation_holds(s, self.relation) for s in signs)

    def factors(self, proof):
        factors, parts = members(proof, "factors", "parts")
        factors = self.terms(factors)
        if self.relation == "=" or len(factors) != len(listed(parts)):
            return False
        rest = -self.formula if self.relation in ("<", "<=") else self.formula
        result = ONE
        for factor in factors:
            result = self.program.tower.reduce(result * factor)
        wanted = {"<": ">", "<=": ">="}.get(self.relation, self.relation)
        return self.is_zero(rest - result) and all(self.also(f, wanted, p) for f, p in zip(factors, parts))

    def is_sum_of_squares(self, squares, weights):
        """f = Σ wᵢ qᵢ², with numbers wᵢ ≠ 0 of the one sign that the relation wants."""
        if len(squares) != len(weights) or not all(map(self.program.is_number, weights)):
            return False
        total = self.formula
        for w, q in zip(weights, squares):
            total = total - w * self.program.tower.reduce(q * q)
        signs = {self.program.sign(w) for w in weights}
        wanted = DIRECTION[self.relation]
        return self.is_zero(total) and 0 not in signs and len(signs) <= 1 and (wanted == 0 or signs <= {wanted})

    def squares(self, proof):
        squares, weights = members(proof, "squares", "weights")
        return self.relation in (">=", "<=") and self.is_sum_of_squares(self.terms(squares), self.terms(weights))

    def excluded(self, proof):
        squares, weights, excluded, cofactors, ideal = members(
            proof, "squares", "weights", "excluded", "cofactors", "ideal")
        squares, cofactors, conditions = self.terms(squares), self.terms(cofactors), self.known(excluded)
        if (self.relation == "=" or not self.is_sum_of_squares(squares, self.terms(weights))
                or len(cofactors) != len(squares) or any(r not in EXCLUDE_ZERO for _, r in conditions)):
            return False
        difference = ONE
        for formula, _ in conditions:
            difference = difference * formula
        for m, q in zip(cofactors, squares):
            difference = difference - m * q
        return self.also(difference, "=", ideal)

    def combination(self, proof):
        chosen, cofactors, parts = members(proof, "combination", "cofactors", "parts")
        conditions, cofactors = self.known(chosen), self.terms(cofactors)
        directed = [(h, r) for h, (_, r) in zip(cofactors, conditions) if r != "="]
        if len(cofactors) != len(conditions) or len(listed(parts)) != 1 + len(directed):
            return False
        rest = self.formula
        for h, (formula, _) in zip(cofactors, conditions):
            rest = rest - h * formula
        for (h, relation), part in zip(directed, parts[1:]):
            agree = DIRECTION[relation] * DIRECTION[self.relation]
            if agree == 0 or not self.also(h, ">=" if agree == 1 else "<=", part):
                return False
        return self.also(rest, self.relation, parts[0])


def shows_safely(region, formula, relation, proof):
    """The same; a sign that could not be decided shows nothing."""
    try:
        return shows(region, formula, relation, proof)
    except Open:
        return False
