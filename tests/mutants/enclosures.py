# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers for evaluation: Fractions where they are exact and short, else intervals with ends in multiples of 2^-BITS, rounded outwards."""
import functools
from fractions import Fraction
from math import isqrt

BITS = 320
ONE = 1 << BITS
SHORT = 2000  # bits of a numerator or denominator that stays a Fraction


class Undefined(Exception):
    """A quotient by what may be 0, a root of what may be negative."""


class Nothing(Undefined):
    """What certainly has no value."""


class Interval:
    __slots__ = ("low", "high")

    def __init__(self, low, high):
        self.low, self.high = low, high

    def __repr__(self):
        return "%.15g±%.1e" % (((self.low + self.high) >> 1) / ONE, (self.high - self.low) / ONE)


def interval(x):
    if isinstance(x, Interval):
        return x
    return Interval((x.numerator << BITS) // x.denominator, -((-x.numerator << BITS) // x.denominator))


def shortened(x):
    if x.numerator.bit_length() + x.denominator.bit_length() > SHORT:
        return interval(x)
    return x


def plus(a, b):
    if isinstance(a, Fraction) and isinstance(b, Fraction):
        return shortened(a + b)
    a, b = interval(a), interval(b)
    return Interval(a.low + b.low, a.high + b.high)


def minus(a):
    return -a if isinstance(a, Fraction) else Interval(-a.high, -a.low)


def times(a, b):
    if isinstance(a, Fraction) and isinstance(b, Fraction):
        return shortened(a * b)
    if a == 0 or b == 0:
        return Fraction(0)
    a, b = interval(a), interval(b)
    products = (a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high)
    return Interval(min(products) >> BITS, -(-max(products) >> BITS))


def inverse(a):
    if isinstance(a, Fraction):
        if a == 0:
            raise Nothing("a quotient by 0")
        return 1 / a
    if a.low <= 0 <= a.high:
        raise Undefined("a quotient by what may be 0")
    return Interval(ONE * ONE // a.high, -(-ONE * ONE // a.low))


def power(a, n):
    if n < 0:
        return inverse(power(a, -n))
    result = Fraction(1)
    while n:
        if n & 1:
            result = times(result, a)
        n >>= 1
        if n:
            a = square(a)
    return result


def square(a):
    if isinstance(a, Fraction):
        return shortened(a * a)
    low, high = a.low * a.low, a.high * a.high
    if a.low <= 0 <= a.high:
        return Interval(0, -(-max(low, high) >> BITS))
    return Interval(min(low, high) >> BITS, -(-max(low, high) >> BITS))


def root(a, n=2):
    if isinstance(a, Fraction):
        if a < 0 and n % 2 == 0:
            raise Nothing("an even root of a negative number")
        exact = [exact_root(x, n) for x in (abs(a.numerator), a.denominator)]
        if None not in exact:
            return Fraction(exact[0] if a >= 0 else -exact[0], exact[1])
        a = interval(a)
    if n % 2 == 0 and a.high < 0:
        raise Nothing("an even root of a negative number")
    low = a.low if n % 2 else max(a.low, 0)

    def bound(x, up):
        r = floor_root(abs(x) << (BITS * (n - 1)), n)
        return (r + 1 if up == (x >= 0) else r) * (1 if x >= 0 else -1)
    return Interval(bound(low, False), bound(a.high, True))


def floor_root(x, n):
    if n == 2:
        return isqrt(x)
    low, high = 0, 1 << (x.bit_length() // n + 1)
    while low < high:
        middle = (low + high + 1) >> 1
        low, high = (middle, high) if middle ** n <= x else (low, middle - 1)
    return low


def exact_root(x, n):
    if x.bit_length() > SHORT:
        return None
    r = floor_root(x, n)
    return r if r ** n == x else None


def absolute(a):
    if isinstance(a, Fraction):
        return abs(a)
    if a.low >= 0:
        return a
    if a.high <= 0:
        return minus(a)
    return Interval(0, max(-a.low, a.high))


def larger(a, b):
    if isinstance(a, Fraction) and isinstance(b, Fraction):
        return max(a, b)
    a, b = interval(a), interval(b)
    return Interval(max(a.low, b.low), max(a.high, b.high))


def elementary(name, a):
    if name == "pi":
        return outward(half_pi() * 2)
    if isinstance(a, Fraction) and a == 0 and name in ("sin", "cos", "exp"):
        return Fraction(0 if name == "sin" else 1)
    if isinstance(a, Fraction) and a == 1 and name == "log":
        return Fraction(0)
    a = interval(a)
    low, high = a.low << GUARD, a.high << GUARD
    if name == "log" and a.high <= 0:
        raise Nothing("a logarithm of what is not positive")
    if name == "log" and a.low <= 0:
        raise Undefined("a logarithm of what may not be positive")
    if name in ("exp", "log"):
        if name == "exp" and max(abs(low), abs(high)) > WORK << 12:
            raise Undefined("an exponential too large for this evaluator")
        f = exp if name == "exp" else log
        return Interval(outward(f(low)).low, outward(f(high)).high)
    middle = (low + high) >> 1
    value = outward(cos(middle if name == "cos" else middle - half_pi()))
    width = a.high - a.low + 1  # both functions have slopes of at most 1
    return Interval(value.low - width, value.high + width)


# ---- with GUARD more bits, whose errors the margin of `outward` covers many times over

GUARD = 192
WORK = 1 << (BITS + GUARD)


def outward(x):
    margin = 4 + (abs(x) >> (BITS + GUARD - 8))
    return Interval((x >> GUARD) - margin, (x >> GUARD) + 1 + margin)


def series(x, first, step):
    """first + first*x/step(1) + first*x*x/(step(1)*step(2)) + …, for small x."""
    result, term, n = first, first, 1
    while term:
        term = (term * x >> (BITS + GUARD)) // step(n)
        if term == -1:
            break
        result += term
        n += 1
    return result


def exp(x):
    halvings = max(0, abs(x).bit_length() - (BITS + GUARD)) + 8
    result = series(x >> halvings, WORK, lambda n: n)
    for _ in range(halvings):
        result = result * result >> (BITS + GUARD)
    return result


def log(x):
    shift = x.bit_length() - (BITS + GUARD)
    x = x >> shift if shift > 0 else x << -shift  # 1/2 <= x < 1
    return shift * log_two() + log_near(x)


def log_near(x):
    """2 artanh((x - 1)/(x + 1))"""
    z = ((x - WORK) << (BITS + GUARD)) // (x + WORK)
    square, power, result, n = z * z >> (BITS + GUARD), z, 0, 1
    while power not in (0, -1):
        result += power // n
        power = power * square >> (BITS + GUARD)
        n += 2
    return 2 * result


@functools.lru_cache(None)
def log_two():
    return -log_near(WORK >> 1)


@functools.lru_cache(None)
def half_pi():
    def arctan_of_inverse(k):
        power, result, n = WORK // k, 0, 1
        while power:
            result += power // n if n % 4 == 1 else -(power // n)
            power //= k * k
            n += 2
        return result
    return 2 * (4 * arctan_of_inverse(5) - arctan_of_inverse(239))


def cos(x):
    x %= 4 * half_pi()
    x = (x + 2 * half_pi()) % (4 * half_pi()) - 2 * half_pi()
    halvings = 10
    x >>= halvings
    result = series(-(x * x >> (BITS + GUARD)), WORK, lambda n: (2 * n - 1) * 2 * n)
    for _ in range(halvings):
        result = (2 * result * result >> (BITS + GUARD)) - WORK
    return result


def sign(a):
    """1 or -1: certainly; 0: exactly 0; None: too near to 0 to say."""
    if isinstance(a, Fraction):
        return (a > 0) - (a < 0)
    if a.low > 0:
        return 1
    if a.high < 0:
        return -1
    return None


def is_narrow(a):
    return isinstance(a, Fraction) or a.high - a.low < ONE >> 60


def to_float(a):
    return float(a) if isinstance(a, Fraction) else ((a.low + a.high) >> 1) / ONE
