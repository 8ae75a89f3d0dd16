# SPDX-License-Identifier: GPL-3.0-or-later
"""coqc proves what is exported of the reports, from the axioms of Coq's real numbers alone.

    exported_test.py SEAMPROOF REPORTS WORK [--all]

With --all every file; else of those up to 60 kB, paper by paper and by rising size, the ones
that use a rule of the library that no file before uses. Every obligation zero and sign of platonic-spheroids must be exported.
"""

import sys
import time

import coqc

coqc.need_coqc()
seamproof, reports, work = sys.argv[1], coqc.folder(sys.argv[2]), coqc.folder(sys.argv[3])
everything = "--all" in sys.argv[4:]
bad = []
rows = []
seen = set()
for paper in sorted(path.name for path in reports.iterdir() if path.is_dir()):
    out = work / paper
    names, summary = coqc.export(seamproof, reports / paper, out)
    again, _ = coqc.export(seamproof, reports / paper, work / "again")
    for name in again:
        if (out / name).read_bytes() != (work / "again" / name).read_bytes():
            bad.append(f"{paper}/{name}: not the same bytes twice")
    exported, left_out = coqc.counts(summary)
    if paper == "platonic-spheroids" and (left_out or not exported):
        bad.append(f"{paper}: {left_out} obligations zero and sign are not exported")
    coqc.compile_library(out, work / "library")
    chosen = names if everything else coqc.small_choice(out, names, seen)
    start = time.monotonic()
    bad += [f"{paper}/{fault}" for fault in coqc.faults(out, chosen, 3600 if everything else 200)]
    seconds = time.monotonic() - start
    theorems = sum((out / name).read_text().count("\nTheorem obligation_") for name in chosen)
    rows.append((paper, exported, left_out, len(names), len(chosen), theorems, seconds))

print("| paper | zero and sign exported | not exported | files | files proven | theorems proven |")
print("| --- | --- | --- | --- | --- | --- |")
for row in rows:
    print("| " + " | ".join(str(cell) for cell in row[:-1]) + " |")
for row in rows:
    print(f"{row[0]}: {row[-1]:.0f} s", file=sys.stderr)
for fault in bad:
    print("FAILED:", fault)
sys.exit(1 if bad else 0)
