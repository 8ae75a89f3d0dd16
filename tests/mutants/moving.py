# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that meet what is assumed: found by steps from others."""
from fractions import Fraction

import enclosures as N
import formulas as F
from comparing import FALSE, equal, ordered
from points import Points


class Moving(Points):
    def __init__(self, meaning, seed, samples, special):
        super().__init__(meaning, seed, samples, special)
        self.standing = []  # what a point has to meet: functions of it

    def repaired(self, condition, scope, point):
        """A point where the condition is met, and all that stands, from this one by steps in variables in which a comparison
        is linear, or by solving for several at once."""
        for attempt in range(6):
            comparisons = self.comparisons(condition, scope)
            moved = dict(point)
            for op, f in comparisons:
                self.needed(f, moved)
            try:
                if attempt % 2 == 0:
                    self.step(comparisons, moved)
                else:
                    self.solve_together([f for op, f in comparisons if op == "="], moved)
                    self.step([c for c in comparisons if c[0] != "="], moved)
                if self.inside(moved) and all(meets(moved) for meets in self.standing) and self.here(condition, scope, moved) > 0:
                    return moved
            except N.Undefined:
                pass
        return None

    def step(self, comparisons, moved):
        used = set()
        for op, f in comparisons:
            e = F.evaluate(f, moved, {})
            if (equal(e) == FALSE) if op == "!=" else op != "=" and ordered(op, e) > 0:
                continue
            wanted = Fraction(0) if op == "=" else Fraction(self.rng.randint(1, 60), 37) * (-1 if op in ("<", "<=") else 1)
            names = self.rng.sample(sorted(f.has), len(f.has))
            for name in sorted(names, key=lambda n: n in used):
                slope = F.diff(f, name)
                if name in slope.has:
                    continue
                a = F.evaluate(slope, moved, {})
                if N.sign(a) not in (0, None):
                    moved[name] = N.plus(moved[name], N.times(N.plus(wanted, N.minus(e)), N.inverse(a)))
                    break
            if op == "=":
                used |= f.has

    def solve_together(self, equations, moved):
        """Variables in which all of the equations are linear at once, one for each."""
        names = sorted(frozenset().union(*[f.has for f in equations])) if equations else []
        for _ in range(60):
            if len(names) < len(equations):
                return
            chosen = self.rng.sample(names, len(equations))
            slopes = [[F.diff(f, x) for x in chosen] for f in equations]
            if any(g.has & set(chosen) for row in slopes for g in row):
                continue
            rows = [[F.evaluate(g, moved, {}) for g in row] + [N.minus(F.evaluate(f, moved, {}))] for f, row in zip(equations, slopes)]
            steps = eliminated(rows)
            if steps is not None:
                for name, x in zip(chosen, steps):
                    moved[name] = N.plus(moved[name], x)
                return

    def comparisons(self, tree, scope):
        """Of a conjunction: each operator and what stands on its left, with 0 on its right; equations first."""
        if tree[0] == "and":
            found = self.comparisons(tree[1], scope) + self.comparisons(tree[2], scope)
            return sorted(found, key=lambda c: c[0] != "=")
        if tree[0] == "or":
            return self.comparisons(tree[self.rng.randint(1, 2)], scope)
        if tree[0] == "relation" and "~" not in tree[1]:
            return [(op, f) for op, fs in zip(tree[1], self.differences(tree, scope)) for f in fs if F.value(f) is None]
        return []


def eliminated(rows):
    """The solution of a linear system, each row with its right side; None where there is not certainly one."""
    n = len(rows)
    for k in range(n):
        pivot = next((r for r in range(k, n) if N.sign(rows[r][k]) in (1, -1)), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        over = N.inverse(rows[k][k])
        rows[k] = [N.times(x, over) for x in rows[k]]
        for r in range(n):
            if r != k:
                factor = N.minus(rows[r][k])
                rows[r] = [N.plus(x, N.times(factor, y)) for x, y in zip(rows[r], rows[k])]
    return [row[n] for row in rows]
