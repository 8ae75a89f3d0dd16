# SPDX-License-Identifier: GPL-3.0-or-later
"""The five solids, their groups, truncation, and what can be counted on a mesh."""
import itertools
import math
from collections import Counter

import formulas as F
import values as W
from values import Items, Matrix, Mesh, Unsupported, Vector

CACHE = {}


def vertices_of(name):
    phi = F.div(F.add(F.ONE, F.root(F.const(5))), F.const(2))
    over = F.sub(phi, F.ONE)  # 1/phi
    z, one = F.ZERO, F.ONE

    def cyclic(a, b):
        return [[z, sa, sb][-k:] + [z, sa, sb][:-k] for sa in (a, F.neg(a)) for sb in (b, F.neg(b)) for k in range(3)]
    cube = [[F.const(x) for x in p] for p in itertools.product((1, -1), repeat=3)]
    return {"tetrahedron": [[F.const(x) for x in p] for p in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))],
            "cube": cube,
            "octahedron": [[F.const(s if i == k else 0) for i in range(3)] for k in range(3) for s in (1, -1)],
            "dodecahedron": cube + cyclic(phi, over),
            "icosahedron": cyclic(one, phi)}[name]


def solid(name):
    if name not in CACHE:
        points = [Vector(p) for p in vertices_of(name)]
        CACHE[name] = Mesh(points, hull([W.floats(p) for p in points]))
    return CACHE[name]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def hull(points):
    """The faces of the convex hull, turned outwards, of points all of which are corners."""
    faces = {}
    for a, b, c in itertools.permutations(range(len(points)), 3):
        if a > b or a > c:
            continue
        n = cross(minus(points[b], points[a]), minus(points[c], points[a]))
        heights = [dot(n, minus(p, points[a])) for p in points]
        if max(heights) < 1e-9:
            on = tuple(i for i, h in enumerate(heights) if h > -1e-9)
            if on not in faces:
                faces[on] = turned(points, on, n)
    return [list(f) for f in faces.values()]


def turned(points, on, n):
    centre = [sum(points[i][k] for i in on) / len(on) for k in range(3)]
    first = minus(points[on[0]], centre)
    second = cross(n, first)
    length = math.sqrt(dot(n, n))
    return sorted(on, key=lambda i: math.atan2(dot(second, minus(points[i], centre)) / length, dot(first, minus(points[i], centre))))


def truncated(mesh, r):
    made, points = {}, []

    def cut(a, b):
        if (a, b) not in made:
            made[a, b] = len(points)
            points.append(Vector(F.add(x, F.mul(r, F.sub(y, x))) for x, y in zip(mesh.points[a], mesh.points[b])))
        return made[a, b]
    faces, following = [], {}
    for face in mesh.faces:
        around = []
        for k, v in enumerate(face):
            before, after = face[k - 1], face[(k + 1) % len(face)]
            around += [cut(v, before), cut(v, after)]
            following.setdefault(v, {})[after] = before  # the next edge at v
        faces.append(around)
    for v in range(len(mesh.points)):
        if v not in following:
            continue
        start = w = next(iter(following[v]))
        cycle = []
        while not cycle or w != start:
            cycle.append(cut(v, w))
            w = following[v].get(w)
            if w is None or len(cycle) > len(following[v]):
                raise Unsupported("a truncation of a mesh that is not closed")
        faces.append(cycle)
    return Mesh(points, faces)


def dual(mesh):
    def middle(face):
        return Vector(F.div(F.total(mesh.points[i][c] for i in face), F.const(len(face))) for c in range(3))
    points = [middle(f) for f in mesh.faces]
    floats = [W.floats(p) for p in points]
    faces = []
    for v, point in enumerate(mesh.points):
        on = tuple(i for i, f in enumerate(mesh.faces) if v in f)
        faces.append(list(turned(floats, on, W.floats(point))))
    return Mesh(points, faces)


def counts(mesh):
    return (len(mesh.points), len(mesh.edges()), len(mesh.faces))


def pairs(numbers):
    return Items(Vector([F.const(size), F.const(times)]) for size, times in sorted(Counter(numbers).items()))


def valence_numbers(mesh):
    degree = Counter(v for edge in mesh.edges() for v in edge)
    return [degree[v] for v in range(len(mesh.points))]


def is_closed(mesh):
    return all(len(sides) == 2 for sides in mesh.edges().values()) and is_connected(mesh)


def is_connected(mesh):
    neighbours = {}
    for a, b in mesh.edges():
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    seen, todo = {0}, [0]
    while todo:
        for w in neighbours.get(todo.pop(), []):
            if w not in seen:
                seen.add(w)
                todo.append(w)
    return len(seen) == len(mesh.points)


def is_manifold(mesh):
    if not all(len(sides) == 2 for sides in mesh.edges().values()):
        return False
    for v in range(len(mesh.points)):
        links = {}
        for face in mesh.faces:
            if v in face:
                k = face.index(v)
                for a, b in ((face[k - 1], face[(k + 1) % len(face)]),):
                    links.setdefault(a, []).append(b)
                    links.setdefault(b, []).append(a)
        if not links:
            return False
        start = next(iter(links))
        seen, w, before = {start}, links[start][0], start
        while w != start:
            seen.add(w)
            onward = [x for x in links[w] if x != before] or [before]
            before, w = w, onward[0]
            if len(seen) > len(links):
                return False
        if len(seen) != len(links):
            return False
    return True


def is_oriented(mesh):
    return all(len(sides) == 2 and sides[0] == sides[1][::-1] for sides in mesh.edges().values())


def group(name, with_mirrors):
    """All matrices, of determinant 1 unless mirrors are wanted, that carry the vertices to vertices."""
    cached = CACHE.get((name, with_mirrors))
    if cached:
        return cached
    mesh = solid(name)
    at = [W.floats(p) for p in mesh.points]
    face = mesh.faces[0][:3]
    start = [at[i] for i in face]
    inverse = W.inverse(Matrix([list(row) for row in zip(*[mesh.points[i] for i in face])]))
    found = []
    for images in itertools.permutations(range(len(at)), 3):
        target = [at[i] for i in images]
        if any(abs(dot(start[i], start[j]) - dot(target[i], target[j])) > 1e-9 for i in range(3) for j in range(i)):
            continue
        turn = dot(start[0], cross(start[1], start[2])) * dot(target[0], cross(target[1], target[2]))
        if turn < 0 and not with_mirrors:
            continue
        columns = Matrix([list(row) for row in zip(*[mesh.points[i] for i in images])])
        matrix = W.product(columns, inverse)
        f = [W.floats(Vector(row)) for row in matrix]
        keys = {W.key([dot(row, p) for row in f]) for p in at}
        if keys == {W.key(p) for p in at}:
            found.append(exact(matrix))
    found.sort(key=lambda m: -sum(W.floats(m[i][i])[0] for i in range(3)))
    CACHE[name, with_mirrors] = Items(found)
    return CACHE[name, with_mirrors]


def exact(matrix):
    """The same matrix with its entries a + b*sqrt(5) in short form."""
    import enclosures as N
    from fractions import Fraction
    five = F.root(F.const(5))

    def short(f):
        x = F.evaluate(f, {}, {})
        for b4 in range(-4, 5):
            for a4 in range(-8, 9):
                guess = F.add(F.const(Fraction(a4, 4)), F.mul(F.const(Fraction(b4, 4)), five))
                difference = N.plus(x, N.minus(F.evaluate(guess, {}, {})))
                if N.sign(difference) in (0, None):
                    return guess
        return f
    return Matrix([[short(f) for f in row] for row in matrix])
