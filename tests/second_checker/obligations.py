# SPDX-License-Identifier: GPL-3.0-or-later
"""Each kind of obligation by each kind of evidence: True, it holds; False, it fails; None, it is open."""
import elimination
import gluing
import isolation
import mesh
import solutions
from domain import Domain
from points import read_point
from polynomial import NotJudged
from program import RELATIONS, relation_holds
from reading import listed, members, need, only_member, whole
from reductions import Region, shows_safely
from tower import Open, Refused


def zero(program, term, kind, evidence):
    index = whole(term, 0, program.of_statement)
    formula = program.term(index)
    functions = program.functions_of([index])
    if kind == "witness":
        point = read_point(program, evidence, [index], program.variables(formula))
        return False if program.sign(program.tower.reduce(formula.replace(point))) else None
    need(kind == "computation", "no proof of a zero")
    if not formula:
        return True
    apart = list(set(program.variables(formula)) | set(program.functions))
    signs = []
    for coefficient in formula.by_monomial(apart).values():
        try:
            signs.append(program.sign(coefficient))
        except Open:
            signs.append(None)
    if all(s == 0 for s in signs):
        return True
    return False if any(signs) and not functions else None


def sign(program, content, kind, evidence, proof):
    formula, relation, factors, where = members(content, "formula", "relation", "factors", "where")
    need(relation in RELATIONS, "no relation")
    index = whole(formula, 0, program.of_statement)
    formula = program.term(index)
    domain = Domain(program, factors, where, program.of_statement)
    terms = [index] + domain.terms
    functions = program.functions_of(terms)
    if kind == "witness":
        return False if sign_fails(program, domain, formula, relation, terms, evidence) else None
    if kind == "computation":
        if not program.is_number(formula):
            return None
        if relation_holds(program.sign(formula), relation):
            return True
        empty = domain.factors or functions or not all(program.is_number(f) for f, _ in domain.conditions)
        return None if empty or not domain.meets({}) else False
    bounded = set(domain.variables()) | set(functions)
    held = [formula, *(f for f, _ in domain.conditions), *(program.functions[f][1] for f in functions)]
    lines = {v for f in held for v in program.variables(f)} - bounded
    region = Region.of(program, domain.factors, domain.conditions, functions, lines)
    if not region.holds(formula):
        return None
    return True if shows_safely(region, formula, relation, proof) else None


def sign_fails(program, domain, formula, relation, terms, evidence):
    """A point where the relation fails; for !=, two where the formula has opposite signs."""
    first, other = members({"point": None, "other": [], **evidence}, "point", "other")
    at = []
    for place in [first, *listed(other)]:
        point = read_point(program, place, terms, program.variables(formula) | set(domain.variables()))
        if not domain.in_factors(point) or not domain.meets(point):
            return False
        at.append(program.sign(program.tower.reduce(formula.replace(point))))
        if not relation_holds(at[0], relation):
            return True
    convex = relation == "!=" and not domain.conditions and not program.functions_of(terms)
    return len(at) == 2 and convex and at[0] * at[1] == -1


def distinct(program, tuples):
    """All are compared, so the tuples must be of one length."""
    rows = [[program.number(whole(t, 0, program.of_statement)) for t in listed(row)] for row in listed(tuples)]
    if len({len(row) for row in rows}) > 1:
        raise Refused("tuples of different lengths")
    known = True
    for i, a in enumerate(rows):
        for b in rows[:i]:
            apart = False
            for x, y in zip(a, b):
                try:
                    apart = apart or program.sign(x - y) != 0
                except Open:
                    apart = None if not apart else True
            if apart is False:
                return False
            known = known and apart
    return True if known else None


def decide(program, content, proof):
    """Of one obligation; raises NotJudged, or Refused, or Open."""
    name, what = only_member(content)
    kind, evidence = only_member(proof) if isinstance(proof, str) or len(proof) == 1 else (None, None)
    if kind == "nothing":
        members(evidence, "reason", "detail")
        return None
    if kind == "witness":
        point, other = members(evidence, "point", "other")
        if name != "sign":
            listed(other, 0)
            evidence = point
    if name == "zero":
        return zero(program, what, kind, evidence)
    if name == "sign":
        return sign(program, what, kind, evidence, proof)
    if name == "solutions" and kind in ("roots", "wrong_solution"):
        return solutions.judge(program, what, kind, evidence)
    if name == "only_solutions" and kind in ("elimination", "witness"):
        return elimination.judge(program, what, kind, evidence)
    if name == "one_solution" and kind == "isolation":
        return isolation.judge(program, what, evidence)
    if kind == "computation" and name == "gluing":
        return gluing.holds(what)
    if kind == "computation" and name == "distinct":
        return distinct(program, what)
    if kind == "computation" and name == "mesh":
        return mesh.holds(program, what)
    raise NotJudged(f"{name} by {kind}")
