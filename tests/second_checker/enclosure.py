# SPDX-License-Identifier: GPL-3.0-or-later
"""Intervals (low, high) of integers, which stand for [low / 2^bits, high / 2^bits]; always rounded outward."""


def exactly(value, bits):
    """Of a rational."""
    scaled = value.numerator << bits
    return scaled // value.denominator, -(-scaled // value.denominator)


def plus(a, b):
    return a[0] + b[0], a[1] + b[1]


def minus(a, b):
    return a[0] - b[1], a[1] - b[0]


def times(a, b, bits):
    products = (a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1])
    return min(products) >> bits, -(-max(products) >> bits)


def over(a, b, bits):
    """a / b, for b without 0"""
    ends = [(x << bits, y) for x in a for y in b]
    return min(x // y for x, y in ends), max(-(-x // y) for x, y in ends)


def power(a, exponent, bits):
    result = (1 << bits, 1 << bits)
    for _ in range(exponent):
        result = times(result, a, bits)
    return result


def common(a, b):
    """Of two intervals that hold one number."""
    return max(a[0], b[0]), min(a[1], b[1])


def sign(a):
    """1, -1, or 0 for: not known"""
    return 1 if a[0] > 0 else -1 if a[1] < 0 else 0


def at_precision(a, old, new):
    if new >= old:
        return a[0] << (new - old), a[1] << (new - old)
    return a[0] >> (old - new), -(-a[1] >> (old - new))
