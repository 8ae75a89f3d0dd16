# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether faces are planar, and whether a mesh is the boundary of a convex polyhedron."""
from math import lcm

import enclosure as e
from polynomial import Polynomial
from tower import Open

BITS = 128


class Points:
    """The corners of a mesh, multiplied by one number so that the coefficients are integers; with enclosures."""

    def __init__(self, program, mesh):
        self.program = program
        scale = Polynomial.constant(lcm(*(x.under for p in mesh.points for x in p)))
        self.exact = [[x * scale for x in p] for p in mesh.points]
        self.boxes = [[self.box(x) for x in p] for p in self.exact]

    def box(self, number):
        try:
            return self.program.tower.enclose(number, BITS)
        except Open:
            return None

    def vector(self, a, b):
        return [y - x for x, y in zip(self.exact[a], self.exact[b])]

    def cross(self, u, v):
        reduce = self.program.tower.reduce
        return [reduce(u[i] * v[j] - u[j] * v[i]) for i, j in ((1, 2), (2, 0), (0, 1))]

    def is_zero(self, vector):
        return not any(self.program.sign(x) for x in vector)


class Direction:
    """A vector, and the sign of its product with the vector from one corner to another."""

    def __init__(self, points, vector):
        self.points, self.exact = points, vector
        self.boxes = [points.box(x) for x in vector]

    def sign(self, a, b):
        boxes, p, q = self.boxes, self.points.boxes[a], self.points.boxes[b]
        if None not in boxes and None not in p and None not in q:
            total = (0, 0)
            for n, x, y in zip(boxes, p, q):
                total = e.plus(total, e.times(n, e.minus(y, x), BITS))
            if e.sign(total):
                return e.sign(total)
        total = Polynomial()
        for n, x in zip(self.exact, self.points.vector(a, b)):
            total = total + n * x
        return self.points.program.sign(self.points.program.tower.reduce(total))


def is_planar(points, face):
    """The corners lie in one plane: every one in that of the first three which are not in one line."""
    a = face[0]
    b = next((b for b in face if not points.is_zero(points.vector(a, b))), None)
    if b is None:
        return True
    for c in face:
        normal = points.cross(points.vector(a, b), points.vector(a, c))
        if not points.is_zero(normal):
            plane = Direction(points, normal)
            return all(plane.sign(a, d) == 0 for d in face)
    return True


def is_convex(program, mesh):
    """An oriented, connected manifold of the Euler number of a sphere, each face of which is a convex polygon in a
    plane that has all other vertices strictly on one side, the same side for all faces.

    Then every face is a facet of the convex hull: it is the whole of the hull in that plane, for no other vertex
    lies there. A facet of the hull beside it, across an edge, is the face of the mesh that has that edge. So faces are
    all facets, for those are connected across edges. Conversely a convex polyhedron has all this.
    """
    if not (mesh.is_connected() and mesh.is_manifold() and mesh.is_oriented()):
        return False
    if mesh.vertices - len(mesh.edges) + len(mesh.faces) != 2:
        return False
    points, seen = Points(program, mesh), set()
    for face in mesh.faces:
        a, b, c = face[:3]
        normal = points.cross(points.vector(a, b), points.vector(a, c))
        if points.is_zero(normal):
            return False
        plane, corners = Direction(points, normal), set(face)
        for v in range(mesh.vertices):
            side = plane.sign(a, v)
            if (side == 0) != (v in corners):
                return False
            seen.add(side)
        for start, end in zip(face, face[1:] + face[:1]):  # every other corner strictly on the left of each side
            left = Direction(points, points.cross(normal, points.vector(start, end)))
            if any(left.sign(start, v) != 1 for v in face if v not in (start, end)):
                return False
    return not {1, -1} <= seen and seen != {0}
