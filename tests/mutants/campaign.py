# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutated papers: every claim that is still decided in a mutant, of another statement than before, is decided rightly.

    python3 campaign.py SEAMPROOF FOLDER [--count N | --per-claim N] [--seed N] [--jobs N] [--timeout S] FILE.seam...

`seamproof mutate` changes the files and decides the claims. What comes out proven is evaluated at many points by evaluate.py, which
reads the text of the mutant by itself; what comes out refuted is looked for a point where it fails. Where that says nothing, the second
checker (tests/second_checker) has to accept the certificate. A contradiction is a finding; so is a certificate that is not accepted, an
alarm, and a mutant on which the program breaks off. Exit status 1 with a finding. Prints a table in Markdown."""
import argparse
import collections
import json
import multiprocessing
import os
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
JUDGE = os.path.join(HERE, os.pardir, "second_checker", "judge.py")
COLUMNS = ("mutants", "verdict changed", "error", "same statement", "took too long", "confirmed by evaluation", "confirmed by the second checker alone",
           "not confirmed", "findings")


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("seamproof")
    parser.add_argument("folder")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--per-claim", type=int)
    parser.add_argument("--claim", action="append", default=[])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=5)
    parser.add_argument("--seconds", type=int, default=10, help="for the evaluation of one claim")
    return parser.parse_args()


def mutate(options, file, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    results = os.path.join(folder, "mutants.json")
    size = ["--per-claim", options.per_claim] if options.per_claim else ["--count", options.count]
    command = [options.seamproof, "mutate", file, "--json", results, "--out", folder, "--quiet", "--seed", options.seed,
               "--jobs", options.jobs, "--timeout", options.timeout, "--no-cache", *size]
    for pattern in options.claim:
        command += ["--claim", pattern]
    finished = subprocess.run([str(word) for word in command], check=False)
    with open(results, encoding="utf-8") as text:
        return json.load(text), finished.returncode


def judged(certificate, verdict):
    """What the second checker makes of a certificate: whether it is of the same mind; None: it is too big for it."""
    said = subprocess.run([sys.executable, "-B", JUDGE, certificate], capture_output=True, text=True, check=False).stdout
    word = said[len(certificate) + 2:].split(" ")[0:2]
    if word == ["not", "judged"]:
        return None
    return word[0] == verdict


def confirm(task):
    """(how it was confirmed, or what is wrong, why the evaluation said nothing)"""
    folder, kept, identity, which, verdict, seconds = task
    import evaluate
    evaluate.allow_deep_formulas()
    evaluate.SECONDS = seconds
    with open(os.path.join(folder, kept), encoding="utf-8") as text:
        source = text.read()
    try:
        said, why = evaluate.evaluate(evaluate.File(source), identity, which, verdict == "refuted")
    except KeyError:
        said, why = "unknown", "it has another id"
    except (ArithmeticError, ValueError, TypeError, AttributeError, IndexError) as error:
        said, why = "unknown", "the evaluator broke off: %r" % error
    except evaluate.reading.NotRead as error:
        said, why = "unknown", "not read: %s" % error
    if (verdict, said) in (("proven", "holds"), ("refuted", "fails")):
        return "confirmed by evaluation", ""
    if (verdict, said, why) == ("proven", "fails", ""):
        return "findings", "proven, and it fails at a point"
    if (verdict, said, why) == ("refuted", "holds", "certainly"):
        return "findings", "refuted, and it holds"
    certificate = os.path.join(folder, kept[:-len(".seam")] + (".json" if which == "printed" else ".corrected.json"))
    accepted = judged(certificate, verdict)
    if accepted is None:
        return "not confirmed", why
    return ("confirmed by the second checker alone", why) if accepted else ("findings", "the second checker does not accept the certificate")


class Counts:
    def __init__(self):
        self.rows, self.reasons, self.findings = collections.defaultdict(collections.Counter), collections.Counter(), []

    def add(self, paper, kind, column):
        for row in (("paper", paper), ("kind", kind), ("all", "")):
            self.rows[row][column] += 1

    def finding(self, paper, mutant, identity, what):
        self.findings.append("%s, %s, line %d, seed in the table: %s\n    - %s\n    + %s\n    kept: %s" % (
            paper, identity, mutant["line"], what, mutant["before"], mutant["after"], mutant.get("kept", "")))

    def print(self, title, row):
        print("\n| %s | %s |\n|---|%s" % (title, " | ".join(COLUMNS), "---:|" * len(COLUMNS)))
        for key in sorted(k for k in self.rows if k[0] == row):
            print("| %s | %s |" % (key[1] or "all", " | ".join(str(self.rows[key][c]) for c in COLUMNS)))


def campaign(options):
    counts = Counts()
    with multiprocessing.Pool(options.jobs, maxtasksperchild=20) as pool:
        for file in options.files:
            paper = os.path.splitext(os.path.basename(file))[0]
            begin = time.time()
            folder = os.path.join(options.folder, paper)
            run, status = mutate(options, file, folder)
            print("%s: mutated and decided, %.0f s" % (paper, time.time() - begin), file=sys.stderr, flush=True)
            tasks, about = [], []
            for claim in run["claims"]:
                known = {claim[w].get("digest") for w in ("printed", "corrected") if w in claim}
                for mutant in claim["mutants"]:
                    column = {"verdict": "verdict changed", "error": "error", "unchanged": "same statement", "unknown": "took too long"}.get(mutant["fate"])
                    counts.add(paper, mutant["kind"], "mutants")
                    if column:
                        counts.add(paper, mutant["kind"], column)
                    if "internal error" in mutant.get("error", "") or any("alarm" in mutant.get(w, {}).get("reason", "") for w in ("printed", "corrected")):
                        counts.add(paper, mutant["kind"], "findings")
                        counts.finding(paper, mutant, claim["id"], "an alarm or an internal error")
                    for which in ("printed", "corrected"):
                        outcome = mutant.get(which, {})
                        if outcome.get("verdict") in ("proven", "refuted") and outcome.get("digest") not in known and "kept" in mutant:
                            tasks.append((folder, mutant["kept"], claim["id"], which, outcome["verdict"], options.seconds))
                            about.append((claim["id"], mutant))
            for (identity, mutant), task, (column, why) in zip(about, tasks, pool.imap(confirm, tasks)):
                counts.add(paper, mutant["kind"], column)
                if column == "findings":
                    counts.finding(paper, mutant, "%s %s" % (identity, task[3]), why)
                elif why:
                    counts.reasons[why] += 1
            print("%s: confirmed, %.0f s" % (paper, time.time() - begin), file=sys.stderr, flush=True)
            if status not in (0,):
                counts.findings.append("%s: seamproof mutate ended with status %d" % (paper, status))
    return counts


def main():
    options = arguments()
    sys.path.insert(0, HERE)
    counts = campaign(options)
    counts.print("paper, seed %d" % options.seed, "paper")
    counts.print("kind", "kind")
    counts.print("all", "all")
    print("\nWhat the evaluation said nothing of, and why (most frequent first):")
    for why, n in counts.reasons.most_common(25):
        print("- %d: %s" % (n, why))
    for finding in counts.findings:
        print("\nFINDING: " + finding)
    return 1 if counts.findings else 0


if __name__ == "__main__":
    sys.exit(main())
