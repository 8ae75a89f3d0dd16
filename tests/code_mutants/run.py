# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes the checker, one line at a time, and has its tests look at each change: they must not accept it.

    run.py SCRATCH [--guards | --others] [--sample N] [--seed S] [--only REGEX] [--from N]

Guards, which are mutants that drop a demand, a part of one, or a condition, are built all at once and chosen by a
variable of the environment. All others are built one by one, and so are those of headers. A mutant that no test minds survives; it has to be
named in equivalent.txt, with the reason why it changes nothing that matters, or the run fails.
"""
import argparse
import os
import random
import re
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path

from mutations import SWITCH, mutants, switched

ROOT = Path(__file__).resolve().parents[2]
TIMEOUT = 60
SLOW = "*.a_polynomial_of_degree_16_*:*.signs_of_numbers_agree_*"  # tests that come last


def copied(scratch, changed):
    """The files of the project, some of them changed. What stays as it was is not written again, and so not built again."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True, text=True)
    for name in listed.stdout.splitlines():
        if not (ROOT / name).is_file() or name.startswith("reports/"):
            continue
        target = scratch / "source" / name
        wanted = changed[name].encode() if name in changed else (ROOT / name).read_bytes()
        if target.is_file() and target.read_bytes() == wanted:
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(wanted)
        shutil.copymode(ROOT / name, target)
    return scratch / "source"


def configured(source, build):
    subprocess.run(["cmake", "-G", "Ninja", "-S", source, "-B", build, "-DCMAKE_BUILD_TYPE=Debug",
                    "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -w -D_GLIBCXX_ASSERTIONS"], check=True, capture_output=True)


def is_built(build):
    targets = ["check_test", "certificate_test", "seamproof-check"]
    return subprocess.run(["ninja", "-C", build, *targets], capture_output=True).returncode == 0


def status(*command):
    """Of the program, or that of one that did not end."""
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=TIMEOUT).returncode
    except subprocess.TimeoutExpired:
        return "no end"


def killer(build):
    """The first of the tests that minds; None: the mutant survives."""
    program = build / "bin" / "seamproof-check"
    for folder, right in (("valid", 0), ("invalid", 3)):
        for file in sorted((ROOT / "tests/proofs" / folder).glob("*.json")):
            if status(program, file) != right:
                return f"proofs/{folder}/{file.stem}"
    for test, chosen in (("check_test", "-" + SLOW), ("certificate_test", "*"), ("check_test", SLOW)):
        if status(build / "bin" / test, "--gtest_fail_fast", "--gtest_brief=1", "--gtest_filter=" + chosen) != 0:
            return test
    agreement = ROOT / "tests/second_checker/agreement_test.py"
    if status(sys.executable, "-B", agreement, program, ROOT / "reports", build / "tampered") != 0:
        return "agreement with the second checker"
    return None


class Counts:
    def __init__(self):
        self.tried, self.killed, self.unbuilt, self.listed, self.survivors = (Counter() for _ in range(5))
        self.named = []
        reasons = Path(__file__).with_name("equivalent.txt").read_text(encoding="utf-8").splitlines()
        self.equivalent = {line for line in reasons if line and line[0] not in "# "}

    def take(self, mutant, by):
        self.tried[mutant.kind] += 1
        if by is not None:
            (self.unbuilt if by == "the compiler" else self.killed)[mutant.kind] += 1
            return
        is_listed = mutant.key in self.equivalent
        (self.listed if is_listed else self.survivors)[mutant.kind] += 1
        if not is_listed:
            self.named.append(mutant)
            print(f"survives: {mutant.key}\n    now: {mutant.text}", flush=True)

    def table(self):
        print("\n| change | tried | not compiled | killed | changes nothing | survives |\n| --- | --- | --- | --- | --- | --- |")
        columns = (self.tried, self.unbuilt, self.killed, self.listed, self.survivors)
        for kind in sorted(self.tried):
            print(f"| {kind} | " + " | ".join(str(column[kind]) for column in columns) + " |")
        print("| all | " + " | ".join(str(sum(column.values())) for column in columns) + " |")


def try_guards(scratch, chosen, first, counts):
    numbered, build = list(enumerate(chosen, 1)), scratch / "guards"
    changed = {path: switched((ROOT / path).read_text(encoding="utf-8"), [n for n in numbered if n[1].path == path])
               for path in {mutant.path for mutant in chosen}}
    os.environ["MUTANT"] = "0"
    configured(copied(scratch / "of_guards", changed), build)
    if not is_built(build) or killer(build) is not None:
        sys.exit("without a mutant at work the tests do not pass")
    for number, mutant in numbered[first - 1:]:
        os.environ["MUTANT"] = str(number)
        tell(number, len(numbered))
        counts.take(mutant, killer(build))


def try_others(scratch, chosen, first, counts):
    source, build = copied(scratch / "of_others", {}), scratch / "others"
    configured(source, build)
    if not is_built(build):
        sys.exit("it is not built without a mutant")
    for number, mutant in list(enumerate(chosen, 1))[first - 1:]:
        tell(number, len(chosen))
        text = (ROOT / mutant.path).read_text(encoding="utf-8")
        (source / mutant.path).write_text(mutant.applied(text), encoding="utf-8")
        counts.take(mutant, killer(build) if is_built(build) else "the compiler")
        (source / mutant.path).write_text(text, encoding="utf-8")


def tell(number, count):
    print(f"\r{number} of {count}", end="", file=sys.stderr, flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scratch", type=Path)
    parser.add_argument("--guards", action="store_true")
    parser.add_argument("--others", action="store_true")
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--from", type=int, default=1, dest="first", help="the number of the first one tried, of those chosen")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    files = sorted(p.relative_to(ROOT).as_posix() for p in (ROOT / "src/check").glob("*.[ch]*") if p.suffix in (".h", ".cpp"))
    every = [mutant for path in files for mutant in mutants(ROOT, path) if re.search(options.only, mutant.key)]
    is_guard = lambda mutant: mutant.kind in SWITCH and mutant.path.endswith(".cpp")
    counts = Counts()
    for wanted, choice, work in ((options.guards, filter(is_guard, every), try_guards),
                                 (options.others, (m for m in every if not is_guard(m)), try_others)):
        chosen = list(choice)
        if options.sample and len(chosen) > options.sample:
            chosen = sorted(random.Random(options.seed).sample(chosen, options.sample), key=every.index)
        if (wanted or not (options.guards or options.others)) and chosen:
            work(options.scratch.resolve(), chosen, options.first, counts)
    counts.table()
    return 1 if counts.named else 0


if __name__ == "__main__":
    sys.exit(main())
