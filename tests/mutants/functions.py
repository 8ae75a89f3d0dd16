# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of the language that make values."""
from fractions import Fraction
from math import ceil, comb, factorial, floor

import extrema
import formulas as F
import nets
import solids
import values as W
from binders import coefficients, coefficients_in_bernstein_form, degree, diff, gathered, limit, subst
from meaning import Range, as_integer
from values import Function, Items, Matrix, Mesh, Patch, Surface, TooLarge, Unsupported, Vector


def call(m, name, trees, scope):
    special = SPECIAL.get(name)
    if special:
        return special(m, name, trees, scope)
    arguments = [m.value(t, scope) for t in trees]
    f = SIMPLE.get(name)
    if not f:
        raise Unsupported("the function " + name)
    try:
        return f(m, *arguments)
    except (TypeError, AttributeError, IndexError, KeyError) as error:
        raise Unsupported("%s of these arguments: %s" % (name, error))


def reflected(m, name, trees, scope):
    p, plane = m.value(trees[0], scope), m.value(trees[1], scope)
    return W.mapped(p, *W.reflection(plane))


def partial(m, name, trees, scope):
    f = m.function(m.value(trees[0], scope))
    orders = {"D1": (1, 0), "D2": (0, 1)}.get(name)
    if not orders:
        orders = tuple(m.integer(t, scope) for t in trees[1:]) + (0,) * (3 - len(trees))
    value = W.derivative(W.derivative(f.value, "#1", orders[0]), "#2", orders[1] if f.arity == 2 else 0)
    return Function(f.arity, value, f.shape)


def group(m, name, trees, scope):
    if len(trees) != 1 or trees[0][0] != "name":
        raise Unsupported(name)
    mesh = m.value(trees[0], scope)
    for solid in ("tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"):
        if mesh is solids.solid(solid):
            return solids.group(solid, name == "symmetries")
    raise Unsupported(name + " of another mesh")


SPECIAL = {"sum": gathered, "product": gathered, "max": gathered, "min": gathered, "diff": diff, "subst": subst, "limit": limit,
           "bernstein": coefficients_in_bernstein_form, "degree": degree, "coefficients": coefficients, "reflect": reflected,
           "D1": partial, "D2": partial, "D": partial, "rotations": group, "symmetries": group}


# ---- those that do not

def counted(m, name, trees, scope):
    if len(trees) == 1 and trees[0][0] == "each":
        return F.const(len(m.each(trees[0], scope)))
    if trees[0][0] == "call" and trees[0][1] in (("name", "seams"), ("name", "corners")):
        surface = m.value(trees[0][2][0], scope)
        return F.const(len(extrema.seams(surface) if trees[0][1][1] == "seams" else extrema.corners(surface)))
    value = m.value(trees[0], scope)
    if not isinstance(value, (Items, Range)):
        raise Unsupported("a count")
    return F.const(len(value))


SPECIAL["count"] = counted


def blending(m, matrix):
    rows = []
    for row in matrix:
        n = len(row) - 1
        rows.append(Function(1, F.total(F.mul(c, F.power(W.U, n - k)) for k, c in enumerate(row)), "curve"))
    return Items(rows)


def tensor(m, matrix, *rest):
    other, points = (rest[0], rest[1]) if len(rest) == 2 else (matrix, rest[0])
    first, second = blending(m, matrix), blending(m, other)
    if isinstance(points, Items) and isinstance(points[0], Vector):
        value = Vector(F.total(F.mul(f.value, p[c]) for f, p in zip(first, points)) for c in range(len(points[0])))
        return Patch("curve", value)
    v_values = [F.substitute(g.value, {"#1": W.V}) for g in second]
    terms = [(F.mul(f.value, g), p) for g, row in zip(v_values, points) for f, p in zip(first, row)]
    return Patch("quad", Vector(F.total(F.mul(b, p[c]) for b, p in terms) for c in range(3)))


def orbit(m, p, matrices):
    images, seen = [], set()
    floats = {}

    def image_key(matrix):
        f = [W.floats(Vector(row)) for row in matrix]
        return frozenset(W.key([sum(a * b for a, b in zip(row, x)) for row in f]) for x in floats["points"])
    floats["points"] = [W.float_point(p, W.on_side(side, t)) for side in W.BOUNDARY[p.shape] for t in (0, 1 / 3, 1 / 2, 2 / 3, 1)]
    floats["points"] += [W.float_point(p, uv) for uv in W.INSIDE[p.shape]]
    for matrix in sorted(matrices, key=lambda g: -sum(W.floats(g[i][i])[0] for i in range(3))):
        key = image_key(matrix)
        if key not in seen:
            seen.add(key)
            images.append(W.mapped(p, matrix))
    return Surface(images, matrices)


def control(m, p, i, j=None):
    if p.control is None:
        p.control = nets.control(p)
    return p.control[as_integer(i), as_integer(j) if j is not None else 0]


def edge(m, p, k):
    t = W.U
    ends = {"triangle": [(t, F.ZERO), (F.ZERO, t), (F.sub(F.ONE, t), t)],
            "quad": [(t, F.ZERO), (F.ZERO, t), (t, F.ONE), (F.ONE, t)]}[p.shape]
    k = as_integer(k)
    degree = p.degree[0 if k in (1, 3) else 1] if isinstance(p.degree, tuple) else p.degree
    return Patch("curve", W.at(p.value, ends[k - 1]), degree)


def truncate(m, mesh, r=None, times=None):
    if not isinstance(mesh, Mesh):
        raise Unsupported("truncate")
    n = as_integer(times) if times is not None else 1
    if n < 0 or n > 6 or len(mesh.points) * 3 ** n > 9000:
        raise TooLarge("a mesh too large for this evaluator")
    for _ in range(n):
        mesh = solids.truncated(mesh, r if r is not None else F.const(Fraction(1, 4)))
    return mesh


def whole(f, rounding):
    x = F.value(f)
    if x is None:
        raise Unsupported("a rounding of no rational")
    return F.const(rounding(x))


def fraction_part(m, f, which):
    x = F.value(f) if isinstance(f, F.Formula) else None
    if x is not None:
        return F.const(x.numerator if which == 0 else x.denominator)
    if isinstance(f, Function) and isinstance(f.value, F.Formula):
        return Function(f.arity, fraction_part(m, f.value, which), f.shape)
    if f.op == "/":
        return f.args[which]
    raise Unsupported("a part of a fraction")


def valence(m, mesh, v):
    at = [i for i, p in enumerate(mesh.points) if W.key(W.floats(p)) == W.key(W.floats(v))]
    return F.const(solids.valence_numbers(mesh)[at[0]])


def make_mesh(m, points, faces):
    return Mesh([Vector(p) for p in points], [[as_integer(i) - 1 for i in f] for f in faces])


def mean_of(points):
    return Vector(F.div(F.total(p[c] for p in points), F.const(len(points))) for c in range(len(points[0])))


def gauss(m, f):
    if isinstance(f, Surface):
        return extrema.OnSurface(f, W.gauss)
    f = m.function(f)
    return Function(2, W.gauss(f), f.shape)


def norm2(m, v):
    return W.dot(v, v)


def rows_of(v):
    return [list(x) for x in v]


def parts(m, surface):
    if not isinstance(surface, Surface):
        raise Unsupported("patches")
    return Items(surface.patches)


SIMPLE = {
    "sqrt": lambda m, x: F.root(x), "cbrt": lambda m, x: F.root(x, 3), "root_n": lambda m, x, n: F.root(x, as_integer(n)),
    "abs": lambda m, x: F.make("abs", x), "floor": lambda m, x: whole(x, floor), "ceil": lambda m, x: whole(x, ceil),
    "binomial": lambda m, n, k: F.const(comb(as_integer(n), as_integer(k))), "factorial": lambda m, n: F.const(factorial(as_integer(n))),
    "exp": lambda m, x: F.call("exp", x), "log": lambda m, x: F.call("log", x), "sin": lambda m, x: F.call("sin", x),
    "cos": lambda m, x: F.call("cos", x), "tan": lambda m, x: F.div(F.call("sin", x), F.call("cos", x)),
    "numerator": lambda m, f: fraction_part(m, f, 0), "denominator": lambda m, f: fraction_part(m, f, 1),
    "dot": lambda m, a, b: W.dot(a, b), "cross": lambda m, a, b: W.cross(a, b),
    "det": lambda m, *v: W.det(list(zip(*v)) if len(v) > 1 else rows_of(v[0])),
    "norm": lambda m, v: F.root(W.dot(v, v)), "norm2": norm2, "transpose": lambda m, a: Matrix([list(r) for r in zip(*a)]),
    "inverse": lambda m, a: W.inverse(a), "identity": lambda m, n: W.identity(as_integer(n)),
    "columns": lambda m, a: Items(Vector(c) for c in zip(*a)), "rows": lambda m, a: Items(Vector(r) for r in a),
    "normal": lambda m, f: Function(2, W.normal(m.function(f)), m.function(f).shape), "gauss": gauss,
    "control": control, "edge": edge,
    "elevate": lambda m, p: Patch(p.shape, p.value, None if p.degree is None else tuple(d + 1 for d in p.degree) if isinstance(p.degree, tuple) else p.degree + 1),
    "swap": lambda m, p: Patch(p.shape, W.at(p.value, [W.V, W.U])),
    "blending": blending, "tensor": tensor, "orbit": orbit, "patches": parts, "surface": lambda m, ps: Surface(list(ps)),
    "vertices": lambda m, mesh: Items(mesh.points), "edges": lambda m, mesh: Items(Items([mesh.points[a], mesh.points[b]]) for a, b in sorted(mesh.edges())),
    "faces": lambda m, mesh: Items(Items(mesh.points[i] for i in f) for f in mesh.faces), "valence": valence,
    "counts": lambda m, mesh: Vector(F.const(n) for n in solids.counts(mesh)), "dual": lambda m, mesh: solids.dual(mesh),
    "euler": lambda m, mesh: F.const(solids.counts(mesh)[0] - solids.counts(mesh)[1] + solids.counts(mesh)[2]),
    "scale": lambda m, k, mesh: Mesh([W.scaled(k, p) for p in mesh.points], mesh.faces), "mesh": make_mesh,
    "face_sizes": lambda m, mesh: solids.pairs(len(f) for f in mesh.faces), "valences": lambda m, mesh: solids.pairs(solids.valence_numbers(mesh)),
    "truncate": truncate, "centroid": lambda m, f: mean_of(f), "midpoint": lambda m, e: mean_of(e),
}
