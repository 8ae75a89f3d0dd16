# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether statements hold, as far as values at points tell."""
from fractions import Fraction

import enclosures as N
import formulas as F
import minimax
import predicates
import values as W
from comparing import FALSE, LIKELY, TRUE, UNKNOWN, digits, equal, ordered, printed
from meaning import Closure, Range
from moving import Moving
from values import Function, Items, Unsupported, Vector


class Truth(Moving):
    def __init__(self, meaning, seed, samples=6, special=0.15):
        super().__init__(meaning, seed, samples, special)
        self.assumed = self.met = 0  # assumptions looked at, and met
        self.without_value = 0  # points where something certainly has none
        self.is_held = 0
        self.cache = {}

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
            except N.Undefined as error:
                self.without_value += isinstance(error, N.Nothing)
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
        if parts[0][:2] == ("call", ("name", "minimax")):
            return minimax.holds(self, tree, scope, point)
        result = TRUE
        for op, fs, part in zip(operators, self.differences(tree, scope), parts[1:]):
            signs = [self.evaluate(f, point) for f in fs]
            if op == "~":
                here = min(printed(x, text, is_truncated) for x, text in zip(signs, digits(part)))
            elif op in ("=", "!="):
                here = min((equal(x) for x in signs), default=TRUE)
                here = here if op == "=" else -here
            else:
                if len(signs) != 1:
                    raise Unsupported("an order of vectors")
                here = ordered(op, signs[0])
            result = min(result, here)
        return result
