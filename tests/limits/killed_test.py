# SPDX-License-Identifier: GPL-3.0-or-later
"""killed_test.py SEAMPROOF PAPER.seam [TIMES]: a run that is killed leaves nothing half done, and the same command ends the same.

`verify --out` is killed with SIGKILL at moments drawn with a seed, over its whole length, with a store that fills. After
each kill every file of the report is the whole one of the run before or of the run that ended. Then the command runs to
its end: the bytes are those of a run that nobody disturbed, and no temporary file is left. SIGINT ends with 130 and
SIGTERM with 143, soon."""

import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from running import Report, differences, environment, run, tree

SEED = 20261127
TRACES = (".unfinished-",)


def start(words, env):
    return subprocess.Popen(list(map(str, words)), env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                            start_new_session=True)


def is_whole(name, data):
    """Whether a file that a killed run left can be read to its end."""
    if name.endswith(".json"):
        try:
            json.loads(data)
        except ValueError:
            return False
    if name.endswith(".tex") and name.count("/") == 0:
        return data.rstrip().endswith(b"\\end{document}")
    if name.endswith(".svg"):
        return data.rstrip().endswith(b"</svg>")
    if name.endswith(".html"):
        return data.rstrip().endswith(b"</html>")
    return True


def wait_until_gone(group):
    """The processes of a killed program end a moment after it."""
    for _ in range(500):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return
        time.sleep(0.01)


def kill_at_many_moments(report, seamproof, paper, times, folder):
    out, store = folder / "out", folder / "store"
    command = [seamproof, "verify", paper, "--out", out, "--html", "--fragments", "--cache", store, "--quiet"]
    undisturbed = run([*command[:4], folder / "undisturbed", *command[5:8], store, "--quiet"])
    wanted = tree(folder / "undisturbed")
    seconds = run([*command[:4], folder / "again", *command[5:8], store, "--quiet"]).seconds
    shutil.rmtree(store)
    print(f"undisturbed: status {undisturbed.status}, {undisturbed.seconds:.1f} s, with a store {seconds:.1f} s; seed {SEED}")
    draw = random.Random(SEED)
    killed = 0
    for number in range(times):
        # Early ones find no store; of the later ones every second one is near the end, where files are written.
        length = undisturbed.seconds if number < times // 3 else seconds
        moment = draw.uniform(0, 0.8 * length) if number % 2 else draw.uniform(0.4 * length, length)
        process = start(command, environment())
        try:
            process.wait(timeout=moment)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            killed += 1
        wait_until_gone(process.pid)
        if out.exists():
            for name, data in tree(out).items():
                if any(trace in name for trace in TRACES):
                    continue
                report.expect(is_whole(name, data), f"kill {number} after {moment:.3f} s: {name} is half written")
    print(f"{killed} of {times} killed")
    last = run(command)
    report.expect(last.status == undisturbed.status, f"the last run ends with {last.status}: {last.output}")
    report.expect(not differences(wanted, tree(out)), f"not the same bytes: {differences(wanted, tree(out))[:5]}")
    left = [name for name in tree(out) if any(trace in name for trace in TRACES)]
    report.expect(not left, f"temporary files are left in the report: {left[:3]}")
    left = [name for name in tree(store) if any(trace in name for trace in TRACES)]
    report.expect(not left, f"temporary files are left in the store: {left[:3]}")


def end_by_signals(report, seamproof, folder):
    slow = folder / "slow.seam"
    slow.write_text("claim slow: for x in [0, 1], y in [0, 1], z in [0, 1]: (x - y)^2*(y - z)^2*(x*y - z^2)^2 + "
                    "(x^2 - 2*y*z)^2 + (x - z)^4 >= 0\n" * 1)
    for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
        for moment in (0.05, 0.3, 1.0):
            process = start([seamproof, "verify", slow, "--no-cache", "--effort", "100000000"], environment())
            time.sleep(moment)
            process.send_signal(number)
            begin = time.monotonic()
            found = process.wait(timeout=30)
            found = found if found >= 0 else 128 - found
            seconds = time.monotonic() - begin
            report.expect(found == status, f"signal {number} after {moment} s: status {found}, not {status}")
            report.expect(seconds < 5, f"signal {number} after {moment} s: ended after {seconds:.1f} s")
            wait_until_gone(process.pid)


def main(seamproof, paper, times):
    report = Report()
    with tempfile.TemporaryDirectory() as folder:
        kill_at_many_moments(report, seamproof, paper, times, pathlib.Path(folder))
        end_by_signals(report, seamproof, pathlib.Path(folder))
    report.end()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 12)
