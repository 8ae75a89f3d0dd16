# SPDX-License-Identifier: GPL-3.0-or-later
"""Polynomials, towers of roots, and values of elementary functions."""
import math
import unittest
from fractions import Fraction

import elementary
from polynomial import Effort, NotJudged, Polynomial
from tower import Open, Refused, Tower

C, S = Polynomial.constant, Polynomial.symbol


class Arithmetic(unittest.TestCase):
    def setUp(self):
        Effort.left = 10 ** 7
        self.tower = Tower()

    def root(self, symbol, square, low, high):
        self.tower.add_root(symbol, S(symbol, 2) - square, Fraction(low), Fraction(high))

    def test_polynomials_keep_the_laws_of_a_ring(self):
        p, q, r = S(0) + C(Fraction(1, 3)), S(1, 2) - S(0), S(2) * C(5) - C(Fraction(7, 2))
        self.assertEqual((p + q) * r, r * p + q * r)
        self.assertEqual(p ** 3, p * p * p)
        self.assertEqual((p - p).terms, {})
        self.assertEqual((p * q).replace({0: r, 1: p}), (r + C(Fraction(1, 3))) * (p * p - r))

    def test_a_degree_that_does_not_fit_is_not_judged(self):
        with self.assertRaises(NotJudged):
            S(0, 40000) * S(0, 40000)

    def test_roots_of_roots_have_normal_forms_and_signs(self):
        self.root(0, C(2), 1, 2)
        self.root(1, C(3) + S(0) + S(0), 2, 3)                     # sqrt(3 + 2 sqrt 2) = 1 + sqrt 2
        self.root(2, C(6), 2, 3)
        self.assertFalse(self.tower.reduce(S(0) * S(0) - C(2)))
        self.assertEqual(self.tower.sign(S(0) * S(2) - C(Fraction(3464101615137754, 10 ** 15))), 1)
        with self.assertRaises(Open):                              # it is 0, but no normal form says so
            self.tower.sign(S(1) - S(0) - C(1))

    def test_a_rational_root_is_found(self):
        self.tower.add_root(0, S(0, 3) - C(8), Fraction(1), Fraction(3))
        self.assertEqual(self.tower.sign(S(0) - C(Fraction(199, 100))), 1)

    def test_bounds_with_no_root_or_three_or_a_double_one_are_refused(self):
        cubic = S(0, 3) - S(0)
        for polynomial, low, high in ((cubic, -2, 2), (cubic, 2, 3), (S(0, 2), -1, 1), (cubic * S(0), -2, 2),
                                      (S(0, 2) - C(2), 2, 1), ((S(0) - C(1)) ** 3, 0, 2)):
            with self.assertRaises(Refused):
                Tower().add_root(0, polynomial, Fraction(low), Fraction(high))

    def test_enclosures_of_functions_hold_their_values_and_are_narrow(self):
        for value in (0, 1, -1, Fraction(1, 3), 7, -20, Fraction(22, 7), 100):
            for bits in (64, 300):
                at = int(Fraction(value) * 2 ** bits)
                for name, function in elementary.FUNCTIONS.items():
                    if name == "log" and value <= 0:
                        continue
                    low, high = function((at, at), bits)
                    there = getattr(math, name)(Fraction(value))
                    self.assertLessEqual(low / 2 ** bits, there + 1e-12 * max(1, abs(there)))
                    self.assertGreaterEqual(high / 2 ** bits, there - 1e-12 * max(1, abs(there)))
                    self.assertLess(high - low, 16 + (abs(high) >> (bits - 8)))

    def test_functions_of_one_number_are_inverse_to_one_another(self):
        self.tower.add_value(0, "log", C(3))
        self.tower.add_value(1, "exp", S(0))                       # it is 3
        self.tower.add_value(2, "pi", None)
        self.tower.add_value(3, "sin", S(2) * C(Fraction(1, 6)))   # it is 1/2
        tiny = C(Fraction(1, 10 ** 60))
        for number, value in ((S(1), C(3)), (S(3), C(Fraction(1, 2)))):
            self.assertEqual(self.tower.sign(number - value - tiny), -1)
            self.assertEqual(self.tower.sign(number - value + tiny), 1)
        with self.assertRaises(Refused):
            self.tower.add_value(4, "log", S(0) - C(2))


if __name__ == "__main__":
    unittest.main()
