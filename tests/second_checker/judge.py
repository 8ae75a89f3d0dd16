# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges certificates by docs/certificates.md alone: usage: judge.py CERTIFICATE...

Each obligation holds, fails, or is open; or this checker does not know its kind, or finds it too big: not judged.

    reading       the text, rationals, digests       domain        simplices, conditions
    polynomial    polynomials in symbols             pieces        trees of splits
    enclosure     intervals                          reductions    proofs of a sign by others
    elementary    exp, log, sin, cos, pi             points        witnesses
    tower         numbers: normal forms, signs       solutions, elimination, isolation     systems of equations
    program       nodes, generators, functions       gluing, mesh, convex                  what is counted
    obligations   what shows which obligation
"""
import sys
from collections import Counter

from obligations import decide
from polynomial import Effort, NotJudged
from program import Program
from reading import Malformed, certificate, digest, listed, need, only_member, whole
from tower import Open, Refused

EFFORT = 10_000_000
HOLDS, FAILS, OPEN, NOT_JUDGED = "holds", "fails", "open", "not judged"
VALUE = {True: HOLDS, False: FAILS, None: OPEN}


def evaluate(goal, values, depth=0):
    """A goal in the four values: what is not judged might be any of the other three."""
    need(depth <= 200, "goals that are nested too deep")
    if not isinstance(goal, dict):
        return values[whole(goal, 0, len(values))]
    kind, inner = only_member(goal)
    if kind in ("all", "any"):
        parts = {evaluate(g, values, depth + 1) for g in listed(inner)}
        first, last = (FAILS, HOLDS) if kind == "all" else (HOLDS, FAILS)
        return next((v for v in (first, NOT_JUDGED, OPEN) if v in parts), last)
    value = evaluate(inner, values, depth + 1)
    if kind == "not":
        return {HOLDS: FAILS, FAILS: HOLDS}.get(value, value)
    need(kind == "suffices", "no goal: " + kind)
    return OPEN if value == FAILS else value


class Judgement:
    """`verdict`: proven, refuted, undecided, or not judged; `values` of the obligations; `why` not judged."""

    def __init__(self, data):
        self.certificate = certificate(data)
        self.values, self.why = [], Counter()
        statement, proofs = self.certificate["statement"], self.certificate["evidence"]["proofs"]
        Effort.left = EFFORT
        obligations = listed(statement["obligations"])
        listed(proofs, len(obligations))
        guards = [whole(g, 0, len(obligations)) for g in listed(statement["guards"])]
        self.kinds = [(only_member(o)[0], p if isinstance(p, str) else next(iter(p))) for o, p in zip(obligations, proofs)]
        try:
            program = Program(self.certificate)
        except (NotJudged, RecursionError) as reason:
            self.values, self.verdict = [NOT_JUDGED] * len(obligations), NOT_JUDGED
            self.why[str(reason)] += 1
            return
        except (Refused, Open) as reason:
            raise Malformed(str(reason)) from None
        for content, proof in zip(obligations, proofs):
            self.values.append(self.value(program, content, proof))
        whether = evaluate({"all": guards}, self.values), evaluate(statement["goal"], self.values)
        if whether[0] in (FAILS, OPEN) or whether[1] == OPEN:
            self.verdict = "undecided"
        elif NOT_JUDGED in whether:
            self.verdict = NOT_JUDGED
        else:
            self.verdict = "proven" if whether[1] == HOLDS else "refuted"

    def value(self, program, content, proof):
        try:
            return VALUE[decide(program, content, proof)]
        except NotJudged as reason:
            self.why[str(reason)] += 1
            return NOT_JUDGED
        except (Malformed, Refused, Open) as reason:  # what is not understood shows nothing
            self.why["open: " + str(reason)] += 1
            return OPEN

    def agrees(self):
        """True or False, or None where it was not judged. What is conditional is proven from another claim."""
        said = {"conditional": "proven"}.get(self.certificate["verdict"], self.certificate["verdict"])
        return None if self.verdict == NOT_JUDGED else said == self.verdict


def main(paths):
    worst = 0
    for path in paths:
        with open(path, encoding="utf-8") as file:
            try:
                judgement = Judgement(file.read())
            except Malformed as error:
                print(f"{path}: invalid: {error}")
                worst = 1
                continue
        statement = digest(judgement.certificate["statement"])
        counts = ", ".join(f"{n} {value}" for value, n in sorted(Counter(judgement.values).items()))
        print(f"{path}: {judgement.verdict} {statement} ({counts})")
        for why, n in judgement.why.items():
            print(f"  {n} times {why}")
        worst = max(worst, judgement.agrees() is False)
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
