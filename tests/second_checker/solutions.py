# SPDX-License-Identifier: GPL-3.0-or-later
"""The real solutions of a system in one unknown: the roots of the common divisor of its coefficients."""
from domain import Simplex
from polynomial import Polynomial, power_of
from reading import listed, members, need, rational, text, whole
from reductions import Region, shows_safely
from tower import Open, Refused


LEAST, NIL, GREATEST = ([Polynomial.constant(x) for x in corner] for corner in ((0, -1), (1, 0), (0, 1)))
HALVES = [NIL, GREATEST], [LEAST, NIL]


def coefficients(program, system, for_all, below):
    """Those of the terms with respect to the variables `for_all`, without zeros, by rising exponent vectors."""
    variables = [program.symbol(text(name)) for name in listed(for_all)]
    found = []
    for index in listed(system):
        parts = program.term(whole(index, 0, below)).by_monomial(variables)
        found += [parts[m] for m in sorted(parts, key=lambda m: [power_of(m, v) for v in variables])]
    return found


class Obligation:
    def __init__(self, program, content):
        system, unknown, for_all, domain, solutions = members(
            content, "system", "unknown", "for_all", "domain", "solutions")
        below = program.of_statement
        self.program, self.unknown = program, program.symbol(text(unknown))
        self.line = [Simplex(program, [self.unknown], corners, [False, False]) for corners in HALVES]
        if domain != {"variables": [unknown], "corners": [], "open": []}:  # else all real numbers
            self.line = [Simplex.read(program, domain, below)]
        need(self.line[0].variables == [self.unknown], "a domain in another variable")
        self.terms = [whole(t, 0, below) for t in listed(system)]
        self.coefficients = coefficients(program, system, for_all, below)
        if program.functions_of(self.terms):
            raise Refused("a system with functions")
        for c in self.coefficients:
            if program.variables(c) - {self.unknown}:
                raise Refused("a system with another variable")
        self.intervals = [members(s, "low", "high") for s in listed(solutions) if isinstance(s, dict)]
        self.intervals = [(rational(low), rational(high)) for low, high in self.intervals]
        self.exact = [program.number(whole(s, 0, below)) for s in solutions if not isinstance(s, dict)]
        if self.exact and self.intervals:
            raise Refused("solutions of two kinds")
        ends = [end for interval in self.intervals for end in interval]
        if any(low >= high for low, high in self.intervals) or ends != sorted(ends):
            raise Refused("intervals that are out of order")

    def in_domain(self, number):
        return any(part.holds({self.unknown: number}) for part in self.line)

    def is_zero_at(self, polynomial, number):
        return self.program.sign(self.program.tower.reduce(polynomial.replace({self.unknown: number}))) == 0

    def in_unknown(self, index):
        term = self.program.term(whole(index, 0, len(self.program.nodes)))
        if not term.support() <= {self.unknown} | set(self.program.generators):
            raise Refused("a term with another variable than the unknown")
        return term

    def shown(self, simplex, polynomial, proof):
        return shows_safely(Region(self.program, [simplex], []), polynomial, "!=", proof)

    def roots(self, evidence):
        divisor, cofactors, quotients, multiplicities, rest, inside, outside = members(
            evidence, "divisor", "cofactors", "quotients", "multiplicities", "rest", "inside", "outside")
        divisor, reduce = self.in_unknown(divisor), self.program.tower.reduce
        cofactors, quotients = ([self.in_unknown(t) for t in listed(ts, len(self.coefficients))]
                                for ts in (cofactors, quotients))
        total = Polynomial()
        for f, c, q in zip(self.coefficients, cofactors, quotients):
            total = total + reduce(c * f)
            if reduce(q * divisor - f):
                return False
        if reduce(total - divisor):
            return False
        if self.intervals:
            return self.isolated(divisor, listed(inside), listed(outside))
        product = self.in_unknown(rest)
        for part, proof in zip(self.line, listed(outside, len(self.line))):
            if not self.shown(part, product, proof):
                return False
        for solution, multiplicity in zip(self.exact, listed(multiplicities, len(self.exact))):
            factor = Polynomial.symbol(self.unknown) - solution
            product = reduce(product * factor ** whole(multiplicity, 1))
            if not self.in_domain(solution):
                return False
        different = all(self.program.sign(a - b) for i, a in enumerate(self.exact) for b in self.exact[:i])
        return not reduce(product - divisor) and different

    def isolated(self, divisor, inside, outside):
        """Each interval has one root: opposite signs at its ends, and a slope without zeros."""
        if len(inside) != len(self.intervals) or len(outside) != len(self.intervals) + 1:
            return False
        slope = divisor.derivative(self.unknown)
        one = Polynomial.constant(1)
        for (low, high), proof in zip(self.intervals, inside):
            ends = [Polynomial.constant(low), Polynomial.constant(high)]
            signs = [self.program.sign(divisor.replace({self.unknown: end})) for end in ends]
            simplex = Simplex(self.program, [self.unknown], [[one, ends[0]], [one, ends[1]]], [False, False])
            if signs[0] * signs[1] != -1 or not all(map(self.in_domain, ends)):
                return False
            if not self.shown(simplex, slope, proof):
                return False
        return all(part is None or self.shown(part, divisor, proof) for part, proof in zip(self.gaps(), outside))

    def gaps(self):
        """The parts of the domain before, between and after the intervals; None for a single point."""
        one = Polynomial.constant(1)
        lows = [[one, Polynomial.constant(low)] for low, _ in self.intervals]
        highs = [[one, Polynomial.constant(high)] for _, high in self.intervals]
        first, last, open_first, open_last = LEAST, GREATEST, False, False
        if len(self.line) == 1:  # a facet is opposite to its corner
            (first, last), (open_last, open_first) = self.line[0].corners, self.line[0].open
            if self.line[0].orientation < 0:
                first, last, open_first, open_last = last, first, open_last, open_first
        starts, ends = [first] + highs, lows + [last]
        for i, (a, b) in enumerate(zip(starts, ends)):
            if self.program.sign(a[0] * b[1] - a[1] * b[0]) == 0:
                yield None
            else:
                opened = [i == len(self.intervals) and open_last, i == 0 and open_first]
                yield Simplex(self.program, [self.unknown], [a, b], opened)

    def wrong(self, evidence):
        """Whether the claim is refuted: a solution that is none, or one that is missing."""
        value, claimed = members(evidence, "value", "claimed")
        if whole(claimed, -1, len(self.exact)) >= 0:
            solution = self.exact[claimed]
            return not (self.in_domain(solution) and all(self.is_zero_at(c, solution) for c in self.coefficients))
        value = self.program.number(whole(value, 0, len(self.program.nodes)))
        if not self.in_domain(value) or not all(self.is_zero_at(c, value) for c in self.coefficients):
            return False
        apart = all(self.program.sign(value - Polynomial.constant(low)) < 0
                    or self.program.sign(value - Polynomial.constant(high)) > 0 for low, high in self.intervals)
        return apart and all(self.program.sign(value - s) for s in self.exact)


def judge(program, content, kind, evidence):
    """True: holds; False: fails; None: open."""
    obligation = Obligation(program, content)
    try:
        if kind == "roots":
            return True if obligation.roots(evidence) else None
        return False if obligation.wrong(evidence) else None
    except Open:
        return None
