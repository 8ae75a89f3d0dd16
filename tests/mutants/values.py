# SPDX-License-Identifier: GPL-3.0-or-later
"""What expressions can be: formulas, vectors, lists, matrices, functions, patches, meshes, surfaces."""
import itertools
import math
from fractions import Fraction

import formulas as F

U, V = F.var("#1"), F.var("#2")


class Unsupported(Exception):
    """What this evaluator does not know."""


class TooLarge(Unsupported):
    """A mesh with too many vertices for this evaluator."""


class Vector(list):
    pass


class Items(list):
    """A list as written with [ ]."""


class Matrix(list):
    """Rows, which are lists of formulas."""


class Text(str):
    pass


class Closure:
    def __init__(self, parameters, body, scope):
        self.parameters, self.body, self.scope = parameters, body, scope


class Function:
    """A value in the variables #1, #2: a derivative, a curvature, a generic curve."""

    def __init__(self, arity, value, shape=None):
        self.arity, self.value, self.shape = arity, value, shape


class Patch(Function):
    def __init__(self, shape, value, degree=None, control=None):
        super().__init__(1 if shape == "curve" else 2, value, shape)
        self.degree, self.control = degree, control


class Plane:
    def __init__(self, normal, distance):
        self.normal, self.distance = normal, distance


class Mesh:
    def __init__(self, points, faces):
        self.points, self.faces = points, faces  # faces: lists of indices from 0 on

    def edges(self):
        seen = {}
        for face in self.faces:
            for a, b in zip(face, face[1:] + face[:1]):
                seen.setdefault((min(a, b), max(a, b)), []).append((a, b))
        return seen


class Surface:
    def __init__(self, patches, matrices=None):
        self.patches = patches  # of an orbit: all distinct images, that of the identity first
        self.is_orbit = matrices is not None


# ---- vectors

def dot(a, b):
    if len(a) != len(b):
        raise Unsupported("a product of vectors of different lengths")
    return F.total(F.mul(x, y) for x, y in zip(a, b))


def cross(a, b):
    if len(a) != 3 or len(b) != 3:
        raise Unsupported("a cross product not in space")
    return Vector(F.sub(F.mul(a[(i + 1) % 3], b[(i + 2) % 3]), F.mul(a[(i + 2) % 3], b[(i + 1) % 3])) for i in range(3))


def det(rows):
    n = len(rows)
    if n == 1:
        return rows[0][0]
    if n == 2:
        return F.sub(F.mul(rows[0][0], rows[1][1]), F.mul(rows[0][1], rows[1][0]))
    result = F.ZERO
    for i in range(n):
        minor = [row[:i] + row[i + 1:] for row in map(list, rows[1:])]
        term = F.mul(rows[0][i], det(minor))
        result = F.add(result, term) if i % 2 == 0 else F.sub(result, term)
    return result


def scaled(k, a):
    return type(a)(x if not isinstance(x, (F.Formula, list)) else (F.mul(k, x) if isinstance(x, F.Formula) else scaled(k, x)) for x in a)


def times_vector(m, v):
    return Vector(F.total(F.mul(x, y) if isinstance(y, F.Formula) else None for x, y in zip(row, v)) for row in m)


def transform(value, f):
    """Every formula in a value replaced by f of it."""
    if isinstance(value, F.Formula):
        return f(value)
    if isinstance(value, list):
        return type(value)(transform(x, f) for x in value)
    if isinstance(value, Patch):
        return Patch(value.shape, transform(value.value, f), value.degree, None)
    if isinstance(value, Function):
        return Function(value.arity, transform(value.value, f), value.shape)
    return value


def flat(value):
    if isinstance(value, F.Formula):
        return [value]
    if isinstance(value, list):
        return [f for x in value for f in flat(x)]
    if isinstance(value, Function):
        return flat(value.value)
    raise Unsupported("a comparison of " + type(value).__name__)


def at(value, arguments):
    names = {"#%d" % (i + 1): a for i, a in enumerate(arguments)}
    memo = {}
    return transform(value, lambda f: F.substitute(f, names, memo))


def derivative(value, variable, times=1):
    for _ in range(times):
        memo = {}
        value = transform(value, lambda f: F.diff(f, variable, memo))
    return value


def normal(p):
    return cross(derivative(p.value, "#1"), derivative(p.value, "#2"))


def gauss(p):
    d = {(i, j): derivative(derivative(p.value, "#1", i), "#2", j) for i in range(3) for j in range(3) if i + j <= 2}
    n = cross(d[1, 0], d[0, 1])
    second = [dot(d[2, 0], n), dot(d[1, 1], n), dot(d[0, 2], n)]
    return F.div(F.sub(F.mul(second[0], second[2]), F.power(second[1], 2)), F.power(dot(n, n), 2))


# ---- nets

def bernstein(i, n, t):
    return F.mul(F.const(math.comb(n, i)), F.mul(F.power(t, i), F.power(F.sub(F.ONE, t), n - i)))


def triangle_bernstein(i, j, n, u, v):
    k = n - i - j
    c = Fraction(math.factorial(n), math.factorial(i) * math.factorial(j) * math.factorial(k))
    w = F.sub(F.ONE, F.add(u, v))
    return F.mul(F.const(c), F.mul(F.power(u, i), F.mul(F.power(v, j), F.power(w, k))))


def patch_of_net(shape, control, degree):
    """`control`: points by (i, j), beside u^i v^j; of a curve j is 0."""
    some = next(iter(control.values()))
    basis = {}
    for i, j in control:
        if shape == "triangle":
            basis[i, j] = triangle_bernstein(i, j, degree, U, V)
        elif shape == "curve":
            basis[i, j] = bernstein(i, degree, U)
        else:
            basis[i, j] = F.mul(bernstein(i, degree[0], U), bernstein(j, degree[1], V))
    value = Vector(F.total(F.mul(basis[key], control[key][c]) for key in control) for c in range(len(some)))
    return Patch(shape, value, degree, control)


def mapped(p, matrix=None, offset=None):
    def image(x):
        y = times_vector(matrix, x) if matrix is not None else x
        return Vector(F.add(a, b) for a, b in zip(y, offset)) if offset is not None else y
    control = {key: image(x) for key, x in p.control.items()} if p.control else None
    return Patch(p.shape, image(p.value), p.degree, control)


def reflection(plane):
    n, nn = plane.normal, dot(plane.normal, plane.normal)
    matrix = Matrix([[F.sub(F.ONE if i == j else F.ZERO, F.div(F.mul(F.const(2), F.mul(n[i], n[j])), nn)) for j in range(3)] for i in range(3)])
    offset = Vector(F.div(F.mul(F.const(2), F.mul(plane.distance, n[i])), nn) for i in range(3))
    return matrix, offset


def identity(n):
    return Matrix([[F.ONE if i == j else F.ZERO for j in range(n)] for i in range(n)])


def product(a, b):
    return Matrix([[F.total(F.mul(x, y) for x, y in zip(row, column)) for column in zip(*b)] for row in a])


def inverse(m):
    n, d = len(m), det(m)
    if n == 1:
        return Matrix([[F.div(F.ONE, d)]])
    result = Matrix([[None] * n for _ in range(n)])
    for i, j in itertools.product(range(n), repeat=2):
        minor = [list(row[:j]) + list(row[j + 1:]) for k, row in enumerate(m) if k != i]
        entry = F.div(det(minor), d)
        result[j][i] = entry if (i + j) % 2 == 0 else F.neg(entry)
    return result


# ---- floats, where what is alike has to be found

def floats(value, point=None):
    memo = {}
    return tuple(F.evaluate_float(f, point or {}, memo) for f in flat(value))


def key(xs):
    return tuple(round(x, 7) + 0.0 for x in xs)


BOUNDARY = {"triangle": [((0, 0), (1, 0)), ((0, 0), (0, 1)), ((1, 0), (0, 1))],
            "quad": [((0, 0), (1, 0)), ((0, 0), (0, 1)), ((0, 1), (1, 1)), ((1, 0), (1, 1))]}
INSIDE = {"triangle": [(1 / 3, 1 / 3)], "quad": [(1 / 2, 1 / 2)]}


def on_side(side, t):
    (a, b), (c, d) = side
    return (a + (c - a) * t, b + (d - b) * t)


def float_point(p, uv, point=None):
    return floats(p.value, {"#1": float(uv[0]), "#2": float(uv[1]), **(point or {})})


def side_key(p, side, point=None):
    ends = [key(float_point(p, on_side(side, t), point)) for t in (0, 1 / 3, 1 / 2, 2 / 3, 1)]
    return frozenset(ends)


def patch_key(p, point=None):
    return frozenset(k for side in BOUNDARY[p.shape] for k in side_key(p, side, point)) | {
        key(float_point(p, uv, point)) for uv in INSIDE[p.shape]}
