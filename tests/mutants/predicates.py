# SPDX-License-Identifier: GPL-3.0-or-later
"""The predicates of the language, looked at in points: what a predicate says of all points is at most likely."""
from fractions import Fraction

import enclosures as N
import extrema
import formulas as F
import solids
import values as W
from comparing import FALSE, LIKELY, TRUE, UNLIKELY
from contact import contact, cross, dot, look_zero, surface_contact, zero_vector
from looking import Look, SOME, all_likely
from meaning import PARAMETERS, as_integer
from values import Function, Mesh, Surface, Unsupported, Vector


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
