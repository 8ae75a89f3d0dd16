# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks the second checker about changed certificates that the first one takes for decided.

usage: confirm.py QUESTIONS MOST

QUESTIONS is what the program `tampered` wrote; MOST of them are asked, evenly spread over the kinds of change. Both must
show the same verdict, and where the statement is another, its digest must be another. Prints a table by kind of change.
"""
import json
import sys
from collections import Counter, defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "second_checker"))
from judge import Judgement  # noqa: E402
from reading import Malformed, digest  # noqa: E402

ANSWERS = ("confirmed", "not judged", "contrary")


def chosen(questions, most):
    """An equal share of every kind of change, evenly spread."""
    kinds = defaultdict(list)
    for question in questions:
        kinds[question["kind"]].append(question)
    share = -(-most // max(len(kinds), 1))
    for group in kinds.values():
        n = min(share, len(group))
        yield from (group[i * len(group) // n] for i in range(n))


def answer(question):
    """Also why, where it is contrary."""
    changed = question["certificate"]
    before = json.loads(Path(question["file"]).read_text(encoding="utf-8"))
    try:
        judgement = Judgement(json.dumps(changed))
        if changed["statement"] != before["statement"] and digest(changed["statement"]) == digest(before["statement"]):
            return "contrary", "the digest is that of another statement"
        verdict = judgement.verdict
    except Malformed as reason:
        verdict = f"malformed, {reason}"
    if verdict == "not judged":
        return verdict, ""
    return ("confirmed" if verdict == question["shown"] else "contrary"), verdict


def main(path, most):
    with open(path, encoding="utf-8") as file:
        questions = [json.loads(line) for line in file]
    counts = defaultdict(Counter)
    for question in chosen(questions, most):
        found, why = answer(question)
        counts[question["kind"]][found] += 1
        if found == "contrary":
            print(f"CONTRARY: {question['file']}, {question['kind']} at {question['place']}: "
                  f"{question['shown']}; the second checker: {why}")
    print(f"\n{len(questions)} changed certificates decide their statement\n")
    print("| kind of change | asked |", " | ".join(ANSWERS), "|\n| --- |", " | ".join(["---:"] * 4), "|")
    total = Counter()
    for kind, found in sorted(counts.items()):
        total += found
        print(f"| {kind} | {found.total()} |", " | ".join(str(found[a]) for a in ANSWERS), "|")
    print(f"| all | {total.total()} |", " | ".join(str(total[a]) for a in ANSWERS), "|")
    return 1 if total["contrary"] or not total["confirmed"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
