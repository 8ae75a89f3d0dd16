# SPDX-License-Identifier: GPL-3.0-or-later
"""hostile_files_test.py SEAMPROOF SEAMPROOF-CHECK [--large]: whatever a file holds, a run ends soon, with verdicts or a message.

Each case is a file, the exit statuses that it may have, and words that must be said. Any run has a time in which it must
end, and must not end by a signal or with 70, an internal error. With --large the sizes are those of the nightly campaign."""

import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from running import Report, environment, run

SECONDS = 60


def nested(opening, closing, times, inside="1"):
    return f"let a = {opening * times}{inside}{closing * times}\n"


def cases(large):
    deep, long = (1_000_000, 10_000_000) if large else (100_000, 1_000_000)
    many = 1_000_000 if large else 5_000
    digits = "7" * (1_000_000 if large else 100_000)
    nest = "nested more than 200 deep"
    return {
        "parentheses": (nested("(", ")", deep), {65}, nest),
        "lists": (nested("[", "]", deep), {65}, nest),
        "minus signs": (nested("-", "", deep), {65}, nest),
        "quantifiers": ("claim a: " + "for all x: " * deep + "1 = 1\n", {65}, nest),
        "negations": ("claim a: " + "not " * deep + "1 = 1\n", {65}, nest),
        "a sum of many": ("claim a: " + "1 + " * deep + "1 > 0\n", {65}, "1000 operations deep"),
        "a power of a power": ("claim a: 2^(2^64) > 0\n", {65, 2}, "exponent"),
        "a tower of powers": ("claim a: 9^9^9^9^9^9 > 0\n", {65, 2}, ""),
        "a function to the power 10^9": ("claim a: for all x: (1 + x)^(10^9) >= 0\n", {65, 2}, ""),
        "a maximum of degree 10^6": ("claim a: max(x^1000000 - x for x in [0, 1]) = 0\n", {65, 2}, ""),
        "a question about degree 10^6": ("ask a: max(x^1000000 - 3*x for x in [0, 1])\n", {65, 0, 2}, ""),
        "a sum to 10^12": ("claim a: sum(k for k in 1..10^12) = 1\n", {65, 2}, ""),
        "a range to 10^12": ("claim a: for k in 1..10^12: k > 0\n", {65, 2}, ""),
        "a range to 10^6": ("claim a: for k in 1..1000000: k > 0\n", {0, 65, 2}, ""),
        "nested roots": ("claim a: %s%s > 1\n" % ("sqrt(1 + " * 60, "2" + ")" * 60), {65, 2, 0}, ""),
        "squares of squares": ("let f(x) = x*x\nlet g(x) = f(f(f(f(f(f(f(f(x))))))))\n"
                               "claim a: g(g(g(g(3)))) > 1\n", {65, 2}, ""),
        "a large integer": (f"claim a: {digits} = {digits}\n", {0, 2}, ""),
        "a long decimal": (f"claim a: 1/9 ~ 0.{'1' * 10000}\n", {0, 2}, ""),
        "NUL": ("claim a: 1 = 1\0\n", {65}, "U+0000"),
        "no UTF-8": (b"claim a: 1 = 1 # \xff\xfe\n", {65}, "not UTF-8"),
        "half of a letter": (b"claim a: 1 = 1 # \xce", {65}, "not UTF-8"),
        "a byte order mark": (b"\xef\xbb\xbfclaim a: 1 = 1\n", {0}, "1 proven"),
        "CRLF": (b"claim a: 1 = 1\r\nclaim b:\r\n  2 = 2\r\n", {0}, "2 proven"),
        "CR alone": (b"claim a: 1 = 1\rclaim b: 2 = 2\r", {0, 65}, ""),
        "no end of the last line": (b"claim a: 1 = 1", {0}, "1 proven"),
        "an empty file": (b"", {0}, "0 claims"),
        "one line": ("claim a: 1 = 1 # " + "x" * long + "\n", {0}, "1 proven"),
        "a long name": ("let " + "x" * long + " = 1\n", {0, 65}, ""),
        "a line of blanks": (" " * long + "claim a: 1 = 1\n", {0, 65}, ""),
        "a long list": ("let a = [" + "1, " * (long // 10) + "1]\n", {0, 65}, ""),
        "many definitions": ("".join(f"let a{k} = {k}\n" for k in range(many)) + f"claim a: a{many - 1} > 0\n", {0}, "1 proven"),
        "a chain of definitions": ("let a0 = 1\n" + "".join(f"let a{k + 1} = a{k} + 1\n" for k in range(many // 5)) +
                                   "claim a: a9 = 10\n", {0, 65, 2}, ""),
        "many parameters": ("".join(f"param p{k}\n" for k in range(many // 5)) + "claim a: (p1 + p2)^2 = p1^2 + 2*p1*p2 + p2^2\n",
                            {0}, "1 proven"),
        "parameters in one line": ("param " + ", ".join(f"p{k}" for k in range(many // 5)) + "\nclaim a: p1 = p1\n", {0}, "1 proven"),
        "many errors": ("let = \n" * (long // 10), {65}, "more errors"),
        "many unknown words": ("clam a\n" * (long // 10), {65}, ""),
        "many claims": ("".join(f"claim c{k}: {k} + 1 = {k + 1}\n" for k in range(many // 20)), {0}, f"{many // 20} proven"),
        "a wide table": ("table t for k in 1..%d: \"r\" k ~ %s\n" % (many // 50, ", ".join(map(str, range(1, many // 50 + 1)))),
                         {0}, f"{many // 50} proven"),
    }


def check_cases(report, seamproof, folder, large):
    for name, (text, statuses, words) in cases(large).items():
        path = folder / "a.seam"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        try:
            done = run([seamproof, "verify", path, "--no-cache", "--timeout", "5", "--memory", "1500", "--jobs", "2"],
                       timeout=SECONDS * (60 if large else 1))
        except subprocess.TimeoutExpired:
            report.expect(False, f"{name}: not at its end after {SECONDS} s")
            continue
        print(f"{name}: status {done.status}, {done.seconds:.2f} s", flush=True)
        report.expect(done.status in statuses, f"{name}: status {done.status}, not one of {statuses}\n{done.output[:600]}")
        report.expect(words in done.output, f"{name}: nobody says '{words}'\n{done.output[:600]}")


def check_includes(report, seamproof, folder):
    (folder / "a.seam").write_text('include "b.seam"\nclaim a: 1 = 1\n')
    (folder / "b.seam").write_text('include "a.seam"\ninclude "b.seam"\nclaim b: 1 = 1\n')
    done = run([seamproof, "verify", folder / "a.seam", "--no-cache"], timeout=SECONDS)
    report.expect(done.status in {0, 65}, f"files that include each other: status {done.status}\n{done.output[:600]}")
    for k in range(3000):
        (folder / f"c{k}.seam").write_text(f'include "c{k + 1}.seam"\n')
    (folder / "c3000.seam").write_text("claim c: 1 = 1\n")
    done = run([seamproof, "verify", folder / "c0.seam", "--no-cache"], timeout=SECONDS)
    report.expect(done.status in {0, 65}, f"a chain of includes: status {done.status}\n{done.output[:600]}")


def check_interrupts(report, seamproof, folder):
    """Ctrl-C while a large file is read ends it at once."""
    path = folder / "a.seam"
    path.write_text("".join(f"claim c{k}: {k} + 1 = {k + 1}\n" for k in range(300_000)))
    for moment in (0.1, 0.8, 2.5):
        process = subprocess.Popen([seamproof, "verify", path, "--no-cache"], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, env=environment())
        time.sleep(moment)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        status = process.wait(timeout=SECONDS)
        status = status if status >= 0 else 128 - status
        report.expect(status == 130, f"interrupted after {moment} s: status {status}")
        report.expect(time.monotonic() - begin < 5, f"interrupted after {moment} s: {time.monotonic() - begin:.1f} s to end")


def certificates(large):
    """Certificates that ask the checker for too much."""
    size = 60_000 if large else 20_000

    def zero(nodes, formula):
        return ('{"format": "seamproof certificate 1", "claim": "a", "correction": false, "verdict": "proven", "using": [], '
                '"statement": {"generators": [], "functions": [], "nodes": [%s], "obligations": [{"zero": %d}], '
                '"guards": [], "goal": 0}, "evidence": {"proofs": [{"computation": true}]}}' % (", ".join(nodes), formula))
    return {
        "brackets": "[" * 1_000_000,
        "objects": '{"a":' * 1_000_000,
        "a number of many digits": '{"format": ' + "9" * 1_000_000 + "}",
        "many nodes": zero(['{"constant": "1"}'] + ['{"product": [%d, %d]}' % (k, k) for k in range(size)], size),
        "no text": "\xff\xfe",
    }


def check_certificates(report, checker, folder, large):
    for name, text in certificates(large).items():
        path = folder / "a.json"
        path.write_text(text, encoding="latin-1")
        done = run([checker, path], timeout=SECONDS)
        print(f"certificate, {name}: status {done.status}, {done.seconds:.2f} s")
        report.expect(done.status in {3, 66}, f"certificate, {name}: status {done.status}\n{done.output[:300]}")


def main(seamproof, checker, large):
    report = Report()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_cases(report, seamproof, folder, large)
        check_includes(report, seamproof, folder)
        check_interrupts(report, seamproof, folder)
        check_certificates(report, checker, folder, large)
    report.end()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], "--large" in sys.argv)
