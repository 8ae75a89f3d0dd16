# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes: truncated as often as said, then counted and compared."""
from collections import Counter

from convex import Points, is_convex, is_planar
from gluing import Parts
from polynomial import Effort, Polynomial
from reading import Malformed, listed, members, need, text, whole
from tower import Refused


class Mesh:
    def __init__(self, vertices, points, faces):
        self.vertices, self.points, self.faces = vertices, points, faces
        self.sides = [(face[i], face[(i + 1) % len(face)]) for face in faces for i in range(len(face))]
        Effort.spend(10 * len(self.sides))
        self.edges = {}  # {unordered pair: numbers of its sides}
        for number, (a, b) in enumerate(self.sides):
            self.edges.setdefault((min(a, b), max(a, b)), []).append(number)

    def mates(self):
        """The other side along the same edge, of each side."""
        mate = {}
        for pair in self.edges.values():
            if len(pair) == 2:
                mate[pair[0]], mate[pair[1]] = pair[1], pair[0]
        return mate

    def side_before(self):
        """The side before each in its face."""
        before, start = {}, 0
        for face in self.faces:
            for i in range(len(face)):
                before[start + i] = start + (i - 1) % len(face)
            start += len(face)
        return before

    def truncated(self, ratio, tower):
        if not (self.is_manifold() and self.is_oriented()):
            raise Refused("a mesh that is truncated and is no oriented manifold")
        if any(n < 3 for n in self.valences().values()):
            raise Refused("a vertex on two faces that is cut off")
        mate, before = self.mates(), self.side_before()
        faces, start = [], 0
        for face in self.faces:
            faces.append([n for i in range(start, start + len(face)) for n in (i, mate[i])])
            start += len(face)
        first = {}
        for number, (a, _) in enumerate(self.sides):
            first.setdefault(a, number)
        for vertex in sorted(first):
            cycle, at = [], first[vertex]
            while at not in cycle:
                cycle.append(at)
                at = mate[before[at]]
            faces.append(cycle)
        points = []
        if self.points:
            for a, b in self.sides:
                points.append([tower.reduce(x + ratio * (y - x)) for x, y in zip(self.points[a], self.points[b])])
        return Mesh(len(self.sides), points, faces)

    def valences(self):
        at = Counter({v: 0 for v in range(self.vertices)})
        for a, b in self.edges:
            at[a] += 1
            at[b] += 1
        return at

    def is_connected(self):
        parts = Parts(range(self.vertices))
        for a, b in self.edges:
            parts.join(a, b)
        return parts.count() <= 1

    def has_two_sides_an_edge(self):
        return all(len(sides) == 2 for sides in self.edges.values())

    def is_manifold(self):
        """The faces round a vertex form one cycle: corners of faces, joined where they share an edge at the vertex."""
        if not self.has_two_sides_an_edge():
            return False
        before = self.side_before()
        corners = Parts(range(len(self.sides)))  # corner i is the start of side i; there meet side i and the one before
        at_end = {}
        for i, (a, _) in enumerate(self.sides):
            for side in (i, before[i]):
                edge = tuple(sorted(self.sides[side]))
                if (a, edge) in at_end:
                    corners.join(i, at_end[a, edge])
                at_end[a, edge] = i
        cycles = Counter(self.sides[i][0] for i in range(len(self.sides)) if corners.find(i) == i)
        return all(cycles[v] == 1 for v in range(self.vertices))

    def is_oriented(self):
        return self.has_two_sides_an_edge() and all(
            self.sides[i] == self.sides[j][::-1] for i, j in self.edges.values())

    def is_orientable(self):
        """Faces are coloured as they are or turned over, (face, 0) and (face, 1); none may be joined with its other."""
        if any(len(sides) > 2 for sides in self.edges.values()):
            return False
        face_of = [f for f, face in enumerate(self.faces) for _ in face]
        parts = Parts((f, turned) for f in range(len(self.faces)) for turned in (0, 1))
        for sides in self.edges.values():
            if len(sides) == 2:
                i, j = sides
                same = self.sides[i] == self.sides[j]
                for turned in (0, 1):
                    parts.join((face_of[i], turned), (face_of[j], turned ^ same))
        return all(parts.find((f, 0)) != parts.find((f, 1)) for f in range(len(self.faces)))

    def sizes_are(self, values, counted):
        found = sorted(Counter(counted).items())
        return [n for pair in found for n in pair] == values


def read(program, content):
    vertices, points, faces, ratios, name, values = members(
        content, "vertices", "points", "faces", "ratios", "property", "values")
    whole(vertices)
    below = program.of_statement
    points = [[program.number(whole(t, 0, below)) for t in listed(point, 3)] for point in listed(points)]
    need(len(points) in (0, vertices), "not one point a vertex")
    faces = [[whole(v, 0, vertices) for v in listed(face)] for face in listed(faces)]
    need(all(len(face) >= 3 and len(set(face)) == len(face) for face in faces), "a face that is none")
    mesh = Mesh(vertices, points, faces)
    for ratio in listed(ratios):
        ratio = program.number(whole(ratio, 0, below))
        if program.sign(ratio) != 1 or program.sign(Polynomial.constant(1) - ratio - ratio) != 1:
            raise Refused("a ratio of truncation that is not between 0 and 1/2")
        mesh = mesh.truncated(ratio, program.tower)
    return mesh, text(name), [whole(v, -10 ** 9) for v in listed(values)]


def holds(program, content):
    mesh, name, values = read(program, content)
    if name in ("planar", "convex") and not mesh.points:
        raise Refused("a mesh without points")
    if name == "counts":
        return values == [mesh.vertices, len(mesh.edges), len(mesh.faces)]
    if name == "face_sizes":
        return mesh.sizes_are(values, map(len, mesh.faces))
    if name == "valences":
        return mesh.sizes_are(values, mesh.valences().values())
    if name == "valence":
        vertex, count = listed(values, 2)
        return mesh.valences()[whole(vertex, 0, mesh.vertices)] == count
    if name == "connected":
        return mesh.is_connected()
    if name == "closed":
        return mesh.is_connected() and mesh.has_two_sides_an_edge()
    if name == "manifold":
        return mesh.is_manifold()
    if name == "orientable":
        return mesh.is_orientable()
    if name == "oriented":
        return mesh.is_oriented()
    if name == "planar":
        chosen = [mesh.faces[whole(f, 0, len(mesh.faces))] for f in values] or mesh.faces
        points = Points(program, mesh)
        return all(is_planar(points, face) for face in chosen)
    if name == "convex":
        return is_convex(program, mesh)
    raise Malformed("no property of a mesh: " + name)
