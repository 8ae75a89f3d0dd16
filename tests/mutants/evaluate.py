# SPDX-License-Identifier: GPL-3.0-or-later
"""Evaluates the claims of .seam files at many points, by docs/language.md alone: shares no line with the programs.

    python3 evaluate.py FILE.seam [RESULTS.json]     each claim; with results of `seamproof verify --json`, beside their verdicts

What it says of a claim: `holds` (at all points looked at), `fails` (certainly, at one; or as far as is seen), `unknown`. Where the verdict is
proven and the claim certainly fails, or refuted and it certainly holds, that is CONTRARY, and the exit status 1."""
import itertools
import json
import resource
import signal
import sys

import enclosures as N
import formulas as F
import reading
from meaning import Meaning
from comparing import FALSE, TRUE, UNLIKELY
from truth import Truth
from values import TooLarge, Unsupported

SEED = 1
ROUNDS = 4
SECONDS = 20


class TooLong(Exception):
    pass


def names_in(tree, found):
    if isinstance(tree, tuple) and len(tree) == 2 and tree[0] == "name":
        found.add(tree[1])
    if isinstance(tree, (tuple, list)):
        for part in tree:
            names_in(part, found)
    if isinstance(tree, dict):
        for part in tree.values():
            names_in(part, found)


class File:
    def __init__(self, text):
        self.items = reading.read(text)
        self.claims = {}  # id: {printed: tree, corrected: tree}, and of a cell the scope it stands in
        for item in self.items:
            if item[0] == "claim":
                self.claims[item[1]["id"]] = (item[1], None)
            if item[0] == "table":
                self.add_cells(item)
        self.of = {}
        for item in self.items:
            for name in item[1] if item[0] == "param" else [item[1]] if item[0] in ("let", "sequence", "root") else []:
                self.of[name] = item

    def add_cells(self, item):
        _, identity, binding, labels, rows = item
        for r, (label, value, cells, is_truncated) in enumerate(rows):
            for k, cell in enumerate(cells):
                row = reading.slug(label) or str(r + 1)
                column = (reading.slug(labels[k]) if k < len(labels) else "") or str(k + 1)
                claim = {which: ("relation", ["~"], [value, part], is_truncated) for which, part in cell.items()}
                self.claims["%s.%s.%s" % (identity, row, column)] = (claim, (binding, k))

    def needed(self, trees):
        found, todo = set(), set()
        names_in(trees, todo)
        while todo:
            name = todo.pop()
            if name in self.of and name not in found:
                found.add(name)
                names_in(self.of[name], todo)
        return found

    def choices(self, trees):
        """Values for the integer parameters and meshes that a statement speaks of."""
        options = {}
        for name in sorted(self.needed(trees)):
            item = self.of[name]
            if item[0] != "param" or item[2][:1] not in (["integer"], ["mesh"]):
                continue
            options[name] = self.integers(name, item) if item[2] == ["integer"] else self.meshes(name, item)
        names = sorted(options)
        combinations = list(itertools.product(*[options[n] for n in names]))
        step = max(1, len(combinations) // 8)
        return [dict(zip(names, c)) for c in combinations[::step]]

    def allowed(self, name, item, value):
        if item[4] is None:
            return True
        try:
            truth = Truth(Meaning(self.items, {name: value}), SEED)
            return truth.holds(item[4], {}, {}) > 0
        except KeyError:
            return True  # speaks of other parameters too

    def integers(self, name, item):
        values = range(-3, 12)
        if item[3] is not None:
            meaning = Meaning(self.items, {})
            values = [int(F.value(x)) for x in meaning.finite(item[3], {})]
        fit = [n for n in values if self.allowed(name, item, n)]
        return sorted(sorted(fit, key=lambda n: abs(n - 1))[:5] + fit[-1:])

    def meshes(self, name, item):
        return [s for s in ("tetrahedron", "cube", "octahedron", "dodecahedron") if self.allowed(name, item, s)]


def evaluate(file, identity, which="printed", seeking=False):
    """(`holds`, `fails` or `unknown`, why unknown). `seeking`: points where it fails are wanted."""
    claim, cell = file.claims[identity]
    statement = claim[which]
    truths, is_general, assumed, met, without_value = [], False, 0, 0, 0
    try:
        with_limit()
        for chosen in file.choices([statement, cell[0] if cell else None]):
            meaning = Meaning(file.items, chosen)
            scope = {}
            if cell and cell[0]:
                names, domain, _ = cell[0][0]
                scope = {names[0]: meaning.finite(domain, {})[cell[1]]}
            is_general = is_general or bool(chosen)
            for seed in range(4 * ROUNDS if seeking else ROUNDS):
                truth = Truth(meaning, SEED + seed, special=0.5 if seeking else 0.15)
                point = {}
                try:
                    here = truth.holds(statement, scope, point)
                except N.Undefined as error:
                    if not point:
                        return "unknown", str(error)
                    without_value += isinstance(error, N.Nothing)
                    continue
                except TooLarge:
                    if not truths:
                        raise
                    break
                truths.append(here)
                assumed, met, without_value = assumed + truth.assumed, met + truth.met, without_value + truth.without_value
                is_general = is_general or bool(point)
                if here == FALSE:
                    return "fails", ""
                if not point and here == TRUE:
                    break
    except (Unsupported, NotImplementedError) as error:
        return "unknown", str(error)
    except TooLong:
        return "unknown", "it takes too long"
    except RecursionError:
        return "unknown", "a formula too deep"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    if not truths:
        return "unknown", "no point where it means something"
    if without_value:
        return "unknown", "something in it has no value at some point"
    if assumed and not met:
        return "unknown", "no point was found where what is assumed is met"
    if sum(x > 0 for x in truths) * 2 > len(truths) and min(truths) >= 0:
        return "holds", "" if is_general or min(truths) < TRUE else "certainly"
    if min(truths) == UNLIKELY:
        return "fails", "as far as is seen"
    return "unknown", "what was seen decides nothing"


def with_limit():
    def late(*_):
        raise TooLong()
    signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, SECONDS)


def main(path, results=None):
    file = File(open(path, encoding="utf-8").read())
    verdicts = {}
    if results:
        for claim in json.load(open(results, encoding="utf-8"))["files"][0]["claims"]:
            verdicts[claim["id"], "printed"] = claim["verdict"]
            if claim.get("corrected"):
                verdicts[claim["id"], "corrected"] = claim["corrected"]
    counts, disagreements = {}, 0
    for identity, (claim, _) in file.claims.items():
        for which in ("printed", "corrected"):
            if which not in claim:
                continue
            verdict = verdicts.get((identity, which), "")
            said, why = evaluate(file, identity, which, verdict == "refuted")
            contradicts = (verdict, said, why) == ("proven", "fails", "") or (verdict, said, why) == ("refuted", "holds", "certainly")
            disagreements += contradicts
            counts[verdict, said] = counts.get((verdict, said), 0) + 1
            print("%-9s %-9s %-7s %s%s%s" % ("CONTRARY" if contradicts else "", verdict, said, identity,
                                             "" if which == "printed" else " (corrected)", "  " + why if why else ""), flush=True)
    for (verdict, said), n in sorted(counts.items()):
        print("%5d %s %s" % (n, verdict, said))
    return 1 if disagreements else 0


def allow_deep_formulas():
    hard = resource.getrlimit(resource.RLIMIT_STACK)[1]
    wanted = 512 << 20
    resource.setrlimit(resource.RLIMIT_STACK, (wanted if hard == resource.RLIM_INFINITY else min(wanted, hard), hard))
    sys.setrecursionlimit(60000)


if __name__ == "__main__":
    allow_deep_formulas()
    sys.exit(main(*sys.argv[1:]))
