# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of formulas at the point at hand, and at points of a domain."""
from fractions import Fraction

import enclosures as N
from comparing import FALSE, LIKELY, TRUE

SOME = [Fraction(0), Fraction(1), Fraction(1, 3), Fraction(5, 7), Fraction(1, 2)]


class Look:
    """Values of formulas at the point at hand."""

    def __init__(self, truth, point, scope, domain):
        self.truth, self.point, self.scope, self.domain = truth, point, scope, domain

    def at(self, f, u=None, v=None):
        point = self.point
        if u is not None:
            point = {**point, "#1": u, "#2": v if v is not None else Fraction(0)}
        value = self.truth.evaluate(f, point)
        for name in point.keys() - self.point.keys() - {"#1", "#2"}:
            self.point[name] = point[name]
        return value

    def zero(self, fs, u=None, v=None):
        signs = [N.sign(self.at(f, u, v)) for f in fs]
        return FALSE if any(s in (1, -1) for s in signs) else TRUE if all(s == 0 for s in signs) else LIKELY

    def places(self, shape):
        """Points of a domain, corners and sides among them; of the whole plane where there is no shape."""
        rng = self.truth.rng
        if shape in ("curve", "line"):
            return [(x, None) for x in SOME + [Fraction(rng.randint(1, 96), 97) for _ in range(3)]]
        places = [(a, b) for a in SOME for b in SOME if shape != "triangle" or a + b <= 1]
        for _ in range(4):
            a, b = Fraction(rng.randint(1, 96), 97), Fraction(rng.randint(1, 96), 97)
            places.append((a, b) if shape != "triangle" or a + b <= 1 else (1 - a, 1 - b))
        if shape is None:
            places += [(4 * a - 2, 4 * b - 2) for a, b in places[-4:]]
        return places


def all_likely(truths):
    result = LIKELY
    for here in truths:
        result = min(result, here)
        if result == FALSE:
            break
    return result
