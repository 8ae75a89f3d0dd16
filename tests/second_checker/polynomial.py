# SPDX-License-Identifier: GPL-3.0-or-later
"""Polynomials with rational coefficients in numbered symbols.

A monomial is one integer: the exponent of symbol s stands in its bits [s * BITS, (s + 1) * BITS), so a product of
monomials is a sum of integers. That no exponent runs over into the next is seen from a bound of the degree, which
every polynomial carries.
"""
from fractions import Fraction
from math import comb, gcd, lcm

BITS = 16
FIELD = (1 << BITS) - 1


class NotJudged(Exception):
    """What this checker does not know, or does not want to spend the time on: no verdict, in no case 'valid'."""


class Effort:
    """Counts products of terms, so that a big certificate is given up at the same place on every machine."""
    left = 0

    @classmethod
    def spend(cls, amount):
        cls.left -= amount
        if cls.left < 0:
            raise NotJudged("too big")


def fields(symbols):
    """The bits of all exponents of these symbols."""
    mask = 0
    for symbol in symbols:
        mask |= FIELD << (symbol * BITS)
    return mask


def power_of(monomial, symbol):
    return (monomial >> (symbol * BITS)) & FIELD


def degree_of(monomial):
    degree = 0
    while monomial:
        degree += monomial & FIELD
        monomial >>= BITS
    return degree


class Polynomial:
    """`terms` {monomial: integer, not 0}, over one `under` >= 1 with which they have no common divisor."""
    __slots__ = ("terms", "degree", "under")

    def __init__(self, terms=None, degree=0, under=1):
        self.terms = terms if terms is not None else {}
        self.degree = degree  # not less than the true degree
        if degree > FIELD:
            raise NotJudged("a degree beyond all bounds")
        if under != 1:
            common = gcd(under, *self.terms.values())
            if common != 1:
                under //= common
                self.terms = {m: c // common for m, c in self.terms.items()}
        self.under = under

    @staticmethod
    def constant(value):
        value = Fraction(value)
        return Polynomial({0: value.numerator} if value else {}, 0, value.denominator)

    @staticmethod
    def symbol(number, power=1):
        return Polynomial({power << (number * BITS): 1}, power)

    def __add__(self, other):
        Effort.spend(len(self.terms) + len(other.terms))
        under = lcm(self.under, other.under)
        mine, others = under // self.under, under // other.under
        terms = {m: c * mine for m, c in self.terms.items()} if mine != 1 else dict(self.terms)
        for monomial, coefficient in other.terms.items():
            value = terms.get(monomial, 0) + coefficient * others
            if value:
                terms[monomial] = value
            else:
                del terms[monomial]
        return Polynomial(terms, max(self.degree, other.degree), under)

    def __neg__(self):
        return Polynomial({m: -c for m, c in self.terms.items()}, self.degree, self.under)

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        Effort.spend(len(self.terms) * len(other.terms))
        terms = {}
        for a, x in self.terms.items():
            for b, y in other.terms.items():
                terms[a + b] = terms.get(a + b, 0) + x * y
        return Polynomial({m: c for m, c in terms.items() if c}, self.degree + other.degree, self.under * other.under)

    def __pow__(self, exponent):
        if exponent * max(self.degree, 1) > FIELD and len(self.terms) > 0:
            raise NotJudged("a power beyond all bounds")
        result, base = Polynomial.constant(1), self
        while exponent:
            if exponent & 1:
                result = result * base
            exponent >>= 1
            if exponent:
                base = base * base
        return result

    def __bool__(self):
        return bool(self.terms)

    def __eq__(self, other):
        return self.terms == other.terms and self.under == other.under

    def is_rational(self):
        return all(m == 0 for m in self.terms)

    def rational(self):
        return Fraction(self.terms.get(0, 0), self.under)

    def support(self):
        """The symbols that stand in it."""
        bits = 0
        for monomial in self.terms:
            bits |= monomial
        return {s for s in range((bits.bit_length() + BITS - 1) // BITS) if power_of(bits, s)}

    def by_power(self, symbol):
        """{e: coefficient of symbol^e}"""
        Effort.spend(len(self.terms))
        shift = symbol * BITS
        parts = {}
        for m, c in self.terms.items():
            e = (m >> shift) & FIELD
            parts.setdefault(e, {})[m - (e << shift)] = c
        return {e: Polynomial(terms, self.degree, self.under) for e, terms in parts.items()}

    def by_monomial(self, symbols):
        """{monomial in these symbols: its coefficient}"""
        Effort.spend(len(self.terms))
        mask = fields(symbols)
        parts = {}
        for m, c in self.terms.items():
            parts.setdefault(m & mask, {})[m & ~mask] = c
        return {m: Polynomial(terms, self.degree, self.under) for m, terms in parts.items()}

    def replace(self, values):
        """Polynomials in the place of symbols, all at once: {symbol: polynomial}"""
        powers = {}
        result = Polynomial()
        for monomial, coefficient in self.by_monomial(values).items():
            for symbol, value in values.items():
                e = power_of(monomial, symbol)
                if e:
                    if (symbol, e) not in powers:
                        powers[symbol, e] = value ** e
                    coefficient = coefficient * powers[symbol, e]
            result = result + coefficient
        return result

    def shift(self, symbol, weight, other):
        """symbol := symbol + weight * other, for a polynomial weight"""
        result, grown = Polynomial(), Polynomial.symbol(other) * weight
        for e, coefficient in self.by_power(symbol).items():
            power = Polynomial.constant(1)
            for k in range(e + 1):
                keep = Polynomial.symbol(symbol, e - k) if e > k else Polynomial.constant(1)
                result = result + coefficient * keep * power * Polynomial.constant(comb(e, k))
                power = power * grown
        return result

    def derivative(self, symbol):
        unit = 1 << (symbol * BITS)
        return Polynomial({m - unit: c * power_of(m, symbol) for m, c in self.terms.items() if power_of(m, symbol)},
                          self.degree, self.under)

    def cleared(self):
        """A positive multiple with integers as coefficients."""
        return Polynomial(self.terms, self.degree)
