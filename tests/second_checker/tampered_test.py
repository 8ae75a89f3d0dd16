# SPDX-License-Identifier: GPL-3.0-or-later
"""A certificate that was tampered with is not what it says: refused, or of another verdict."""
import copy
import json
import unittest
from pathlib import Path

from judge import Judgement
from reading import Malformed

REPORTS = Path(__file__).parents[2] / "reports"


def certificates(paper, wanted=lambda c: True, most=6):
    """Some of the certificates of a paper, small ones."""
    found = []
    for path in sorted((REPORTS / paper / "certificates").glob("*.json"), key=lambda p: (p.stat().st_size, p.name)):
        value = json.loads(path.read_text(encoding="utf-8"))
        if wanted(value):
            found.append(value)
        if len(found) == most:
            break
    return found


def agrees(value):
    try:
        return Judgement(json.dumps(value)).agrees()
    except Malformed:
        return False


def has_proof(name):
    return lambda c: c["verdict"] == "proven" and any(isinstance(p, dict) and name in p for p in c["evidence"]["proofs"])


def has_split(certificate):
    return any("split" in step for proof in certificate["evidence"]["proofs"] if "pieces" in proof
               for step in proof["pieces"]["steps"] if step != "plain")


class Tampered(unittest.TestCase):
    def each(self, originals, change):
        """None of them is accepted any more when it has been changed, and all are before."""
        self.assertTrue(originals)
        for original in originals:
            with self.subTest(original["claim"]):
                self.assertTrue(agrees(original))
                changed = copy.deepcopy(original)
                change(changed)
                self.assertFalse(agrees(changed))

    def test_a_claim_of_the_opposite_verdict_is_contradicted(self):
        def change(c):
            c["verdict"] = {"proven": "refuted", "refuted": "proven"}[c["verdict"]]
        self.each(certificates("geodesic-patches") + certificates("vertex-truncation"), change)

    def test_a_goal_that_is_flipped_has_the_opposite_verdict(self):
        def change(c):
            c["statement"]["goal"] = {"not": c["statement"]["goal"]}
        self.each(certificates("spline-surfaces", lambda c: c["verdict"] == "proven"), change)

    def test_a_tree_without_its_last_leaf_shows_nothing(self):
        def change(c):
            for proof in c["evidence"]["proofs"]:
                if isinstance(proof, dict) and "pieces" in proof:
                    proof["pieces"]["steps"].pop()
        self.each(certificates("platonic-spheroids", has_split), change)

    def test_a_tree_with_a_leaf_too_many_shows_nothing(self):
        def change(c):
            for proof in c["evidence"]["proofs"]:
                if isinstance(proof, dict) and "pieces" in proof:
                    proof["pieces"]["steps"].append("plain")
        self.each(certificates("platonic-spheroids", has_split), change)

    def test_a_step_that_is_not_there_is_refused(self):
        def change(c):
            for proof in c["evidence"]["proofs"]:
                if isinstance(proof, dict) and "pieces" in proof:
                    proof["pieces"]["steps"][-1] = "plainly"
        self.each(certificates("platonic-spheroids", has_split), change)

    def test_the_evidence_of_another_claim_shows_nothing(self):
        several = certificates("sphere-approximation", has_proof("roots"), 4)
        for one, other in zip(several, several[1:]):
            if one["statement"] != other["statement"]:
                self.assertFalse(agrees({**one, "evidence": other["evidence"]}))

    def test_other_digits_in_a_root_are_no_root(self):
        def change(c):
            generator = c["statement"]["generators"][0]
            generator["low"] = generator["high"]
            generator["high"] = str(int(generator["high"].split("/")[0]) + 7)
        self.each(certificates("platonic-spheroids", lambda c: c["statement"]["generators"]), change)

    def test_other_digits_in_evidence_are_no_evidence(self):
        """Each rational among the nodes of the evidence, in turn; some may stand where only a sign counts."""
        for original in certificates("sphere-approximation", has_proof("roots"), 3):
            kept = 0
            numbers = [i for i, node in enumerate(original["evidence"]["nodes"]) if isinstance(node, str)]
            for i in numbers:
                changed = copy.deepcopy(original)
                changed["evidence"]["nodes"][i] = "31415/27182"
                kept += bool(agrees(changed))
            self.assertTrue(not numbers or kept < len(numbers))

    def test_a_member_too_many_or_too_few_is_refused(self):
        for change in (lambda c: c.update(more=1), lambda c: c.pop("using"), lambda c: c["statement"].update(more=1),
                       lambda c: c["evidence"].pop("nodes"), lambda c: c["evidence"]["proofs"].append("computation")):
            self.each(certificates("geodesic-patches", most=2), change)

    def test_a_generator_of_the_evidence_does_not_take_the_name_of_a_variable(self):
        def change(c):
            first = len(c["statement"]["nodes"]) + len(c["evidence"]["nodes"])
            variable = next(n["symbol"] for n in c["statement"]["nodes"] if isinstance(n, dict) and "symbol" in n)
            c["evidence"]["nodes"] += [{"symbol": variable}]
            c["evidence"]["generators"].append({"name": variable, "polynomial": first, "low": "-1", "high": "1"})
        self.each(certificates("geodesic-patches", lambda c: not c["statement"]["generators"] and any(
            "symbol" in n for n in c["statement"]["nodes"] if isinstance(n, dict))), change)


if __name__ == "__main__":
    unittest.main()
