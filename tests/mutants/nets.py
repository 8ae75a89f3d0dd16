# SPDX-License-Identifier: GPL-3.0-or-later
"""Patches and curves, from what is written of them."""
import polynomials
import values as W
from values import Patch, Unsupported


def patch(m, tree, scope):
    shape = tree[1].replace("_patch", "")
    if tree[0] == "net":
        rows = [list(m.items(row, scope)) for row in tree[2]]
        if shape == "triangle":
            degree = len(rows) - 1
            if [len(row) for row in rows] != list(range(degree + 1, 0, -1)):
                raise Unsupported("a net of another shape")
        elif shape == "curve":
            degree = len(rows[0]) - 1
        else:
            degree = (len(rows[0]) - 1, len(rows) - 1)
        return W.patch_of_net(shape, {(i, j): x for j, row in enumerate(rows) for i, x in enumerate(row)}, degree)
    if tree[0] == "indexed":
        degree, control = m.integer(tree[2], scope), {}
        for label, point in tree[3].items():
            i, j, k = (int(x) for x in (label.split(",") if "," in label else label))
            if i + j + k != degree:
                raise Unsupported("a label of another degree")
            control[i, j] = m.value(point, scope)
        return W.patch_of_net(shape, control, degree)
    inner = dict(scope)
    for name, k in (("u", 0), ("v", 1), ("s", 0), ("t", 0 if shape == "curve" else 1)):
        if name in ("u", "v") or (name not in scope and name not in m.definitions):
            inner[name] = (W.U, W.V)[k]
    value = m.value(tree[2], inner)
    degree = degree_of(shape, value)
    return Patch(shape, value, degree)


def degree_of(shape, value):
    powers = set()
    try:
        for f in W.flat(value):
            powers |= polynomials.nonzero(polynomials.of(f, ("#1", "#2"))).keys()
    except Unsupported:
        return None
    if shape == "triangle":
        return max((i + j for i, j in powers), default=0)
    degree = (max((i for i, _ in powers), default=0), max((j for _, j in powers), default=0))
    return degree[0] if shape == "curve" else degree


def control(p):
    """The control points of a patch or curve that was made of a formula."""
    if p.shape not in ("triangle", "curve") or p.degree is None:
        raise Unsupported("a control point of this patch")
    names = ("#1", "#2") if p.shape == "triangle" else ("#1",)
    parts = [polynomials.nonzero(polynomials.of(f, names)) for f in p.value]
    if p.shape == "curve":
        tables = [dict(enumerate(polynomials.line_coefficients(part, p.degree))) for part in parts]
        return {(i, 0): W.Vector(t[i] for t in tables) for i in range(p.degree + 1)}
    tables = [polynomials.triangle_coefficients(part, p.degree) for part in parts]
    return {key: W.Vector(t[key] for t in tables) for key in tables[0]}
