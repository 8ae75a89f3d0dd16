# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges all certificates of a report: usage: papers.py REPORT NOT_JUDGED

Fails where a verdict is contradicted, or where more than NOT_JUDGED certificates are not judged. Prints how many
obligations of which kind were judged, and how.
"""
import sys
from collections import Counter
from pathlib import Path

from judge import NOT_JUDGED, Judgement
from reading import Malformed


def main(report, allowed):
    verdicts, kinds, reasons, failures = Counter(), {}, Counter(), []
    paths = sorted(Path(report, "certificates").glob("*.json"))
    for path in paths:
        try:
            judgement = Judgement(path.read_text(encoding="utf-8"))
        except Malformed as error:
            failures.append(f"{path.name}: refused: {error}")
            continue
        verdicts[judgement.verdict] += 1
        reasons.update(judgement.why)
        for kind, value in zip(judgement.kinds, judgement.values):
            kinds.setdefault(" by ".join(kind), Counter())[value] += 1
        if judgement.agrees() is False:
            failures.append(f"{path.name}: is called {judgement.certificate['verdict']}, and is {judgement.verdict}")
    for kind in sorted(kinds):
        print(f"  {kind:28}", ", ".join(f"{n} {value}" for value, n in sorted(kinds[kind].items())))
    for reason, n in sorted(reasons.items()):
        print(f"  {n} times {reason}")
    print(f"{len(paths)} certificates: " + ", ".join(f"{n} {verdict}" for verdict, n in sorted(verdicts.items())))
    if not paths or verdicts[NOT_JUDGED] > allowed:
        failures.append(f"{verdicts[NOT_JUDGED]} certificates were not judged; there should be no more than {allowed}")
    print(*failures, sep="\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
