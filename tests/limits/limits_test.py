# SPDX-License-Identifier: GPL-3.0-or-later
"""limits_test.py SEAMPROOF: the time and memory for a claim hold while it is read, searched and judged, and harm no other.

A claim that takes more is undecided with that reason; so is what rests on a definition that does. Every file has a claim
that is easy, and it is proven whatever the others do."""

import pathlib
import sys
import tempfile

from running import Report, run

SLOW = "let f(x) = x*x + 1\nlet g(x) = f(f(f(f(x))))\nlet h(x) = f(f(f(f(f(f(x))))))\n"
SUMS = " + ".join("sqrt(%d + sqrt(%d))" % (p, q) for p, q in ((2, 3), (5, 7), (11, 13)))

# What is written; the lines that must come of it, as (verdict, id, words).
CASES = {
    "reading_takes_long": (
        "claim slow: max(%s for x in [0, 1], y in [0, 1]) < 1\nclaim easy: 1 + 1 = 2\n"
        % " + ".join("(x - y/%d)^%d" % (k, 60 + k) for k in range(2, 40)),
        [("undecided", "slow", "time: "), ("proven", "easy", "")]),
    "a_definition_takes_long": (
        "let m = max(%s for x in [0, 1], y in [0, 1])\nclaim rests: m < 1\nclaim easy: 1 + 1 = 2\n"
        % " + ".join("(x - y/%d)^%d" % (k, 60 + k) for k in range(2, 40)),
        [("undecided", "rests", "time: "), ("proven", "easy", "")]),
    "an_expansion_of_many_variables": (
        "param a, b, c, d, e, f\nclaim wide: (a + b + c + d + e + f)^30 = (f + e + d + c + b + a)^30\n"
        "claim easy: 1 + 1 = 2\n",
        [("undecided", "wide", ""), ("proven", "easy", "")]),
    "a_function_of_a_function_of_a_function": (
        SLOW + "claim deep: for all x: g(g(g(x))) > 0\nclaim easy: 1 + 1 = 2\n",
        [("undecided", "deep", ""), ("proven", "easy", "")]),
}


def main(seamproof):
    report = Report()
    with tempfile.TemporaryDirectory() as folder:
        for name, (text, wanted) in CASES.items():
            path = pathlib.Path(folder) / (name + ".seam")
            path.write_text(text)
            done = run([seamproof, "verify", path, "--timeout", "1", "--memory", "400", "--no-cache", "--jobs", "1"])
            print(f"{name}: status {done.status}, {done.seconds:.1f} s")
            report.expect(done.status == 2, f"{name}: status {done.status}, not 2\n{done.output}")
            for verdict, claim, words in wanted:
                lines = [line for line in done.output.splitlines() if line[2:].split()[:2] == [verdict, claim]]
                report.expect(lines and words in lines[0], f"{name}: no line {verdict} {claim} {words}\n{done.output}")
    report.end()


if __name__ == "__main__":
    main(sys.argv[1])
