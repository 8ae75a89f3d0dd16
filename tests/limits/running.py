# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs under test: started, ended, and what they left."""

import os
import pathlib
import subprocess
import time


class Finished:
    def __init__(self, status, output, seconds):
        self.status, self.output, self.seconds = status, output, seconds


def environment(**more):
    """Keeps nothing from one test to the next."""
    return {**os.environ, "XDG_CACHE_HOME": "/dev/null", "NO_COLOR": "1", **more}


def run(words, cwd=None, timeout=120, env=None, **more):
    """Runs to its end; stdout and stderr together. The status of a signal is 128 and its number."""
    begin = time.monotonic()
    done = subprocess.run(list(map(str, words)), cwd=cwd, timeout=timeout, env=env or environment(),
                          stdout=more.pop("stdout", subprocess.PIPE),
                          stderr=more.pop("stderr", subprocess.STDOUT), **more)
    status = done.returncode if done.returncode >= 0 else 128 - done.returncode
    return Finished(status, (done.stdout or b"").decode("utf-8", "replace"), time.monotonic() - begin)


def tree(folder):
    """Every file below a folder, by its relative path, with its bytes."""
    folder = pathlib.Path(folder)
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def differences(one, other):
    """The names of the files that are not the same in both trees."""
    return [name for name in sorted(one.keys() | other.keys()) if one.get(name) != other.get(name)]


class Report:
    """Collects what went wrong, and ends the test."""

    def __init__(self):
        self.failures = []

    def expect(self, condition, sentence):
        if not condition:
            self.failures.append(sentence)
            print("FAILED: " + sentence, flush=True)

    def end(self):
        print(f"{len(self.failures)} failures")
        raise SystemExit(1 if self.failures else 0)
