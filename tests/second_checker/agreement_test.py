# SPDX-License-Identifier: GPL-3.0-or-later
"""Two checkers that share nothing say the same of certificates that were tampered with at random.

usage: agreement_test.py SEAMPROOF_CHECK REPORTS FOLDER [COUNT [SEED]]

FOLDER is made anew and keeps the certificates, so that one which is judged differently can be looked at. What this
checker does not judge is not compared, nor what the other refuses to read: of a term out of place this one leaves the
obligation open, and the rest may decide.
"""
import json
import random
import re
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path

from judge import Judgement
from reading import Malformed
from tampering import tamper

LARGEST = 14000  # bytes
DECIDED = ("proven", "refuted")


def own_verdict(text):
    try:
        return Judgement(text).verdict
    except Malformed:
        return "malformed"


def verdicts_of(program, folder):
    """{name: verdict} as `seamproof-check` finds them."""
    found = {}
    lines = subprocess.run([program, folder], capture_output=True, text=True, check=False).stdout
    for line in lines.splitlines():
        match = re.match(r"\s*(Valid|Invalid)\s+(changed\.\d+)\s+(\w+)", line)
        if match:
            shown = re.search(r"the evidence shows: (\w+)", line)
            found[match[2]] = shown[1] if shown else match[3] if match[1] == "Valid" else "malformed"
    return found


def main(program, reports, folder, count=300, seed=1):
    chance = random.Random(seed)
    originals = sorted(p for p in Path(reports).glob("*/certificates/*.json") if p.stat().st_size < LARGEST)
    shutil.rmtree(folder, ignore_errors=True)
    Path(folder, "certificates").mkdir(parents=True)
    own, source = {}, {}
    for i in range(count):
        path = chance.choice(originals)
        certificate = json.loads(path.read_text(encoding="utf-8"))
        for _ in range(chance.choice((1, 1, 2, 3))):
            tamper(certificate, chance)
        name = f"changed.{i}"
        certificate.update(claim=name, correction=False)
        text = json.dumps(certificate)
        Path(folder, "certificates", name + ".json").write_text(text, encoding="utf-8")
        own[name], source[name] = own_verdict(text), path.name
    other, different, counts = verdicts_of(program, folder), 0, Counter()
    for name, verdict in own.items():
        theirs = other.get(name, "malformed")
        counts[verdict] += 1
        if "not judged" == verdict or "malformed" == theirs:
            continue
        if verdict != theirs and (verdict in DECIDED or theirs in DECIDED):
            print(f"{name}, once {source[name]}: {verdict}; seamproof-check: {theirs}")
            different += 1
    print(f"{count} certificates:", ", ".join(f"{n} {verdict}" for verdict, n in sorted(counts.items())))
    return 1 if different or len(other) < count // 2 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4], *map(int, sys.argv[4:])))
