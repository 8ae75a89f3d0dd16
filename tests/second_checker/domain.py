# SPDX-License-Identifier: GPL-3.0-or-later
"""Simplices in homogeneous coordinates, products of them cut by conditions, and points in these."""
from fractions import Fraction

import enclosure as e
from polynomial import Polynomial
from program import RELATIONS, relation_holds
from reading import listed, members, need, text, truth, whole
from tower import Open, Refused


def determinant(rows):
    """Of a square matrix of polynomials, along the first row."""
    if not rows:
        return Polynomial.constant(1)
    total = Polynomial()
    for j, entry in enumerate(rows[0]):
        if entry:
            minor = entry * determinant([row[:j] + row[j + 1:] for row in rows[1:]])
            total = total + (-minor if j % 2 else minor)
    return total


def determinant_sign(program, rows):
    """By enclosures of the entries, where that tells; else exactly."""
    bits = 128
    try:
        total = enclosed([[program.tower.enclose(x, bits) for x in row] for row in rows], bits)
        if e.sign(total):
            return e.sign(total)
    except Open:
        pass
    return program.sign(program.tower.reduce(determinant(rows)))


def enclosed(rows, bits):
    """The determinant of a matrix of intervals."""
    if not rows:
        return e.exactly(Fraction(1), bits)
    total = (0, 0)
    for j, entry in enumerate(rows[0]):
        minor = e.times(entry, enclosed([row[:j] + row[j + 1:] for row in rows[1:]], bits), bits)
        total = e.minus(total, minor) if j % 2 else e.plus(total, minor)
    return total


class Simplex:
    def __init__(self, program, variables, corners, opened):
        self.program, self.variables, self.corners, self.open = program, variables, corners, opened
        self.orientation = determinant_sign(program, corners)
        self.weights = [program.sign(corner[0]) for corner in corners]
        if self.orientation == 0 or min(self.weights) < 0:
            raise Refused("corners of a simplex that are not independent, or a negative weight")

    @staticmethod
    def read(program, value, below):
        variables, corners, opened = members(value, "variables", "corners", "open")
        size = len(listed(variables)) + 1
        variables = [program.symbol(text(name)) for name in variables]
        if any(v in program.generators or v in program.functions for v in variables):
            raise Refused("a variable with the name of a generator or a function")
        corners = [[program.number(whole(term, 0, below)) for term in listed(corner, size)]
                   for corner in listed(corners, size)]
        return Simplex(program, variables, corners, [truth(is_open) for is_open in listed(opened, size)])

    def holds(self, point):
        """Whether the point {variable: number} lies in it: by the signs of its coordinates, after Cramer's rule."""
        target = [Polynomial.constant(1)] + [point[v] for v in self.variables]
        for i, is_open in enumerate(self.open):
            rows = self.corners[:i] + [target] + self.corners[i + 1:]
            sign = determinant_sign(self.program, rows) * self.orientation
            if sign < 0 or (is_open and sign == 0):
                return False
        return True


class Domain:
    """`factors`, and `conditions` as pairs (polynomial, relation). `terms` are those of its conditions as written."""

    def __init__(self, program, factors, where, below):
        self.program = program
        self.factors = [Simplex.read(program, factor, below) for factor in listed(factors)]
        self.conditions, self.terms = [], []
        for condition in listed(where):
            formula, relation = members(condition, "formula", "relation")
            need(relation in RELATIONS, "no relation")
            self.terms.append(whole(formula, 0, below))
            self.conditions.append((program.term(formula), relation))
        if len(set(self.variables())) != len(self.variables()):
            raise Refused("two factors with one variable")

    def variables(self):
        return [v for factor in self.factors for v in factor.variables]

    def in_factors(self, point):
        return all(factor.holds(point) for factor in self.factors)

    def meets(self, point):
        """Whether a point {symbol: number} meets the conditions."""
        tower = self.program.tower
        return all(relation_holds(tower.sign(tower.reduce(f.replace(point))), r) for f, r in self.conditions)
