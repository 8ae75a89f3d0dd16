# SPDX-License-Identifier: GPL-3.0-or-later
"""How sure a comparison is.

A truth is a number: 2 and -2 are certain, 1 and -1 are what points suggest (an equality of enclosures that meet, a statement for all
points that none of them contradicts), 0 is unknown. `and` is the least, `or` the largest, `not` the opposite."""
from decimal import Decimal
from fractions import Fraction

import enclosures as N
from values import Unsupported

TRUE, LIKELY, UNKNOWN, UNLIKELY, FALSE = 2, 1, 0, -1, -2


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
