# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of patches along a side, looked at in points."""
import math
from fractions import Fraction

import enclosures as N
import extrema
import formulas as F
import values as W
from comparing import FALSE, LIKELY, TRUE, UNLIKELY
from looking import SOME, all_likely
from meaning import as_integer
from values import Surface, Unsupported


def contact(order):
    def state(look, *arguments):
        n = order if order is not None else as_integer(arguments[0])
        rest = arguments if order is not None else arguments[1:]
        if len(rest) == 1 and isinstance(rest[0], Surface):
            return surface_contact(look, n, rest[0])
        p, q = rest
        if p.shape == "curve" or n > 2:
            raise Unsupported("G(k) of curves, or of order 3")
        return pair_contact(look, n, p, q)
    return state


def pair_contact(look, order, p, q):
    names = sorted(frozenset().union(*[f.has for f in W.flat(p) + W.flat(q)]) - {"#1", "#2"})
    for name in names:
        look.at(F.var(name))
    point = {name: N.to_float(look.point[name]) for name in names}
    for side in W.BOUNDARY[p.shape]:
        for other in W.BOUNDARY[q.shape]:
            for turned in (other, other[::-1]):
                if all(W.key(W.float_point(p, W.on_side(side, x), point)) == W.key(W.float_point(q, W.on_side(turned, x), point))
                       for x in (0, 1 / 5, 1 / 2, 1)):
                    return along(look, order, p, side, q, turned)
    return UNLIKELY


def along(look, order, p, side, q, other):
    truths = []
    forms = [Forms(look, p, side), Forms(look, q, other)]
    for x in SOME:
        a, b = forms[0].at(x), forms[1].at(x)
        truths.append(min(look_zero(N.plus(s, N.minus(r))) for s, r in zip(a.point, b.point)))
        if order >= 1:
            truths += [-zero_vector(a.normal), -zero_vector(b.normal), zero_vector(cross(a.normal, b.normal)), opposite(a, b)]
        if order >= 2:
            truths.append(equal_curvature(a, b))
    return all_likely(truths)


def look_zero(x):
    s = N.sign(x)
    return TRUE if s == 0 else LIKELY if s is None else FALSE


def zero_vector(v):
    return min(look_zero(x) for x in v)


def cross(a, b):
    return [N.plus(N.times(a[(i + 1) % 3], b[(i + 2) % 3]), N.minus(N.times(a[(i + 2) % 3], b[(i + 1) % 3]))) for i in range(3)]


def dot(a, b):
    result = Fraction(0)
    for x, y in zip(a, b):
        result = N.plus(result, N.times(x, y))
    return result


class Local:
    pass


class Forms:
    """Point, normal, tangents and second fundamental form of a patch along a side: in directions along it and into the patch."""

    def __init__(self, look, p, side):
        self.look, self.side = look, side
        d = {(i, j): W.derivative(W.derivative(p.value, "#1", i), "#2", j) for i in range(3) for j in range(3) if i + j <= 2}
        self.d, self.normal = d, W.cross(d[1, 0], d[0, 1])
        (a, b), (c, e) = side
        centre = (Fraction(1, 3), Fraction(1, 3)) if p.shape == "triangle" else (Fraction(1, 2), Fraction(1, 2))
        self.direction = (c - a, e - b)
        self.centre = centre

    def at(self, x):
        u, v = (Fraction(y) for y in W.on_side(self.side, x))
        value = lambda fs: [self.look.at(f, u, v) for f in fs]
        s, r = self.direction, (self.centre[0] - u, self.centre[1] - v)
        d = {k: value(f) for k, f in self.d.items()}
        local = Local()
        local.point, local.normal = d[0, 0], value(self.normal)
        first = lambda w: [N.plus(N.times(Fraction(w[0]), a), N.times(Fraction(w[1]), b)) for a, b in zip(d[1, 0], d[0, 1])]

        def second(w, z):
            h = [dot(d[k], local.normal) for k in ((2, 0), (1, 1), (0, 2))]
            return N.plus(N.plus(N.times(Fraction(w[0] * z[0]), h[0]), N.times(Fraction(w[0] * z[1] + w[1] * z[0]), h[1])), N.times(Fraction(w[1] * z[1]), h[2]))
        local.along, local.inward = first(s), first(r)
        local.second = (second(s, s), second(s, r), second(r, r))
        return local


def opposite(a, b):
    """The patches leave on opposite sides of the common curve."""
    side = dot(cross(a.along, a.inward), cross(b.along, b.inward))
    s = N.sign(side)
    return TRUE if s == -1 else FALSE if s == 1 else UNLIKELY


def equal_curvature(a, b):
    """b.inward = x a.along + y a.inward; the forms, over the lengths of their normals, agree in these directions."""
    n = cross(a.along, a.inward)
    nn = dot(n, n)
    x = N.times(dot(cross(b.inward, a.inward), n), N.inverse(nn))
    y = N.times(dot(cross(a.along, b.inward), n), N.inverse(nn))
    la, lb = N.root(dot(a.normal, a.normal)), N.root(dot(b.normal, b.normal))
    turned = N.sign(dot(a.normal, b.normal))
    k = N.times(Fraction(turned or 0), N.times(la, N.inverse(lb)))
    mixed = N.plus(N.times(x, a.second[0]), N.times(y, a.second[1]))
    inward = N.plus(N.plus(N.times(N.square(x), a.second[0]), N.times(Fraction(2), N.times(N.times(x, y), a.second[1]))), N.times(N.square(y), a.second[2]))
    wanted = (a.second[0], mixed, inward)
    return min(look_zero(N.plus(w, N.minus(N.times(k, s)))) for w, s in zip(wanted, b.second))


def surface_contact(look, order, surface):
    if any(f.has - {"#1", "#2"} for p in surface.patches for f in p.value):
        raise Unsupported("a surface with parameters")
    found = extrema.sides(surface)
    truths = [winding(look, surface)]
    for on in found.values():
        if len(on) > 2:
            return FALSE
        if len(on) == 2 and (not surface.is_orbit or 0 in (on[0][0], on[1][0])):
            (i, _), (j, _) = on
            truths.append(pair_contact(look, order, surface.patches[i], surface.patches[j]))
    return all_likely(truths)


def winding(look, surface):
    """At each corner the patches go round once: their angles add up to a full turn."""
    angles = {}
    for k, p in enumerate(surface.patches):
        d = [W.derivative(p.value, x) for x in ("#1", "#2")]
        corners = {uv for side in W.BOUNDARY[p.shape] for uv in side}
        for u, v in corners:
            others = [b if a == (u, v) else a for a, b in W.BOUNDARY[p.shape] if (u, v) in (a, b)]
            at = {"#1": float(u), "#2": float(v)}
            first, second = (W.floats(x, at) for x in d)
            directions = [[(o[0] - u) * a + (o[1] - v) * b for a, b in zip(first, second)] for o in others]
            x, y = directions
            lengths = math.sqrt(sum(c * c for c in x) * sum(c * c for c in y))
            if lengths < 1e-9:
                return UNLIKELY
            angle = math.acos(max(-1.0, min(1.0, sum(a * b for a, b in zip(x, y)) / lengths)))
            angles.setdefault(W.key(W.float_point(p, (u, v))), []).append(angle)
    sides = extrema.sides(surface)
    if any(len(on) != 2 for on in sides.values()):
        raise Unsupported("a surface with a boundary")
    return LIKELY if all(abs(sum(a) - 2 * math.pi) < 1e-6 for a in angles.values()) else UNLIKELY
