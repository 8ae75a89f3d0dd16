# SPDX-License-Identifier: GPL-3.0-or-later
"""The evaluator by itself: what holds, what fails, and what it must not claim to know."""
import os
import tempfile
import unittest
from fractions import Fraction

import campaign
import enclosures
import evaluate


def said(text, identity="a", seeking=False):
    what, why = evaluate.evaluate(evaluate.File(text), identity, "printed", seeking)
    return "unknown" if why == "as far as is seen" else what


evaluate.allow_deep_formulas()


class Evaluator(unittest.TestCase):
    def test_enclosures_hold_the_values_of_elementary_functions(self):
        for name, x, digits in (("exp", Fraction(1), "2.718281828459045235360287471352"), ("log", Fraction(10), "2.302585092994045684017991454684"),
                                ("sin", Fraction(1), "0.841470984807896506652502321630"), ("cos", Fraction(-5), "0.283662185463226264466639171513"),
                                ("pi", None, "3.141592653589793238462643383279")):
            value, printed = enclosures.elementary(name, x), Fraction(digits)
            self.assertLess(abs(Fraction(value.low, enclosures.ONE) - printed), Fraction(1, 10 ** 29))
            self.assertLess(value.high - value.low, enclosures.ONE >> 250)

    def test_what_holds(self):
        for statement in ("1/3 ~ 0.33", "-2^2 = -4 and 2^3^2 = 512 and 6/2*3 = 9", "sqrt(2)*sqrt(3) = sqrt(6)", "for all x: x^2 >= 0",
                          "for (u,v) in triangle: u*v*(1 - u - v) <= 1/27", "for all x, y: x + y = 1 implies x^2 - y^2 = x - y",
                          "counts(truncate(cube)) = (24, 36, 14)", "solve x: x^2 = 2 where x > 0 gives sqrt(2)", "for some k in 1..9: k^2 = 49",
                          "solve x, y: x + y = 3 and x - y = 1 gives (2, 1)", "planar(dodecahedron) and convex(icosahedron)",
                          "for all x: sin(2*x) = 2*sin(x)*cos(x)", "max(x*(1 - x) for x in [0, 1]) ~ 0.25"):
            self.assertEqual(said("claim a: " + statement), "holds", statement)

    def test_what_fails(self):
        for statement in ("1/3 ~ 0.34", "for all x: x^2 > x", "sqrt(2) = 1.414213562373095", "for (u,v) in triangle: u + v < 1",
                          "solve x: x^2 = 2 gives 1, 2", "convex(tetrahedron) implies trivalent(octahedron)", "for k in 1..9: k^2 < 81",
                          "for all x, y: x + y = 1 implies x = y", "det([1, 2; 3, 4]) = 2", "1.584 = log(3)/log(2)"):
            self.assertEqual(said("claim a: " + statement, seeking=True), "fails", statement)

    def test_what_it_does_not_know(self):
        for statement in ("for all x: x = x + 1 implies x = 7", "solve x: x^2 = 4 gives 2", "for some x: x^3 = 2",
                          "for some x in [0, 1]: x^2 = 1/2", "for all x: 1/(x - x) = 1"):
            self.assertEqual(said("claim a: " + statement), "unknown", statement)

    def test_an_assumption_that_was_never_met_confirms_nothing(self):
        self.assertEqual(said("param x\nclaim a: x^2 + 1 = 0 implies x = 5"), "unknown")

    def test_patches_by_their_nets(self):
        net = "let p = triangle_patch [ (0,0,3), (0,2,3), (0,3,2), (0,3,0); (2,0,3), (3,3,3), (2,3,0); (3,0,2), (3,2,0); (3,0,0) ]\n"
        net += "let q = reflect(p, plane (1, 0, 0) 0)\nlet S = orbit(p, rotations(octahedron))\n"
        for statement in ("regular(p)", "G2(p, q)", "count(patches(S)) = 8 and closed(S) and G2(S)", "9*max(gauss(S)) ~ 1.69",
                          "for all u: D2(p)(u,0) + D2(q)(u,0) = 2*u*D1(p)(u,0)", "degree(p) = 3 and control(p, 1, 1) = (3, 3, 3)"):
            self.assertEqual(said(net + "claim a: " + statement), "holds", statement)
        for statement in ("G2(p, reflect(p, plane (1, 0, 0) 0) + (0, 0, 1/10))", "for all u: D2(p)(u,0) = D2(q)(u,0)"):
            self.assertNotEqual(said(net + "claim a: " + statement), "holds", statement)

    def test_a_wrong_verdict_is_a_finding(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "m.seam"), "w", encoding="utf-8") as file:
                file.write("param x\nclaim a: (x + 1)^2 = x^2 + 1\nclaim b: 1/3 ~ 0.33\n")
            confirm = lambda identity, verdict: campaign.confirm((folder, "m.seam", identity, "printed", verdict, 10))[0]
            self.assertEqual(confirm("a", "proven"), "findings")
            self.assertEqual(confirm("b", "refuted"), "findings")
            self.assertEqual(confirm("a", "refuted"), "confirmed by evaluation")
            self.assertEqual(confirm("b", "proven"), "confirmed by evaluation")


if __name__ == "__main__":
    unittest.main()
