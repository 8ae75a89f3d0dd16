# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers: polynomials in generators. Normal forms, enclosures, signs.

A generator is kept with the polynomial that defines it, or with the function of which it is a value, and with an
interval that holds it. Every question about a generator is answered from those before it.
"""
from fractions import Fraction
from math import comb

import elementary
import enclosure as e
from polynomial import Polynomial, power_of

PRECISIONS = (64, 256, 1024, 4096)
DEEPEST = 40


class Refused(Exception):
    """A generator, a function or a domain that is not what the document asks for."""


class Open(Exception):
    """A sign that could not be decided."""


class Tower:
    def __init__(self):
        self.rules = []    # (symbol, degree, polynomial): symbol^degree = polynomial, in what comes before it
        self.boxes = {}    # {generator: (bits, interval)}
        self.refine = {}   # {generator: function of bits and of an interval}
        self.signs = {}

    # Normal forms

    def reduce(self, polynomial):
        for symbol, degree, instead in reversed(self.rules):
            parts = polynomial.by_power(symbol)
            if not parts or max(parts) < degree:
                continue
            for power in range(max(parts), degree - 1, -1):
                top = parts.pop(power, None)
                if top:
                    for lower, coefficient in instead.by_power(symbol).items():
                        at = power - degree + lower
                        parts[at] = parts.get(at, Polynomial()) + top * coefficient
            polynomial = Polynomial()
            for power, coefficient in parts.items():
                polynomial = polynomial + (coefficient * Polynomial.symbol(symbol, power) if power else coefficient)
        return polynomial

    # Generators

    def add_root(self, symbol, polynomial, low, high):
        """The one simple root of the polynomial in [low, high]; whether there is one is verified."""
        parts = polynomial.by_power(symbol)
        if not parts or max(parts) == 0 or low >= high:
            raise Refused("no polynomial, or no interval, of a generator")
        degree = max(parts)
        coefficients = [parts.get(k, Polynomial()) for k in range(degree + 1)]
        at_low = self.sign(value(coefficients, low))
        if at_low * self.sign(value(coefficients, high)) != -1 or self.roots(coefficients, low, high, 0) != 1:
            raise Refused("the polynomial of a generator has not one simple root between its bounds")
        leading = coefficients[degree]
        if leading.is_rational():  # else the generator stays in normal forms
            by = Polynomial.constant(-1 / leading.rational())
            rest = Polynomial()
            for k, coefficient in enumerate(coefficients[:-1]):
                rest = rest + coefficient * by * (Polynomial.symbol(symbol, k) if k else Polynomial.constant(1))
            self.rules.append((symbol, degree, rest))
        slopes = [c * Polynomial.constant(k) for k, c in enumerate(coefficients)][1:]
        self.refine[symbol] = lambda bits, box: self.newton(coefficients, slopes, at_low, low, high, bits, box)

    def add_value(self, symbol, function, argument):
        """The value of an elementary function at a number; `pi` has no argument."""
        if function == "log" and self.sign(argument) != 1:
            raise Refused("the logarithm of a number that is not positive")
        if function == "pi":
            self.refine[symbol] = lambda bits, box: elementary.pi(bits)
        else:
            enclose = elementary.FUNCTIONS[function]

            def refined(bits, box):
                inner = self.enclose(argument, bits)
                return enclose(inner, bits) if inner else None
            self.refine[symbol] = refined

    def roots(self, coefficients, low, high, depth):
        """How many roots lie in (low, high), neither of which is one. As many as there are changes of sign among the
        Bernstein coefficients, if that is 0 or 1 (and then the root is simple); else both halves are looked at."""
        n = len(coefficients) - 1
        moved = [Polynomial() for _ in range(n + 1)]  # the coefficients in t, for x = low + (high - low) t
        for k, coefficient in enumerate(coefficients):
            for j in range(k + 1):
                moved[j] = moved[j] + coefficient * Polynomial.constant(comb(k, j) * low ** (k - j) * (high - low) ** j)
        signs = []
        for i in range(n + 1):
            total = Polynomial()
            for j in range(i + 1):
                total = total + moved[j] * Polynomial.constant(Fraction(comb(i, j), comb(n, j)))
            signs.append(self.sign(total))
        signs = [s for s in signs if s]
        changes = sum(a != b for a, b in zip(signs, signs[1:]))
        if changes <= 1:
            return changes
        if depth == DEEPEST:
            raise Refused("roots of the polynomial of a generator that cannot be told apart")
        for part in (Fraction(1, 2), Fraction(3, 8)):
            middle = low + (high - low) * part
            if self.sign(value(coefficients, middle)):
                return self.roots(coefficients, low, middle, depth + 1) + self.roots(coefficients, middle, high, depth + 1)
        raise Refused("two roots of the polynomial of a generator")

    def newton(self, coefficients, slopes, at_low, low, high, bits, box):
        """A small interval about the root: by Newton's step with enclosures, and by halving where that does not help.
        The root is middle - f(middle) / f'(x) for some x in between, by the theorem of the mean."""
        inner = [self.enclose(c, bits) for c in coefficients], [self.enclose(c, bits) for c in slopes]
        box = box or (e.exactly(low, bits)[0], e.exactly(high, bits)[1])
        while box[1] - box[0] > 2:
            width = box[1] - box[0]
            slope = horner(inner[1], box, bits)
            middle = (box[0] + box[1]) >> 1
            at_middle = horner(inner[0], (middle, middle), bits)
            if e.sign(slope):
                step = e.over(at_middle, slope, bits)
                box = e.common(box, e.minus((middle, middle), step))
            elif low < Fraction(middle, 1 << bits) < high and e.sign(at_middle):
                box = (middle, box[1]) if e.sign(at_middle) == at_low else (box[0], middle)
            elif low < Fraction(middle, 1 << bits) < high:
                here = self.reduce(value(coefficients, Fraction(middle, 1 << bits)))
                box = (middle, middle) if not here else box
            if 4 * (box[1] - box[0]) > 3 * width:
                break
        return box

    # Enclosures and signs

    def box(self, symbol, bits):
        known = self.boxes.get(symbol)
        if not known or known[0] < bits:
            start = e.at_precision(known[1], known[0], bits) if known else None
            found = self.refine[symbol](bits, start)
            if found is None:
                raise Open
            self.boxes[symbol] = known = bits, found
        return e.at_precision(known[1], known[0], bits)

    def enclose(self, number, bits):
        total = (0, 0)
        symbols = [(s, self.box(s, bits)) for s in sorted(number.support())]
        for monomial, coefficient in number.terms.items():
            term = (coefficient << bits, coefficient << bits)
            for symbol, box in symbols:
                exponent = power_of(monomial, symbol)
                if exponent:
                    term = e.times(term, e.power(box, exponent, bits), bits)
            total = e.plus(total, term)
        return total[0] // number.under, -(-total[1] // number.under)

    def sign(self, number):
        """1, 0 or -1; raises Open where that could not be seen."""
        if number.is_rational():
            value = number.terms.get(0, 0)
            return (value > 0) - (value < 0)
        key = frozenset(number.terms.items())
        if key not in self.signs:
            self.signs[key] = self.compute_sign(self.reduce(number))
        if self.signs[key] is None:
            raise Open
        return self.signs[key]

    def compute_sign(self, number):
        if number.is_rational():
            value = number.rational()
            return (value > 0) - (value < 0)
        for bits in PRECISIONS:
            try:
                found = e.sign(self.enclose(number, bits))
            except Open:
                continue
            if found:
                return found
        return None


def value(coefficients, at):
    """Of the polynomial with these coefficients, at a rational."""
    total = Polynomial()
    for coefficient in reversed(coefficients):
        total = total * Polynomial.constant(at) + coefficient
    return total


def horner(coefficients, at, bits):
    total = (0, 0)
    for coefficient in reversed(coefficients):
        total = e.plus(e.times(total, at, bits), coefficient)
    return total
