# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether statements hold, as far as values at points tell.

A truth is a number: 2 and -2 are certain, 1 and -1 are what points suggest (an equality of enclosures that meet, a statement for all
points that none of them contradicts), 0 is unknown. `and` is the least, `or` the largest, `not` the opposite."""
import random
from decimal import Decimal
from fractions import Fraction

import enclosures as N
import formulas as F
import predicates
import values as W
from meaning import Closure, Range
from values import Function, Items, Matrix, Unsupported, Vector

TRUE, LIKELY, UNKNOWN, UNLIKELY, FALSE = 2, 1, 0, -1, -2
SPECIAL = [Fraction(0), Fraction(1), Fraction(-1), Fraction(1, 2)]


class Truth:
    def __init__(self, meaning, seed, samples=6, special=0.15):
        self.meaning, self.rng, self.samples, self.special = meaning, random.Random(seed), samples, special
        self.is_held = 0
        self.standing = []  # what a point has to meet: functions of it
        self.assumed = self.met = 0  # assumptions looked at, and met
        self.cache = {}

    # ---- points
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

    # ---- statements
    def holds(self, tree, scope, point):
        kind = tree[0]
        if kind == "and":
            first = self.holds(tree[1], scope, point)
            return first if first == FALSE else min(first, self.holds(tree[2], scope, point))
        if kind == "or":
            first = self.here(tree[1], scope, point)
            return first if first == TRUE else max(first, self.here(tree[2], scope, point))
        if kind == "not":
            return -self.here(tree[1], scope, point)
        if kind == "implies":
            return self.implication(tree[1], tree[2], scope, point)
        if kind == "iff":
            forth = self.implication(tree[1], tree[2], scope, point)
            back = self.implication(tree[2], tree[1], scope, point)
            return min(forth, back)
        if kind == "for":
            return self.quantified(tree, scope, point)
        if kind == "relation":
            return self.relation(tree, scope, point)
        if kind in ("solve", "solve one"):
            import solving
            return solving.holds(self, tree, scope, point)
        if kind == "call" and tree[1][0] == "name":
            name = tree[1][1]
            defined = scope.get(name) or (self.meaning.lookup(name, scope) if name in self.meaning.definitions else None)
            if isinstance(defined, Closure):
                arguments = [self.meaning.value(a, scope) for a in tree[2]]
                return self.holds(defined.body, {**defined.scope, **dict(zip(defined.parameters, arguments))}, point)
            return predicates.holds(self, name, tree[2], scope, point)
        if kind == "name" and tree[1] in self.meaning.definitions:
            return self.holds(self.meaning.definitions[tree[1]][3], {}, point)
        raise Unsupported("a statement of kind " + kind)

    def here(self, tree, scope, point):
        """At this point and no other: it is no part of a conjunction that has to hold everywhere."""
        self.is_held += 1
        try:
            return self.holds(tree, scope, point)
        finally:
            self.is_held -= 1

    def implication(self, condition, conclusion, scope, point):
        self.assumed += 1
        here = self.here(condition, scope, point)
        if here <= 0:  # elsewhere it is met, perhaps
            if self.is_held:
                return -here
            point = self.repaired(condition, scope, point)
            if point is None:
                return -here
        self.met += 1
        self.standing.append(lambda p: self.here(condition, scope, p) > 0)
        try:
            return max(-here if here > 0 else FALSE, self.holds(conclusion, scope, point))
        finally:
            self.standing.pop()

    def repaired(self, condition, scope, point):
        """A point where the condition is met, and all that stands, from this one by steps in variables in which a comparison
        is linear, or by solving for several at once."""
        comparisons = self.comparisons(condition, scope)
        for attempt in range(6):
            moved = dict(point)
            for op, f in comparisons:
                self.needed(f, moved)
            try:
                if attempt % 2 == 0:
                    self.step(comparisons, moved)
                else:
                    self.solve_together([f for op, f in comparisons if op == "="], moved)
                    self.step([c for c in comparisons if c[0] != "="], moved)
                if self.inside(moved) and all(meets(moved) for meets in self.standing) and self.here(condition, scope, moved) > 0:
                    return moved
            except N.Undefined:
                pass
        return None

    def step(self, comparisons, moved):
        used = set()
        for op, f in comparisons:
            e = F.evaluate(f, moved, {})
            if (equal(e) == FALSE) if op == "!=" else op != "=" and ordered(op, e) > 0:
                continue
            wanted = Fraction(0) if op == "=" else Fraction(self.rng.randint(1, 60), 37) * (-1 if op in ("<", "<=") else 1)
            names = self.rng.sample(sorted(f.has), len(f.has))
            for name in sorted(names, key=lambda n: n in used):
                slope = F.diff(f, name)
                if name in slope.has:
                    continue
                a = F.evaluate(slope, moved, {})
                if N.sign(a) not in (0, None):
                    moved[name] = N.plus(moved[name], N.times(N.plus(wanted, N.minus(e)), N.inverse(a)))
                    break
            if op == "=":
                used |= f.has

    def solve_together(self, equations, moved):
        """Variables in which all of the equations are linear at once, one for each."""
        names = sorted(frozenset().union(*[f.has for f in equations])) if equations else []
        for _ in range(60):
            if len(names) < len(equations):
                return
            chosen = self.rng.sample(names, len(equations))
            slopes = [[F.diff(f, x) for x in chosen] for f in equations]
            if any(g.has & set(chosen) for row in slopes for g in row):
                continue
            rows = [[F.evaluate(g, moved, {}) for g in row] + [N.minus(F.evaluate(f, moved, {}))] for f, row in zip(equations, slopes)]
            steps = eliminated(rows)
            if steps is not None:
                for name, x in zip(chosen, steps):
                    moved[name] = N.plus(moved[name], x)
                return

    def inside(self, point):
        for name, domain in self.meaning.variables.items():
            if name in point and domain is not None and domain[0] == "interval":
                low, high = (self.evaluate(self.meaning.scalar(x, {}), point) for x in domain[2:4])
                if N.sign(N.plus(point[name], N.minus(low))) != 1 or N.sign(N.plus(high, N.minus(point[name]))) != 1:
                    return False
        return True

    def comparisons(self, tree, scope):
        """Of a conjunction: each operator and what stands on its left, with 0 on its right; equations first."""
        if tree[0] == "and":
            found = self.comparisons(tree[1], scope) + self.comparisons(tree[2], scope)
            return sorted(found, key=lambda c: c[0] != "=")
        if tree[0] == "relation" and "~" not in tree[1]:
            return [(op, f) for op, fs in zip(tree[1], self.differences(tree, scope)) for f in fs if F.value(f) is None]
        return []

    # ---- quantifiers
    def quantified(self, tree, scope, point):
        _, how, bindings, body = tree
        if how == "all":
            return self.bound(bindings, body, True, scope, point, id(tree))
        self.is_held += 1
        try:
            return self.bound(bindings, body, False, scope, point, id(tree))
        finally:
            self.is_held -= 1

    def bound(self, bindings, body, everywhere, scope, point, place):
        if not bindings:
            return self.holds(body, scope, point)
        names, domain, condition = bindings[0]
        sign = 1 if everywhere else -1
        values = self.finite(domain, scope)
        if values is not None:
            result = TRUE * sign
            for inner in self.meaning.bound(names, values, scope):
                if condition is not None:
                    met = self.holds(condition, inner, point)
                    if met == FALSE:
                        continue
                    if met < 0:
                        return UNKNOWN
                here = self.bound(bindings[1:], body, everywhere, inner, point, place)
                result = min(result, here) if everywhere else max(result, here)
                if result == FALSE * sign:
                    break
            return result
        symbols = ["q:%s:%d" % (n, place) for n in names]
        inner = {**scope, **dict(zip(names, map(F.var, symbols)))}
        seen = 0
        result = LIKELY * sign
        tries = self.samples if everywhere else 4 * self.samples
        self.standing.append(lambda p: self.is_in(symbols, domain, scope, p) and (condition is None or self.holds(condition, inner, p) > 0))
        for _ in range(tries if not condition else 12 * tries):
            moved = dict(point)
            moved.update(zip(symbols, self.draw(names, domain, scope, moved)))
            try:
                if condition is not None and self.holds(condition, inner, moved) <= 0:
                    continue
                here = self.bound(bindings[1:], body, everywhere, inner, moved, place)
            except N.Undefined:
                continue
            if here == UNKNOWN:
                continue
            for name in moved.keys() - set(symbols):
                point.setdefault(name, moved[name])
            seen += 1
            result = min(result, here) if everywhere else max(result, here)
            if result == FALSE * sign or seen >= tries:
                break
        self.standing.pop()
        if condition is not None:
            self.assumed += 1
            self.met += seen > 0
        return result if seen else UNKNOWN

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

    def finite(self, domain, scope):
        if domain is None or domain in (("name", "triangle"), ("name", "square")):
            return None
        if domain[0] == "interval":
            if domain[3] == ("infinity",):
                return None
            ends = [self.meaning.value(x, scope) for x in domain[2:4]]
            if all(isinstance(x, F.Formula) for x in ends):
                return None
            return Items(ends)
        if domain[0] == "call" and domain[1] in (("name", "simplex"), ("name", "interior")):
            return None
        value = self.meaning.value(domain, scope)
        if isinstance(value, (Items, Range)):
            return value
        raise Unsupported("a set of this kind")

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

    # ---- comparisons
    def differences(self, tree, scope):
        key = (id(tree), tuple(sorted((n, id(v)) for n, v in scope.items())))
        if key not in self.cache:
            values = [self.meaning.value(x, scope) for x in tree[2]]
            self.cache[key] = ([self.flat_difference(a, b) for a, b in zip(values, values[1:])], scope)
        pairs = self.cache[key][0]
        return pairs

    @staticmethod
    def flat_difference(a, b):
        if isinstance(a, Function) or isinstance(b, Function):
            if not (isinstance(a, Function) and isinstance(b, Function)):
                raise Unsupported("a function beside no function")
            if getattr(a, "degree", None) != getattr(b, "degree", None):
                raise Unsupported("patches of different degrees")
            points = [(Fraction(1, 7), Fraction(2, 9)), (Fraction(3, 5), Fraction(1, 11)), (Fraction(0), Fraction(5, 6))] + [
                (Fraction(k, 13), Fraction(12 - k, 29)) for k in range(9)]
            return [F.sub(x, y) for u, v in points
                    for x, y in zip(W.flat(W.at(a.value, [F.const(u), F.const(v)])), W.flat(W.at(b.value, [F.const(u), F.const(v)])))]
        x, y = W.flat(a), W.flat(b)
        if len(x) != len(y):
            if y == [F.ZERO] and isinstance(a, Vector):
                y = [F.ZERO] * len(x)
            elif x == [F.ZERO] and isinstance(b, Vector):
                x = [F.ZERO] * len(y)
            else:
                raise Unsupported("values of different lengths")
        return [F.sub(p, q) for p, q in zip(x, y)]

    def relation(self, tree, scope, point):
        _, operators, parts, is_truncated = tree
        result = TRUE
        for op, fs, part in zip(operators, self.differences(tree, scope), parts[1:]):
            signs = [self.evaluate(f, point) for f in fs]
            if op == "~":
                here = min(printed(x, text, is_truncated) for x, text in zip(signs, digits(part)))
            elif op in ("=", "!="):
                here = min(equal(x) for x in signs)
                here = here if op == "=" else -here
            else:
                if len(signs) != 1:
                    raise Unsupported("an order of vectors")
                here = ordered(op, signs[0])
            result = min(result, here)
        return result


def eliminated(rows):
    """The solution of a linear system, each row with its right side; None where there is not certainly one."""
    n = len(rows)
    for k in range(n):
        pivot = next((r for r in range(k, n) if N.sign(rows[r][k]) in (1, -1)), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        over = N.inverse(rows[k][k])
        rows[k] = [N.times(x, over) for x in rows[k]]
        for r in range(n):
            if r != k:
                factor = N.minus(rows[r][k])
                rows[r] = [N.plus(x, N.times(factor, y)) for x, y in zip(rows[r], rows[k])]
    return [row[n] for row in rows]


def equal(x):
    s = N.sign(x)
    if s == 0:
        return TRUE
    if s is None:
        return LIKELY if N.is_narrow(x) else UNKNOWN
    return FALSE


def ordered(op, x):
    """x stands on the left of op 0."""
    s = N.sign(x)
    if s is None:
        if not N.is_narrow(x):
            return UNKNOWN
        return LIKELY if op in ("<=", ">=") else UNLIKELY
    return TRUE if {"<": s < 0, "<=": s <= 0, ">": s > 0, ">=": s >= 0}[op] else FALSE


def digits(part):
    """The printed texts of a number, or of the entries of a vector."""
    if part[0] == "printed" and part[2][0] == "tuple":
        return [entry.strip() for entry in part[1].strip()[1:-1].split(",")]
    return [part[1]]


def printed(difference, text, is_truncated):
    """The difference is that of the value and the printed decimal."""
    try:
        number = Decimal(text.replace(" ", ""))
    except ArithmeticError:
        raise Unsupported("a printed value that is no decimal")
    unit = Fraction(1, 10 ** max(0, -number.as_tuple().exponent))
    if not is_truncated:
        low, high = N.plus(difference, unit / 2), N.plus(unit / 2, N.minus(difference))
        return min(ordered(">=", low), ordered(">=", high))
    away = difference if not text.startswith("-") else N.minus(difference)
    return min(ordered(">=", away), ordered("<", N.plus(away, -unit)))
