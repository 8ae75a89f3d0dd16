# SPDX-License-Identifier: GPL-3.0-or-later
"""The predicates of the language, looked at in points: what a predicate says of all points is at most likely."""
import math
from fractions import Fraction

import enclosures as N
import extrema
import formulas as F
import solids
import values as W
from meaning import PARAMETERS, Closure, as_integer
from values import Function, Items, Matrix, Mesh, Patch, Surface, Unsupported, Vector

TRUE, LIKELY, UNLIKELY, FALSE = 2, 1, -1, -2
SOME = [Fraction(0), Fraction(1), Fraction(1, 3), Fraction(5, 7), Fraction(1, 2)]


def holds(t, name, trees, scope, point):
    if name == "pregeodesic":
        return pregeodesic(t, trees, scope, point)
    domain = None
    if name == "nonnegative" and len(trees) > 1:
        domain, trees = trees[1], trees[:1]
    arguments = [t.meaning.value(a, scope) for a in trees]
    f = TABLE.get(name)
    if not f:
        raise Unsupported("the predicate " + name)
    try:
        return f(Look(t, point, scope, domain), *arguments)
    except (TypeError, AttributeError, IndexError, KeyError) as error:
        raise Unsupported("%s of these arguments: %s" % (name, error))


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


def regular(look, p):
    p = look.truth.meaning.function(p)
    normal = W.normal(p)
    return all_likely(-look.zero(normal, u, v) for u, v in look.places(p.shape))


def ruled(look, y):
    y = look.truth.meaning.function(y)
    return max(all_likely(look.zero(W.derivative(y.value, x, 2), u, v) for u, v in look.places(y.shape)) for x in ("#1", "#2"))


def developable(look, y):
    y = look.truth.meaning.function(y)
    d = {(i, j): W.derivative(W.derivative(y.value, "#1", i), "#2", j) for i in range(3) for j in range(3) if i + j <= 2}
    n = W.cross(d[1, 0], d[0, 1])
    flat = F.sub(F.mul(W.dot(d[2, 0], n), W.dot(d[0, 2], n)), F.power(W.dot(d[1, 1], n), 2))
    places = look.places(y.shape)
    somewhere = max(-look.zero(n, u, v) for u, v in places)
    return min(all_likely(look.zero([flat], u, v) for u, v in places), somewhere)


def cylindrical(look, y):
    y = look.truth.meaning.function(y)
    results = []
    for x, other in (("#1", "#2"), ("#2", "#1")):
        ruling = W.derivative(y.value, x)
        moved = [F.substitute(f, {other: F.const(Fraction(2, 7)), x: F.const(Fraction(1, 9))}) for f in ruling]
        straight = all_likely(look.zero(W.derivative(ruling, x), u, v) for u, v in look.places(y.shape))
        parallel = all_likely(look.zero(W.cross(ruling, Vector(moved)), u, v) for u, v in look.places(y.shape))
        some = max(-look.zero(ruling, u, v) for u, v in look.places(y.shape))
        results.append(min(straight, parallel, some))
    return max(results)


def pregeodesic(t, trees, scope, point):
    if len(trees) != 3 or trees[2][0] != "named" or trees[2][1] not in PARAMETERS:
        raise Unsupported("pregeodesic")
    look = Look(t, point, scope, None)
    curve, patch = (t.meaning.function(t.meaning.value(x, scope)) for x in trees[:2])
    first = PARAMETERS[trees[2][1]]
    value = t.meaning.scalar(trees[2][2], scope)
    if curve.arity != 1 or patch.arity != 2:
        raise Unsupported("pregeodesic of these")
    along = {("#1", "#2")[first]: value, ("#1", "#2")[1 - first]: W.U}

    def on_curve(v):
        return Vector(F.substitute(f, along) for f in v)
    binormal = W.cross(W.derivative(curve.value, "#1"), W.derivative(curve.value, "#1", 2))
    normal = on_curve(W.normal(patch))
    apart = [F.sub(a, b) for a, b in zip(on_curve(patch.value), curve.value)]
    truths = []
    for x, _ in look.places("curve"):
        truths += [look.zero(apart, x), -look.zero(binormal, x), -look.zero(normal, x), look.zero([W.dot(normal, binormal)], x)]
    return all_likely(truths)


# ---- contact

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


def closed(look, thing):
    if isinstance(thing, Mesh):
        return count_truth(solids.is_closed(thing))
    found = extrema.sides(thing)
    if any(len(on) != 2 for on in found.values()):
        return UNLIKELY
    seen, todo = {0}, [0]
    while todo:
        k = todo.pop()
        for on in found.values():
            patches = {i for i, _ in on}
            if k in patches:
                todo += patches - seen
                seen |= patches
    return LIKELY if len(seen) == len(thing.patches) else UNLIKELY


def interpolates(look, surface, points):
    places = {W.key(W.float_point(p, uv)) for p in surface.patches
              for uv in [e for side in W.BOUNDARY[p.shape] for e in side] + W.INSIDE[p.shape]
              + [W.on_side(side, 1 / 2) for side in W.BOUNDARY[p.shape]]}
    return LIKELY if all(W.key(W.floats(x)) in places for x in points) else UNLIKELY


# ---- continuity of functions, curves, patches

def continuity(look, order, *rest):
    k = as_integer(order)
    functions = look.truth.meaning.function
    if len(rest) == 1:
        fs = [functions(f) if not isinstance(f, F.Formula) else Function(1, F.substitute(f, {"u": W.U})) for f in rest[0]]
        truths = []
        for n in range(k + 1):
            d = [F.total([W.derivative(f.value, "#1", n)]) for f in fs]
            truths += [look.zero([d[0]], Fraction(1)), look.zero([d[-1]], Fraction(0))]
            truths += [look.zero([F.sub(F.substitute(a, {"#1": F.ZERO}), F.substitute(b, {"#1": F.ONE}))]) for a, b in zip(d, d[1:])]
        return min(truths)
    x, y = (functions(f) for f in rest)
    if x.shape == "curve":
        return min(look.zero([F.sub(F.substitute(a, {"#1": F.ONE}), F.substitute(b, {"#1": F.ZERO})) for a, b in
                              zip(W.derivative(x.value, "#1", n), W.derivative(y.value, "#1", n))]) for n in range(k + 1))
    if x.shape != "quad" or y.shape != "quad":
        raise Unsupported("C(k) of triangles")
    results = []
    for across, along_it in (("#1", "#2"), ("#2", "#1")):
        for a, b in ((F.ONE, F.ZERO), (F.ZERO, F.ONE)):
            truths = []
            for n in range(k + 1):
                pair = zip(W.derivative(x.value, across, n), W.derivative(y.value, across, n))
                apart = [F.sub(F.substitute(f, {across: a}), F.substitute(g, {across: b})) for f, g in pair]
                truths += [look.zero([F.substitute(f, {along_it: F.const(s)}) for f in apart]) for s in SOME]
            results.append((truths[0], all_likely(truths)))
    meeting = [result for first, result in results if first > 0]
    if not meeting:
        raise Unsupported("C(k) of patches that do not meet in this way")
    return max(meeting)


def partition_of_unity(look, fs):
    fs = [f.value if isinstance(f, Function) else f for f in fs]
    total = F.sub(F.total(fs), F.ONE)
    return all_likely(look.zero([F.substitute(total, {"u": F.const(u), "v": F.const(v)})], u, v) for u, v in look.places(None))


def nonnegative(look, fs):
    domain = look.domain[1] if look.domain and look.domain[0] == "name" else None
    if look.domain and domain not in ("triangle", "square"):
        raise Unsupported("nonnegative on this domain")
    truths = []
    for f in fs:
        f = f.value if isinstance(f, Function) else f
        for u, v in look.places(domain or "square"):
            x = look.at(F.substitute(f, {"u": F.const(u), "v": F.const(v)}), u, v)
            s = N.sign(x)
            truths.append(FALSE if s == -1 else LIKELY)
    return all_likely(truths)


# ---- meshes

def count_truth(is_so):
    return TRUE if is_so else FALSE


def planar(look, thing):
    faces = [[thing.points[i] for i in f] for f in thing.faces] if isinstance(thing, Mesh) else [list(thing)]
    truths = []
    for points in faces:
        spans = [[F.sub(a, b) for a, b in zip(p, points[0])] for p in points[1:]]
        if len(spans) < 3:
            continue
        vectors = [[look.at(f) for f in s] for s in spans]
        normal = next((n for i in range(len(vectors)) for j in range(i) for n in [cross(vectors[j], vectors[i])] if zero_vector(n) == FALSE), None)
        if normal is not None:
            truths += [look_zero(dot(normal, w)) for w in vectors]
    return min(truths, default=TRUE)


def convex(look, mesh):
    if isinstance(mesh, Surface):
        return convex_surface(look, mesh)
    points = [[look.at(f) for f in p] for p in mesh.points]
    truths = [planar(look, mesh)]
    for face in mesh.faces:
        a, b, c = (points[i] for i in face[:3])
        normal = cross([N.plus(x, N.minus(y)) for x, y in zip(b, a)], [N.plus(x, N.minus(y)) for x, y in zip(c, a)])
        for i, p in enumerate(points):
            if i not in face:
                side = N.sign(dot(normal, [N.plus(x, N.minus(y)) for x, y in zip(p, a)]))
                truths.append(TRUE if side == -1 else FALSE if side == 1 else UNLIKELY)
    return min(truths + [count_truth(solids.is_oriented(mesh))])


def convex_surface(look, surface):
    truths = [closed(look, surface), surface_contact(look, 1, surface)]
    for p in surface.patches[:1] if surface.is_orbit else surface.patches:
        k = W.gauss(p)
        for u, v in look.places(p.shape):
            truths.append({1: LIKELY, None: UNLIKELY}.get(N.sign(look.at(k, u, v)), FALSE))
    return all_likely(truths)


TABLE = {
    "regular": regular, "ruled": ruled, "developable": developable, "cylindrical": cylindrical,
    "G0": contact(0), "G1": contact(1), "G2": contact(2), "G": contact(None), "C": continuity, "closed": closed,
    "interpolates": interpolates, "partition_of_unity": partition_of_unity, "nonnegative": nonnegative,
    "planar": planar, "convex": convex, "trivalent": lambda look, m: count_truth(set(solids.valence_numbers(m)) == {3}),
    "manifold": lambda look, m: count_truth(solids.is_manifold(m)), "oriented": lambda look, m: count_truth(solids.is_oriented(m)),
    "connected": lambda look, m: count_truth(solids.is_connected(m)),
}
