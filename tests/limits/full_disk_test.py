# SPDX-License-Identifier: GPL-3.0-or-later
"""full_disk_test.py SEAMPROOF: where something cannot be written the exit status is 74, and what was there is whole.

A disk that is full: /dev/full, and a limit on the size of files. A folder that cannot be written: a file that stands in
its place (which stops root too), and, for others than root, permissions. A store that cannot be written is no error."""

import os
import pathlib
import resource
import subprocess
import sys
import tempfile

from running import Report, differences, environment, run, tree

FILE = 'claim half "two halves" at "p. 3": 1/2 + 1/2 = 1\nclaim third: 1/3 ~ 0.34\n  corrected: 1/3 ~ 0.33\n'
WIDER = FILE + "".join(f"claim more{k}: {k} + 1 = {k + 1}\n" for k in range(40))


def small_files(size):
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


def as_nobody():
    os.setgid(65534)
    os.setuid(65534)


def check_outputs(report, seamproof, folder):
    file = folder / "a.seam"
    for option in ("--json", "--junit", "--sarif"):
        for place in ("/dev/full", "/dev/null/nothing", folder / "a.seam" / "x.json"):
            done = run([seamproof, "verify", file, "--no-cache", option, place])
            report.expect(done.status == 74, f"{option} {place}: status {done.status}\n{done.output}")
            report.expect("cannot write" in done.output, f"{option} {place} is not named\n{done.output}")
    for words in (["verify", file, "--no-cache"], ["verify", file, "--no-cache", "--json", "-"], ["list", file],
                  ["obligations", file], ["format", file], ["ask", file, "1/3"], ["explain", file, "half"],
                  ["trust", file, "half"], ["--version"], ["--help"]):
        with open("/dev/full", "wb") as full:
            done = run([seamproof, *words], stdout=full, stderr=subprocess.DEVNULL)
        report.expect(done.status == 74, f"{words[0]} to a full disk: status {done.status}")
        done = run(["sh", "-c", 'exec "$@" >&-', "sh", seamproof, *words], stderr=subprocess.DEVNULL)
        report.expect(done.status == 74, f"{words[0]} with stdout closed: status {done.status}")


def check_pipe(report, seamproof, folder):
    done = run(["bash", "-c", 'set -o pipefail; "$@" | true', "bash", seamproof, "verify", folder / "wider.seam",
                "--no-cache"])
    report.expect(done.status in (2, 1, 74, 141), f"into a broken pipe: status {done.status}\n{done.output}")


def check_report(report, seamproof, folder):
    out = folder / "out"
    good = [seamproof, "verify", folder / "a.seam", "--no-cache", "--out", out, "--html", "--fragments"]
    done = run(good)
    report.expect(done.status == 0, f"a report: status {done.status}\n{done.output}")
    before = tree(out)
    for size in (0, 100, 2000):
        done = run(good, preexec_fn=small_files(size))
        report.expect(done.status == 74, f"files of {size} bytes at most: status {done.status}\n{done.output}")
        after = tree(out)
        report.expect(not differences(before, after), f"files of {size} bytes: changed {differences(before, after)}")
    done = run([seamproof, "verify", folder / "a.seam", "--no-cache", "--out", folder / "a.seam"])
    report.expect(done.status == 74, f"a file in the place of the folder: status {done.status}\n{done.output}")
    if os.getuid() == 0 and os.access("/usr/bin/env", os.X_OK):
        os.chmod(folder, 0o755)
        done = run(good, preexec_fn=as_nobody)
        report.expect(done.status == 74, f"a folder of somebody else: status {done.status}\n{done.output}")
        report.expect(not differences(before, tree(out)), "a folder of somebody else was changed")
    done = run(good)
    report.expect(done.status == 0, f"then there is room again: status {done.status}\n{done.output}")
    report.expect(not differences(before, tree(out)), "the report is not the same as before")


def check_store(report, seamproof, folder):
    for place in ("/dev/null", "/dev/full", folder / "a.seam"):
        done = run([seamproof, "verify", folder / "a.seam", "--cache", place])
        report.expect(done.status == 0, f"a store that is {place}: status {done.status}\n{done.output}")
    done = run([seamproof, "verify", folder / "a.seam", "--cache", folder / "store"], preexec_fn=small_files(50))
    report.expect(done.status == 0, f"no room in the store: status {done.status}\n{done.output}")
    left = [name for name in tree(folder / "store") if "unfinished" in name]
    report.expect(not left, f"temporary files are left in the store: {left}")


def main(seamproof):
    report = Report()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "a.seam").write_text(FILE)
        (folder / "wider.seam").write_text(WIDER)
        check_outputs(report, seamproof, folder)
        check_pipe(report, seamproof, folder)
        check_report(report, seamproof, folder)
        check_store(report, seamproof, folder)
    report.end()


if __name__ == "__main__":
    main(sys.argv[1])
