# SPDX-License-Identifier: GPL-3.0-or-later
"""That a system in several unknowns has no solutions but these: a tree of cases about a point supposed to solve it."""
from domain import Domain, Simplex
from pieces import COMPLEMENT
from points import read_point
from polynomial import Polynomial
from program import relation_holds
from reading import Malformed, listed, members, need, text, whole
from reductions import ONE, ZERO, Region, shows_safely
from solutions import coefficients
from tower import Open, Refused


class Obligation:
    def __init__(self, program, content):
        system, unknowns, for_all, factors, where, solutions = members(
            content, "system", "unknowns", "for_all", "factors", "where", "solutions")
        below = program.of_statement
        self.program = program
        self.unknowns = [program.symbol(text(name)) for name in listed(unknowns)]
        self.domain = Domain(program, factors, where, below)
        self.solutions = [self.read_solution(s) for s in listed(solutions)]
        self.terms = [whole(t, 0, below) for t in listed(system)] + self.domain.terms
        self.terms += [t for s in solutions for t in s["numerators"] + s["denominators"]]
        self.functions = program.functions_of(self.terms)
        self.equations = coefficients(program, system, for_all, below)
        self.free = [x for x in self.unknowns if x not in self.domain.variables()]
        inside = program.written([program.functions[f][2] for f in self.functions])
        self.for_all = [program.symbol(name) for name in for_all]
        names = self.unknowns + self.for_all
        taken = set(program.generators) | set(program.functions)
        if len(set(names)) != len(names) or taken & set(names) or set(self.for_all) & set(self.domain.variables()):
            raise Refused("unknowns and variables that are not different")
        if inside & (set(self.free) | set(self.for_all)):
            raise Refused("a function of an unknown without bounds")
        parameters = set(self.domain.variables()) - set(self.unknowns)
        self.symbols = parameters | set(self.unknowns) | set(self.functions) | set(program.generators)
        for f in self.equations + [f for f, _ in self.domain.conditions]:
            self.known(f)
        for solution in self.solutions:
            for part in solution[0] + solution[1]:
                if not part.support() <= self.symbols - set(self.unknowns):
                    raise Refused("a solution in something else than parameters")

    def read_solution(self, value):
        return [[self.program.term(whole(t, 0, self.program.of_statement)) for t in listed(part, len(self.unknowns))]
                for part in members(value, "numerators", "denominators")]

    def known(self, polynomial):
        if not polynomial.support() <= self.symbols:
            raise Refused("a formula that holds another variable")
        return polynomial

    def term(self, index):
        return self.known(self.program.term(whole(index, 0, len(self.program.nodes))))

    def shown(self, formula, relation, trees, conditions):
        """For each choice of signs of the unknowns without bounds that stand in the formula, a tree."""
        standing = [x for x in self.free if x in formula.support()]
        if len(listed(trees)) != 1 << len(standing):
            return False
        seen = set(self.domain.variables()) | set(self.functions) | set(standing) | set(self.program.generators)
        conditions = [(f, r) for f, r in conditions if f.support() <= seen]
        for n, tree in enumerate(trees):
            factors = list(self.domain.factors)
            for j, x in enumerate(standing):
                end = ONE if n >> j & 1 else -ONE
                factors.append(Simplex(self.program, [x], [[ONE, ZERO], [ZERO, end]], [False, False]))
            region = Region.of(self.program, factors, conditions, self.functions)
            if not shows_safely(region, formula, relation, tree):
                return False
        return True

    def combination(self, value, equations):
        numbers, cofactors = members(value, "equations", "cofactors")
        total = Polynomial()
        for number, cofactor in zip(numbers, listed(cofactors, len(listed(numbers)))):
            equation = equations[whole(number, 0, len(equations))]
            total = total + self.program.tower.reduce(equation * self.term(cofactor))
        return total

    def eliminates(self, steps):
        """Whether the steps, depth first, leave no case open. A case is what is known in it: equations, conditions."""
        todo, steps = [(self.equations, self.domain.conditions)], list(listed(steps))
        while todo:
            if not steps:
                return False
            step, (equations, conditions) = steps.pop(0), todo.pop()
            need(isinstance(step, dict), "no step")
            if "product" in step:
                cases = self.product(step, equations, conditions)
            elif "cases" in step:
                term = self.term(members(step, "cases")[0])
                cases = [(equations + [term], conditions), (equations, conditions + [(term, "!=")])]
            elif "solution" in step:
                cases = self.solution(step, equations)
            elif "outside" in step:
                cases = self.outside(step, equations, conditions)
            else:
                raise Malformed("no step")
            if cases is None:
                return False
            todo += reversed(cases)
        return not steps

    def product(self, step, equations, conditions):
        combination, factors = members(step, "combination", "product")
        product, cases = ONE, []
        for factor in listed(factors):
            formula, power, condition, trees = members(factor, "formula", "power", "condition", "trees")
            formula = self.term(formula)
            product = self.program.tower.reduce(product * formula ** whole(power, 1))
            if whole(condition, -1, len(conditions)) >= 0:
                other, relation = conditions[condition]
                if self.program.tower.reduce(formula - other) or relation_holds(0, relation):
                    return None
            elif listed(trees):
                if not self.shown(formula, "!=", trees, conditions):
                    return None
            else:
                cases.append((equations + [formula], conditions))
        if self.program.tower.reduce(self.combination(combination, equations) - product):
            return None
        return cases

    def solution(self, step, equations):
        k, numbers = members(step, "solution", "equations")
        parts = self.solutions[whole(k, 0, len(self.solutions))]
        for x, number, top, bottom in zip(self.unknowns, listed(numbers, len(self.unknowns)), *parts):
            equation = equations[whole(number, 0, len(equations))]
            if self.program.tower.reduce(bottom * Polynomial.symbol(x) - top - equation):
                return None
        return []

    def outside(self, step, equations, conditions):
        i, multiplier, combination, remainder, positive, broken = members(
            step, "outside", "multiplier", "combination", "remainder", "positive", "broken")
        formula, relation = conditions[whole(i, 0, len(conditions))]
        multiplier, remainder = self.term(multiplier), self.term(remainder)
        difference = multiplier * formula - self.combination(combination, equations) - remainder
        if self.program.tower.reduce(difference):
            return None
        good = (self.shown(multiplier, ">", positive, conditions)
                and self.shown(remainder, COMPLEMENT[relation], broken, conditions))
        return [] if good else None

    def fails_at(self, value):
        """Whether the point solves the system and is none of the solutions."""
        tower, sign = self.program.tower, self.program.sign
        point = read_point(self.program, value, self.terms, set(self.domain.variables()) | set(self.unknowns), self.for_all)
        if not self.domain.in_factors(point) or not self.domain.meets(point):
            return False
        if any(sign(tower.reduce(f.replace(point))) for f in self.equations):
            return False
        for tops, bottoms in self.solutions:
            differences = [b * Polynomial.symbol(x) - a for x, a, b in zip(self.unknowns, tops, bottoms)]
            if not any(sign(tower.reduce(d.replace(point))) for d in differences):
                return False
        return True


def judge(program, content, kind, evidence):
    """True: holds; False: fails; None: open."""
    obligation = Obligation(program, content)
    try:
        if kind == "witness":
            return False if obligation.fails_at(evidence) else None
        return True if obligation.eliminates(evidence) else None
    except Open:
        return None
