# SPDX-License-Identifier: GPL-3.0-or-later
"""Extrema, found in floating point: an enclosure that is believed, not proven. And what is counted on surfaces."""
import random

import enclosures as N
import floats
import formulas as F
import values as W
from values import Function, Unsupported

MARGIN = 1e-9


class OnSurface:
    def __init__(self, surface, function):
        self.surface, self.function = surface, function


def known(x):
    n = int(x * 2 ** 60) << (N.BITS - 60)
    margin = int((1 + abs(x)) * MARGIN * 2 ** 60) << (N.BITS - 60)
    return F.make("known", N.Interval(n - margin, n + margin))


def largest(f, shape, n=24):
    """Of a function of two numbers on the triangle or square, or of one on [0,1]."""
    def inside(u, v):
        u = min(max(u, 0.0), 1.0)
        v = min(max(v, 0.0), 1.0)
        if shape == "triangle" and u + v > 1:
            excess = (u + v - 1) / 2
            u, v = max(u - excess, 0.0), max(v - excess, 0.0)
            v = min(v, 1 - u)
        return u, v

    def at(u, v):
        try:
            return f(u, v)
        except (ZeroDivisionError, ValueError, OverflowError):
            return -float("inf")
    grid = [(i / n, j / n) for i in range(n + 1) for j in range(n + 1) if shape == "square" or i + j <= n]
    if shape == "line":
        grid = [(i / 200, 0.0) for i in range(201)]
    ranked = sorted(((at(u, v), u, v) for u, v in grid), reverse=True)[:8]
    best = ranked[0][0]
    for value, u, v in ranked:
        step = 1.0 / n
        while step > 1e-10:
            moved = False
            for du, dv in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, -1), (-1, 1), (1, 1), (-1, -1)):
                p = inside(u + du * step, v + dv * step)
                if shape == "line":
                    p = (p[0], 0.0)
                x = at(*p)
                if x > value:
                    value, (u, v), moved = x, p, True
            if not moved:
                step /= 2
        best = max(best, value)
    if best == -float("inf"):
        raise Unsupported("an extremum of what is not defined")
    return best


def of(name, f):
    if isinstance(f, OnSurface):
        s = f.surface
        patches = s.patches[:1] if s.is_orbit else s.patches
        values = [of(name, Function(2, f.function(p), p.shape)) for p in patches]
        if len(values) > 1:
            raise Unsupported("an extremum over several patches")
        return values[0]
    if not isinstance(f.value, F.Formula) or f.value.has - {"#1", "#2"}:
        raise Unsupported("an extremum with parameters")
    sign = 1 if name == "max" else -1
    shape = {"quad": "square", "curve": "line"}.get(f.shape, f.shape or "square")
    at = floats.compiled(f.value, ("#1", "#2"))
    return known(sign * largest(lambda u, v: sign * at(u, v), shape))


def over(m, name, each, scope):
    """max(E for (u,v) in triangle), max(E for u in [0,1], v in [0,1])"""
    _, body, bindings = each
    names = [n for b in bindings for n in b[0]]
    value = m.scalar(body, {**scope, **{n: F.var("#" + str(i + 1)) for i, n in enumerate(names)}})
    domains = [b[1] for b in bindings]
    if domains == [("name", "triangle")] and len(names) == 2:
        return of(name, Function(2, value, "triangle"))
    if domains == [("name", "square")] and len(names) == 2:
        return of(name, Function(2, value, "square"))
    if all(d and d[0] == "interval" for d in domains) and len(names) == len(domains) <= 2:
        ends = [(m.scalar(d[2], scope), m.scalar(d[3], scope)) for d in domains]
        names = {"#%d" % (i + 1): F.add(a, F.mul(F.sub(b, a), F.var("#%d" % (i + 1)))) for i, (a, b) in enumerate(ends)}
        return of(name, Function(2, F.substitute(value, names), "line" if len(ends) == 1 else "square"))
    raise Unsupported("an extremum over another set")


def sides(surface):
    found = {}
    for k, p in enumerate(surface.patches):
        for side in W.BOUNDARY[p.shape]:
            found.setdefault(W.side_key(p, side), []).append((k, side))
    return found


def seams(surface):
    return [key for key, on in sides(surface).items() if len(on) == 2]


def corners(surface):
    return {W.key(W.float_point(p, end)) for p in surface.patches for side in W.BOUNDARY[p.shape] for end in side}


def random_points(shape, count, seed):
    rng = random.Random(seed)
    for _ in range(count):
        u, v = rng.random(), rng.random()
        yield (u, v) if shape != "triangle" or u + v <= 1 else (1 - u, 1 - v)
