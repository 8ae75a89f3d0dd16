# SPDX-License-Identifier: GPL-3.0-or-later
"""Points at which statements are looked at: a dictionary gives each variable a number."""
import random
from fractions import Fraction

import enclosures as N
import formulas as F
from values import Unsupported

SPECIAL = [Fraction(0), Fraction(1), Fraction(-1), Fraction(1, 2)]


class Points:
    def __init__(self, meaning, seed, samples, special):
        self.meaning, self.rng, self.samples, self.special = meaning, random.Random(seed), samples, special

    def number(self, low=None, high=None, ends=(False, False)):
        if low is None:
            if self.rng.random() < self.special:
                return self.rng.choice(SPECIAL)
            return Fraction(self.rng.randint(-300, 300), self.rng.randint(60, 140))
        if self.rng.random() < 0.2:
            chosen = self.rng.randint(0, 1)
            if ends[chosen]:
                return (low, high)[chosen]
        t = Fraction(self.rng.randint(1, 996), 997)
        return N.plus(low, N.times(N.plus(high, N.minus(low)), t))

    def interval(self, domain, scope, point):
        if domain[3] == ("infinity",):
            low = self.evaluate(self.meaning.scalar(domain[2], scope), point)
            return N.plus(low, Fraction(self.rng.randint(1, 500), self.rng.choice((1, 50, 5000))))
        low, high = (self.evaluate(self.meaning.scalar(x, scope), point) for x in domain[2:4])
        order = N.sign(N.plus(high, N.minus(low)))
        if order is None or order < 0 or (order == 0 and (domain[1] != "[" or domain[4] != "]")):
            raise Unsupported("an empty interval")
        return self.number(low, high, (domain[1] == "[", domain[4] == "]"))

    def needed(self, formula, point):
        """Gives each parameter in the formula a value."""
        for name in sorted(formula.has - point.keys()):
            if name not in self.meaning.variables:
                point[name] = self.number()  # u and v where they stand for themselves
                continue
            domain = self.meaning.variables[name]
            if domain is None:
                point[name] = self.number()
            elif domain[0] == "interval":
                point[name] = self.interval(domain, {}, point)
            else:
                raise Unsupported("a parameter over this set")

    def evaluate(self, formula, point):
        self.needed(formula, point)
        return F.evaluate(formula, point, {})

    def draw(self, names, domain, scope, point):
        if domain is None:
            return [self.number() for _ in names]
        if domain[0] == "interval":
            if len(names) != 1:
                raise Unsupported("names over an interval")
            return [self.interval(domain, scope, point)]
        inner = domain[0] == "call" and domain[1] == ("name", "interior")
        shape = domain[2][0] if inner else domain
        if shape == ("name", "square"):
            n, total = len(names), None
        elif shape == ("name", "triangle"):
            n, total = 2, 1
        elif shape[0] == "call" and shape[1] == ("name", "simplex"):
            n, total = self.meaning.integer(shape[2][0], scope), 1
        else:
            raise Unsupported("a domain of this kind")
        if n != len(names):
            raise Unsupported("names for another number of coordinates")
        if total is None:
            return [self.number(Fraction(0), Fraction(1), (not inner, not inner)) for _ in names]
        parts = [self.rng.randint(1, 400) for _ in range(n + 1)]
        if not inner and self.rng.random() < 0.35:
            for k in self.rng.sample(range(n + 1), self.rng.randint(1, n)):
                parts[k] = 0
        return [Fraction(p, sum(parts)) for p in parts[:n]]

    def is_in(self, symbols, domain, scope, point):
        if domain is None:
            return True
        xs = [point[s] for s in symbols]
        if domain[0] == "interval":
            if domain[3] == ("infinity",):
                return N.sign(N.plus(xs[0], N.minus(self.evaluate(self.meaning.scalar(domain[2], scope), point)))) == 1
            low, high = (self.evaluate(self.meaning.scalar(x, scope), point) for x in domain[2:4])
            return N.sign(N.plus(xs[0], N.minus(low))) == 1 and N.sign(N.plus(high, N.minus(xs[0]))) == 1
        total = Fraction(1)
        for x in xs:
            total = N.plus(total, N.minus(x))
        return all(N.sign(x) == 1 for x in xs) and (N.sign(total) == 1 or domain == ("name", "square") and all(N.sign(N.plus(Fraction(1), N.minus(x))) == 1 for x in xs))

    def inside(self, point):
        for name, domain in self.meaning.variables.items():
            if name in point and domain is not None and domain[0] == "interval":
                low, high = (self.evaluate(self.meaning.scalar(x, {}), point) for x in domain[2:4])
                if N.sign(N.plus(point[name], N.minus(low))) != 1 or N.sign(N.plus(high, N.minus(point[name]))) != 1:
                    return False
        return True
