# SPDX-License-Identifier: GPL-3.0-or-later
"""Each rule shows what is true, and not what is false beside it. The certificates are written by hand."""
import json
import unittest

from judge import Judgement

NODES = ["0", "1", "-1", {"symbol": "x"}, {"product": [3, 3]}, {"sum": [4, 2]}, {"sum": [3, 2]}, {"product": [6, 6]},
         "2", {"symbol": "y"}, {"product": [3, 9]}, {"product": [2, 3]}, {"sum": [1, 11]}, {"sum": [3, 9]},
         {"product": [2, 9]}, {"sum": [3, 14]}, {"power": [3, 3]}]
ZERO, ONE, LESS_ONE, X, XX, XX_1, X_1, SQUARE, TWO, Y, XY, _, ONE_X, X_AND_Y, _, X_Y, CUBE = range(17)
UNIT = {"variables": ["x"], "corners": [[1, 0], [1, 1]], "open": [False, False]}
INNER = {**UNIT, "open": [True, True]}
RAY = {**UNIT, "corners": [[1, 0], [0, 1]]}
UNIT_Y = {**UNIT, "variables": ["y"]}


def verdict(obligation, proof, **statement):
    whole = {"generators": [], "nodes": NODES, "obligations": [obligation], "guards": [], "goal": 0, **statement}
    return Judgement(json.dumps({
        "format": "seamproof certificate 1", "claim": "rule", "correction": False, "verdict": "proven", "using": [],
        "statement": whole, "evidence": {"generators": [], "nodes": [], "proofs": [proof]}})).verdict


def sign(formula, relation, factors, proof, where=()):
    conditions = [{"formula": f, "relation": r} for f, r in where]
    return verdict({"sign": {"formula": formula, "relation": relation, "factors": factors, "where": conditions}}, proof)


def pieces(*steps, side=">", **square):
    return {"pieces": {"side": side, "steps": list(steps), **square}}


def at(**values):
    return {"witness": {"point": {"variables": list(values), "values": list(values.values())}, "other": []}}


class Rules(unittest.TestCase):
    def proven(self, *case, **more):
        self.assertEqual(sign(*case, **more), "proven")

    def open(self, *case, **more):
        self.assertEqual(sign(*case, **more), "undecided")

    def test_a_strict_sign_takes_a_positive_coefficient_on_each_face_of_the_domain(self):
        self.proven(X, ">=", [UNIT], pieces("plain"))
        self.open(X, ">", [UNIT], pieces("plain"))
        self.proven(X, ">", [INNER], pieces("plain"))
        self.proven(X, ">", [{**UNIT, "open": [False, True]}], pieces("plain"))  # without x = 0
        self.open(X, ">", [{**UNIT, "open": [True, False]}], pieces("plain"))

    def test_infinity_is_no_point(self):
        self.proven(ONE, ">", [RAY], pieces("plain"))
        self.open(X, ">", [RAY], pieces("plain"))
        self.proven(X, ">", [{**RAY, "open": [False, True]}], pieces("plain"))

    def test_a_condition_excludes_faces(self):
        self.proven(X, ">", [UNIT], pieces("plain"), where=[(X, "!=")])
        self.open(X, ">", [UNIT], pieces("plain"), where=[(X_1, "!=")])
        self.proven(X_AND_Y, ">", [UNIT, UNIT_Y], pieces("plain"), where=[(XY, "!=")])
        self.open(X_AND_Y, ">", [UNIT, UNIT_Y], pieces("plain"))

    def test_a_piece_is_outside_where_a_condition_is_broken_everywhere(self):
        self.proven(X_1, "<", [{**UNIT, "corners": [[1, 1], [1, 8]]}], pieces({"outside": 0}), where=[(X, "<")])
        self.open(X_1, "<", [UNIT], pieces({"outside": 0}), where=[(X, "<=")])

    def test_splits_need_all_their_parts(self):
        self.proven(SQUARE, ">=", [UNIT], pieces({"split": 0, "at": [1, 1]}, "plain", "plain"))
        self.open(SQUARE, ">=", [UNIT], pieces({"split": 0, "at": [1, 1]}, "plain"))
        self.open(SQUARE, ">=", [UNIT], pieces("plain", "plain"))
        self.open(SQUARE, ">=", [UNIT], pieces({"split": 0, "at": [0, 0]}))
        self.open(SQUARE, ">=", [UNIT], pieces({"split": 0, "at": [2, 2]}, "plain"))

    def test_a_square_is_split_off_for_weak_signs_alone(self):
        self.proven(SQUARE, ">=", [UNIT], pieces("plain", square=X_1, cofactor=ONE))
        self.open(SQUARE, ">", [UNIT], pieces("plain", square=X_1, cofactor=ONE))
        self.open(SQUARE, ">=", [UNIT], pieces("plain", square=X, cofactor=ONE))

    def test_other_variables_are_not_bounded_by_pieces(self):
        self.open(Y, ">=", [UNIT], pieces("plain"))
        self.open(XY, ">=", [UNIT], pieces("plain"))

    def test_witnesses_lie_in_the_domain(self):
        self.assertEqual(sign(X, ">", [UNIT], at(x=0)), "refuted")
        self.open(X, ">", [INNER], at(x=0))
        self.open(X, "<", [UNIT], at(x=2))
        self.open(X, ">", [UNIT], at(y=0))
        self.open(X, ">", [UNIT], at(x=0), where=[(X, "!=")])
        self.assertEqual(verdict({"zero": XX_1}, at(x=0)), "refuted")
        self.assertEqual(verdict({"zero": XX_1}, at(x=1)), "undecided")

    def test_a_number_fails_where_there_is_a_point(self):
        self.assertEqual(sign(LESS_ONE, ">", [], "computation"), "refuted")
        self.open(LESS_ONE, ">", [UNIT], "computation")
        self.open(LESS_ONE, ">", [], "computation", where=[(LESS_ONE, ">")])
        self.open(LESS_ONE, ">", [], "computation", where=[(X, ">")])

    def test_reductions_show_what_they_say(self):
        plain = pieces("plain")
        self.proven(X, ">", [INNER], {"multiplier": X, "positive": plain, "product": plain})
        self.open(X_1, "<", [UNIT], {"multiplier": X, "positive": plain, "product": plain})
        self.proven(XX, ">", [INNER], {"factors": [X, X], "parts": [plain, plain]})
        self.open(XX, ">", [INNER], {"factors": [X], "parts": [plain]})
        self.open(XX, ">", [INNER], {"factors": [X, X], "parts": [plain]})
        self.proven(SQUARE, ">=", [], {"squares": [X_1], "weights": [ONE]})
        self.open(SQUARE, "<=", [], {"squares": [X_1], "weights": [ONE]})
        self.open(SQUARE, ">", [], {"squares": [X_1], "weights": [ONE]})

    def test_conditions_serve_in_their_direction(self):
        minus, same = {"condition": 0, "times": LESS_ONE}, {"condition": 0, "times": ONE}
        self.proven(X, ">=", [], same, where=[(X, ">")])
        self.open(X, ">", [], same, where=[(X, ">=")])
        self.open(X, ">", [], minus, where=[(X, ">")])
        self.open(X, "<", [], same, where=[(X, ">")])
        self.proven(X, "!=", [], same, where=[(X, "<")])
        plain = pieces("plain")
        once = {"combination": [0], "cofactors": [ONE], "parts": ["computation", plain]}
        self.proven(X, ">=", [UNIT], once, where=[(X, ">=")])
        self.open(X, ">=", [UNIT], {**once, "parts": ["computation"]}, where=[(X, ">=")])
        self.open(X, ">=", [UNIT], once, where=[(X, "<=")])

    def test_solutions_are_all_and_no_others(self):
        def of(solutions, **evidence):
            content = {"system": [XX_1], "unknown": "x", "for_all": [], "domain": RAY, "solutions": solutions}
            proof = {"divisor": XX_1, "cofactors": [ONE], "quotients": [ONE], "multiplicities": [1], "rest": 0,
                     "inside": [], "outside": [pieces("plain")], **evidence}
            return verdict({"solutions": content}, {"roots": proof},
                           nodes=NODES + [{"sum": [X, ONE]}])
        self.assertEqual(of([ONE], rest=17), "proven")
        self.assertEqual(of([ONE], rest=X), "undecided")
        self.assertEqual(of([LESS_ONE], rest=17), "undecided")
        self.assertEqual(of([ONE], rest=17, divisor=ONE), "undecided")
        self.assertEqual(of([], rest=XX_1, multiplicities=[]), "undecided")

    def test_goals_have_three_values(self):
        false, true = {"sign": {"formula": LESS_ONE, "relation": ">", "factors": [], "where": []}}, {"zero": ZERO}
        either, both = {"any": [0, {"not": 0}]}, {"all": [0, {"suffices": 0}]}
        for goal, expected in (({"all": []}, "proven"), ({"any": []}, "refuted"), ({"suffices": 0}, "undecided"),
                               ({"not": 0}, "proven"), (either, "proven"), (both, "refuted")):
            self.assertEqual(verdict(false, "computation", goal=goal), expected)
        self.assertEqual(verdict(false, "computation", goal={"all": []}, guards=[0]), "undecided")
        self.assertEqual(verdict(true, {"nothing": {"reason": "none", "detail": ""}}), "undecided")


if __name__ == "__main__":
    unittest.main()
