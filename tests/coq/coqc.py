# SPDX-License-Identifier: GPL-3.0-or-later
"""Exports with seamproof, and runs coqc over what was exported."""

import concurrent.futures
import re
import shutil
import subprocess
import sys
from pathlib import Path

LIBRARY = ["SeamRing", "SeamNumber", "SeamSign", "SeamPieces"]

# What Coq's own real numbers rest on, and nothing else.
ALLOWED = {
    "ClassicalDedekindReals.sig_forall_dec",
    "ClassicalDedekindReals.sig_not_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
}

# Words by which a file could say something without proving it.
FORBIDDEN = re.compile(r"\b(Axioms?|Admitted|admit|Parameters?|Hypothes[ie]s|Variables?|Conjecture|"
                       r"Unset|bypass_check|Declare)\b")


def need_coqc():
    if shutil.which("coqc") is None:
        print("skipped: there is no coqc (Debian: coq)")
        sys.exit(77)


def export(seamproof, source, out, *options):
    """The files, in order, and the lines of the summary."""
    shutil.rmtree(out, ignore_errors=True)
    done = subprocess.run([seamproof, "export", "--coq", str(source), "--out", str(out), *options],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"export of {source}: exit {done.returncode}: {done.stderr}")
    files = [line for line in (out / "_CoqProject").read_text().splitlines() if line.endswith(".v")]
    return [name for name in files if name[:-2] not in LIBRARY], done.stdout.splitlines()


def compile_file(folder, name, seconds):
    """The exit status of coqc and all it says."""
    try:
        done = subprocess.run(["coqc", "-q", "-w", "none", name], cwd=folder, capture_output=True,
                              text=True, check=False, timeout=seconds)
    except subprocess.TimeoutExpired:
        return "time", ""
    return done.returncode, done.stdout + done.stderr


def compile_library(folder, kept):
    """Compiled once, and kept in a folder for the next time, where its text is the same."""
    def is_kept(name):
        return ((kept / (name + ".vo")).exists() and
                (kept / (name + ".v")).read_bytes() == (folder / (name + ".v")).read_bytes())

    if all(map(is_kept, LIBRARY)):
        for name in LIBRARY:
            shutil.copy2(kept / (name + ".vo"), folder)
        return
    for name in LIBRARY:
        text = re.sub(r"\(\*.*?\*\)", "", (folder / (name + ".v")).read_text(), flags=re.S)
        # Inside a section, Variable and Hypothesis are what its theorems are about.
        found = set(FORBIDDEN.findall(text)) - {"Variable", "Hypothesis"}
        assert not found, f"{name}.v holds {found}"
        status, said = compile_file(folder, name + ".v", 300)
        assert status == 0, f"{name}.v: {said}"
    shutil.rmtree(kept, ignore_errors=True)
    kept.mkdir(parents=True)
    for name in LIBRARY:
        shutil.copy2(folder / (name + ".v"), kept)
        shutil.copy2(folder / (name + ".vo"), kept)


def fault(folder, name, seconds):
    """What is wrong with a file that should be proven; empty: nothing."""
    text = (folder / name).read_text()
    theorems = re.findall(r"^Theorem (obligation_\d+) :", text, flags=re.M)
    if FORBIDDEN.search(re.sub(r"\(\*.*?\*\)", "", text, flags=re.S)):
        return "it holds a word that it must not hold"
    status, said = compile_file(folder, name, seconds)
    if status != 0:
        return f"coqc: {status}: {said[:2000]}"
    if not theorems:
        return ""
    for theorem in theorems:
        if f"generalize {theorem};" not in text:
            return f"the assumptions of {theorem} are not printed"
    if "Closed under the global context" in said:
        return ""
    if "Axioms:" not in said:
        return "no assumptions are printed"
    axioms = set(re.findall(r"^([A-Za-z_.']+)\s*$|^([A-Za-z_.']+) :", said.split("Axioms:")[1],
                            flags=re.M))
    axioms = {a or b for a, b in axioms}
    return f"it rests on {axioms - ALLOWED}" if axioms - ALLOWED else ""


def faults(folder, names, seconds, jobs=2):
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        found = pool.map(lambda name: (name, fault(folder, name, seconds)), names)
        return [f"{name}: {what}" for name, what in found if what]


def features(path):
    """Which rules the proofs of a file use."""
    text = path.read_text()
    found = set(re.findall(r"(?:zero_holds|number_\w+ \w+|sign_holds \w+|in_\w+|Split|Outside|"
                           r"exists(?= )|condition\b)", re.sub(r"\s+", " ", text)))
    return found | {f"{word} with a generator" for word in ("zero_holds", "number_holds",
                                                            "sign_holds", "number_fails")
                    if re.search(word + r"[ \w]*\[Generator", re.sub(r"\s+", " ", text))}


def small_choice(folder, names, seen):
    """Of the files up to a size, by rising size, those that use a rule not among those seen."""
    chosen = []
    small = [name for name in names if (folder / name).stat().st_size <= 60_000]
    for name in sorted(small, key=lambda name: ((folder / name).stat().st_size, name)):
        new = features(folder / name) - seen
        if new:
            chosen.append(name)
            seen |= new
    return chosen


def counts(summary):
    """Of zero and sign: exported, and not."""
    exported = left_out = 0
    for line in summary:
        match = re.match(r"(\d+) (zero|sign): (exported|not exported)", line)
        if match and match[3] == "exported":
            exported += int(match[1])
        elif match:
            left_out += int(match[1])
    return exported, left_out


def folder(argument):
    return Path(argument).resolve()
