# SPDX-License-Identifier: GPL-3.0-or-later
"""What is changed in the sources, and that the list of mutants that no test can mind is one of mutants."""
import unittest
from pathlib import Path

from mutations import SWITCH, changes, mutants, mutants_in, switched

ROOT = Path(__file__).resolve().parents[2]


def changed(code):
    return {(kind, code[:start] + text + code[end:]) for kind, (start, end), text in changes(code)}


def mutants_of(source):
    return list(mutants_in("f.cpp", source))


class Mutations(unittest.TestCase):
    def test_a_demand_and_each_part_of_its_condition_are_dropped(self):
        self.assertEqual({("demand dropped", "(void)0;"), ("part of a condition dropped", "demand( true && b(), why);"),
                          ("part of a condition dropped", "demand(a && true , why);"), ("operator", "demand(a || b(), why);")},
                         {(kind, code.replace("  ", " ")) for kind, code in changed("demand(a && b(), why);")})

    def test_a_comparison_is_made_strict_or_weak_and_a_condition_constant(self):
        self.assertEqual({("condition always true", "if (true) f();"), ("condition never true", "if (false) f();"),
                          ("operator", "if (a <= b) f();")}, changed("if (a < b) f();"))

    def test_comments_texts_and_templates_are_left_alone(self):
        self.assertEqual([], mutants_of("std::vector<int> x;  // a < b\nconst char* y = \"a < b\";"))

    def test_mutants_in_one_another_are_chosen_by_number(self):
        source = "demand(a && b, why);"
        found = [mutant for mutant in mutants_of(source) if mutant.kind in SWITCH]
        self.assertTrue(switched(source, list(enumerate(found, 1))).endswith(
            "((mutant == 1) ? (void)0 : demand(((mutant == 2) || (a ))&&((mutant == 3) || ( b)), why));"))

    def test_each_that_is_listed_is_a_mutant(self):
        lines = Path(__file__).with_name("equivalent.txt").read_text(encoding="utf-8").splitlines()
        listed = {line for line in lines if line and line[0] not in "# "}
        keys = {mutant.key for path in {line.split(" | ")[0] for line in listed} for mutant in mutants(ROOT, path)}
        self.assertEqual(set(), listed - keys)
        self.assertTrue(listed)


if __name__ == "__main__":
    unittest.main()
