# SPDX-License-Identifier: GPL-3.0-or-later
"""Results that were tampered with: `seamproof report DIR` notices, or finds what is so by itself.

usage: results_test.py SEAMPROOF FILE.seam FOLDER [EVERY]

Verifies the file into FOLDER/honest; then changes one thing at a time in its results.json or among its certificates, every
EVERYth of these. A change is *noticed* if the exit status is 3 (an alarm) or 65 (no results), *recomputed* if the results
written anew are the honest ones, and *told* if the status says otherwise that something is not as expected. Texts that
people alone read (titles, formulas, witnesses, digits) are not changed: no certificate speaks of them.
"""
import copy
import json
import shutil
import subprocess
import sys
from collections import Counter, defaultdict
from pathlib import Path

ALARM, BAD_FILE = 3, 65
VERDICTS = ("proven", "refuted", "conditional", "undecided")
STATUSES = ("holds", "fails", "open")


def other_digit(text):
    return text[:-1] + ("0" if text[-1] != "0" else "1")


def of_outcome(outcome, others):
    """(kind, function of an outcome) for a claim, or for what is said beside it."""
    if "digest" in outcome:
        yield "digest changed", lambda o: o.update(digest=other_digit(o["digest"]))
    for name in ("certificate", "corrected_certificate"):
        if not outcome.get(name):
            continue
        for path in ("certificates/none.json", "../" + outcome[name], "results.json"):
            yield "path of a certificate changed", lambda o, n=name, p=path: o.update({n: p})
        for other in others:
            yield "certificate of another claim", lambda o, n=name, p=other["certificate"]: o.update({n: p})
            yield "certificate and digest of another claim", lambda o, n=name, p=other: o.update(
                {n: p["certificate"], "digest": p["digest"]})


def of_claim(claim, others):
    for verdict in VERDICTS:
        if verdict != claim["verdict"]:
            yield "verdict changed", lambda c, v=verdict: c.update(verdict=v)
            yield "verdict and expectation changed", lambda c, v=verdict: c.update(
                verdict=v, expected=v, as_expected=True)
        if claim["corrected"] and verdict != claim["corrected"]:
            yield "verdict of a correction changed", lambda c, v=verdict: c.update(corrected=v)
    yield "as_expected changed", lambda c: c.update(as_expected=not c["as_expected"])
    yield "id changed", lambda c: c.update(id=c["id"] + "x")
    for other in others:
        yield "id of another claim", lambda c, i=other["id"]: c.update(id=i)
        yield "rests on another claim", lambda c, i=other["id"]: c.update(using=c["using"] + [i])
    if claim["using"]:
        yield "rests on nothing", lambda c: c.update(using=[])
    for step in (1, -1):
        yield "number of obligations changed", lambda c, s=step: c.update(obligations=c["obligations"] + s)
    for i, finding in enumerate(claim.get("findings", [])):
        for status in STATUSES:
            if status != finding["status"]:
                yield "status of an obligation changed", lambda c, k=i, s=status: c["findings"][k].update(status=s)
        if claim["verdict"] != "undecided":  # what was not decided may be listed without its obligations
            yield "obligation left out", lambda c, k=i: c["findings"].pop(k)
    yield from of_outcome(claim, others)
    for kind, change in of_outcome(claim.get("digits_confirmed", {}), others):
        yield kind + ", of digits", lambda c, f=change: f(c["digits_confirmed"])


def of_results(results):
    """(kind, function of the results) for every change."""
    claims = results["files"][0]["claims"]
    for i, claim in enumerate(claims):
        others = [claims[(i + k) % len(claims)] for k in (1, 5)]
        for kind, change in of_claim(claim, others):
            yield kind, lambda r, k=i, f=change: f(r["files"][0]["claims"][k])
    for i, ask in enumerate(results["files"][0]["asks"]):
        for kind, change in of_outcome(ask["confirmed"], claims[:1]):
            yield kind + ", of an answer", lambda r, k=i, f=change: f(r["files"][0]["asks"][k]["confirmed"])
    for name in results["summary"]:
        for step in (1, -1):
            yield "count changed", lambda r, n=name, s=step: r["summary"].update({n: r["summary"][n] + s})
    yield "version changed", lambda r: r.update(schema_version=2)
    yield "no files", lambda r: r.update(files=[])


def of_certificates(names):
    """(kind, function of the folder of certificates)."""
    def exchange(folder, one, other):
        (folder / one).rename(folder / "kept")
        (folder / other).rename(folder / one)
        (folder / "kept").rename(folder / other)

    def under_its_name(folder, one, other):
        true, taken = (json.loads((folder / n).read_text(encoding="utf-8")) for n in (one, other))
        taken.update(claim=true["claim"], correction=true["correction"], verdict=true["verdict"], using=true["using"])
        (folder / one).write_text(json.dumps(taken), encoding="utf-8")

    for i, name in enumerate(names):
        other = names[(i + 1) % len(names)]
        yield "certificate file removed", lambda f, n=name: (f / n).unlink()
        yield "certificate files exchanged", lambda f, n=name, o=other: exchange(f, n, o)
        yield "another statement under the name of the claim", lambda f, n=name, o=other: under_its_name(f, n, o)


class Trial:
    def __init__(self, program, folder):
        self.program, self.folder, self.honest = program, folder, folder / "honest"
        self.counts, self.failed = defaultdict(Counter), 0

    def run(self, *arguments):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, check=False)

    def report(self, folder):
        """The exit status, and the results that are written anew."""
        out = self.folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        status = self.run("report", folder, "--out", out).returncode
        again = out / "results.json"
        return status, again.read_text(encoding="utf-8") if again.exists() else ""

    def judge(self, kind, change_results=None, change_certificates=None):
        changed = self.folder / "changed"
        shutil.rmtree(changed, ignore_errors=True)
        shutil.copytree(self.honest, changed)
        if change_results:
            results = copy.deepcopy(self.results)
            change_results(results)
            (changed / "results.json").write_text(json.dumps(results), encoding="utf-8")
        else:
            change_certificates(changed / "certificates")
        status, again = self.report(changed)
        word = ("noticed" if status in (ALARM, BAD_FILE) else "recomputed" if again == self.expected
                else "told" if status != self.status else "MISSED")
        self.counts[kind][word] += 1
        if word == "MISSED":
            self.failed = 1
            kept = self.folder / f"missed.{sum(c.total() for c in self.counts.values())}"
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(changed, kept)
            print(f"MISSED: {kind}, exit status {status}: see {kept.name}")

    def all(self, seam, every):
        self.run("verify", seam, "--no-cache", "--quiet", "--out", self.honest)
        self.results = json.loads((self.honest / "results.json").read_text(encoding="utf-8"))
        self.status, self.expected = self.report(self.honest)
        if self.expected != (self.honest / "results.json").read_text(encoding="utf-8"):
            sys.exit("the honest results are not written anew as they are")
        names = sorted(p.name for p in (self.honest / "certificates").iterdir())
        for kind, change in list(of_results(self.results))[::every]:
            self.judge(kind, change_results=change)
        for kind, change in list(of_certificates(names))[::every]:
            self.judge(kind, change_certificates=change)

    def table(self):
        words = ("noticed", "recomputed", "told", "MISSED")
        print("| tampering with results | tried |", " | ".join(words), "|\n| --- |", " | ".join(["---:"] * 5), "|")
        for kind, found in sorted(self.counts.items()) + [("all", sum(self.counts.values(), Counter()))]:
            print(f"| {kind} | {found.total()} |", " | ".join(str(found[w]) for w in words), "|")


def main(program, seam, folder, every=1):
    shutil.rmtree(folder, ignore_errors=True)
    Path(folder).mkdir(parents=True)
    trial = Trial(program, Path(folder))
    trial.all(seam, every)
    trial.table()
    return trial.failed


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4], *map(int, sys.argv[4:])))
