# SPDX-License-Identifier: GPL-3.0-or-later
"""Enclosures of exp, log, sin, cos and the number pi, by series whose remainder is known.

Each works with GUARD more bits than asked for. A series is summed until its next term is below one unit; the
remainder is then below two units, since each term that follows is at most half of the one before.
"""
from enclosure import at_precision, minus, over, plus, times

GUARD = 32


def series(x, step, bits):
    """1 + x / step(1) + x^2 / (step(1) step(2)) + …, for |x| <= 1 and step(n) >= 2 from n = 2 on"""
    one = (1 << bits, 1 << bits)
    total, term, n = one, one, 0
    while n < 2 or max(abs(term[0]), abs(term[1])) > 1:
        n += 1
        term = times(term, x, bits)
        term = term[0] // step(n), -(-term[1] // step(n))
        total = plus(total, term)
    return total[0] - 4, total[1] + 4


def exp_at(x, bits):
    """exp of a number x / 2^bits; exp(x) = exp(x / 2^k)^(2^k)"""
    halvings = max(0, abs(x).bit_length() - bits) + 8
    work = bits + GUARD + 2 * halvings + max(0, 2 * (x >> bits))
    result = series(at_precision((x, x), bits + halvings, work), lambda n: n, work)
    for _ in range(halvings):
        result = times(result, result, work)
    return at_precision(result, work, bits)


def exp(x, bits):
    if max(abs(x[0]), abs(x[1])) >> bits > 1000:
        return None
    return max(0, exp_at(x[0], bits)[0]), exp_at(x[1], bits)[1]


def artanh(x, bits):
    """x + x^3 / 3 + x^5 / 5 + …, for |x| <= 1/2"""
    square, term, total, n = times(x, x, bits), x, x, 1
    while max(abs(term[0]), abs(term[1])) > 1:
        term = times(term, square, bits)
        n += 2
        total = plus(total, (term[0] // n, -(-term[1] // n)))
    return total[0] - 4, total[1] + 4


def log_at(y, bits):
    """log of a number y / 2^bits > 0: y = m 2^k with m in [1/2, 1), log m = 2 artanh((m - 1) / (m + 1))"""
    work = bits + GUARD
    k = y.bit_length() - bits
    one = (1 << work, 1 << work)
    m = at_precision((y, y), bits + k, work)
    part = artanh(over(minus(m, one), plus(m, one), work), work)
    two = artanh(over(one, plus(one, plus(one, one)), work), work)  # log 2 = 2 artanh(1/3)
    many = sorted((2 * k * two[0], 2 * k * two[1]))
    total = plus((2 * part[0], 2 * part[1]), many)
    return at_precision(total, work, bits)


def log(x, bits):
    if x[0] <= 0:
        return None
    return log_at(x[0], bits)[0], log_at(x[1], bits)[1]


def wave(x, bits, odd):
    """sin or cos of a number x / 2^bits, from those of x / 2^k by doubling; both have the derivative at most 1"""
    middle, radius = (x[0] + x[1]) >> 1, (x[1] - x[0] + 2) >> 1
    halvings = max(0, abs(middle).bit_length() - bits) + 4
    if halvings > 64:
        return None
    work = bits + GUARD + 4 * halvings
    small = at_precision((middle, middle), bits + halvings, work)
    square = times(small, small, work)
    square = -square[1], -square[0]
    cosine = series(square, lambda n: 2 * n * (2 * n - 1), work)
    sine = times(small, series(square, lambda n: 2 * n * (2 * n + 1), work), work)
    one = (1 << work, 1 << work)
    for _ in range(halvings):
        product, of_sine = times(sine, cosine, work), times(sine, sine, work)
        sine = 2 * product[0], 2 * product[1]
        cosine = minus(one, (2 * of_sine[0], 2 * of_sine[1]))
    result = at_precision(sine if odd else cosine, work, bits)
    return max(result[0] - radius, -1 << bits), min(result[1] + radius, 1 << bits)


def sin(x, bits):
    return wave(x, bits, True)


def cos(x, bits):
    return wave(x, bits, False)


def pi(bits):
    """Machin: pi = 16 arctan(1/5) - 4 arctan(1/239), alternating series"""
    work = bits + GUARD

    def arctan_of_inverse(n):
        term, total, k = (1 << work) // n, 0, 0
        while term:
            total += (-1) ** k * (term // (2 * k + 1))
            term //= n * n
            k += 1
        return total - 2 * k - 2, total + 2 * k + 2  # each term was rounded down twice, by less than 1 each

    a, b = arctan_of_inverse(5), arctan_of_inverse(239)
    return at_precision((16 * a[0] - 4 * b[1], 16 * a[1] - 4 * b[0]), work, bits)


FUNCTIONS = {"exp": exp, "log": log, "sin": sin, "cos": cos}
