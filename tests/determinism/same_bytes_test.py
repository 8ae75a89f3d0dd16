# SPDX-License-Identifier: GPL-3.0-or-later
"""same_bytes_test.py FILE.seam SEAMPROOF [OTHER-SEAMPROOF...]: equal input gives equal bytes, whatever is around it.

The report, the results and the lines on standard output are compared, byte for byte, between runs with 1, 2 and 8 jobs,
twice, in another folder under another absolute path, from another working directory, with and without a store, with a
store that has everything, in another locale and time zone, with another umask, another environment and another order of
memory; and between the programs, if there are several. Only the time that a line of standard output ends with may differ."""

import os
import pathlib
import re
import shutil
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "limits"))
from running import Report, differences, environment, run, tree  # noqa: E402

TIMES = re.compile(r"  \d+\.\d\d s$", re.MULTILINE)


def variants(program, folder, store):
    """Name; program; folder; working directory; environment; options; umask."""
    plain = environment()
    elsewhere = folder / "a much longer name of a folder, with blanks" / "ä"
    elsewhere.mkdir(parents=True)
    yield "1 job", program, folder / "p", folder, plain, ["--jobs", "1", "--no-cache"], 0o022
    yield "1 job again", program, folder / "p", folder, plain, ["--jobs", "1", "--no-cache"], 0o022
    yield "2 jobs", program, folder / "p", folder, plain, ["--jobs", "2", "--no-cache"], 0o022
    yield "8 jobs", program, folder / "p", folder, plain, ["--jobs", "8", "--no-cache"], 0o022
    yield "another folder", program, elsewhere, pathlib.Path("/"), plain, ["--no-cache"], 0o022
    yield "a new store", program, folder / "p", folder, plain, ["--cache", store], 0o022
    yield "a full store", program, folder / "p", folder, plain, ["--cache", store], 0o022
    other = environment(LC_ALL="de_DE.UTF-8", LANG="de_DE.UTF-8", TZ="Pacific/Kiritimati", TERM="dumb", COLUMNS="40")
    yield "another locale and time zone", program, folder / "p", folder, other, ["--no-cache"], 0o022
    yield "another umask", program, folder / "p", folder, plain, ["--cache", store], 0o077
    rough = environment(MALLOC_PERTURB_="165", MALLOC_ARENA_MAX="1", **{f"PADDING{k}": "x" * 1000 for k in range(50)})
    yield "another memory", program, folder / "p", folder, rough, ["--no-cache", "--jobs", "2"], 0o022


def main(file, programs, report):
    with tempfile.TemporaryDirectory() as name:
        wanted = None
        for number, program in enumerate(programs):
            folder = pathlib.Path(name) / f"{number}"
            (folder / "p").mkdir(parents=True)
            for label, binary, place, cwd, env, options, umask in variants(program, folder, folder / "store"):
                shutil.copy(file, place)
                out = place / "out"
                shutil.rmtree(out, ignore_errors=True)
                before = os.umask(umask)
                done = run([binary, "verify", place / pathlib.Path(file).name, "--out", out, "--html", "--fragments", *options],
                           cwd=cwd, env=env, timeout=3600)
                os.umask(before)
                found = {**tree(out), "standard output": TIMES.sub("", done.output).encode(), "status": str(done.status).encode()}
                print(f"{program}: {label}: {done.seconds:.1f} s, {len(found)} files", flush=True)
                if wanted is None:
                    wanted = found
                    report.expect(done.status in {0, 1, 2}, f"{label}: status {done.status}\n{done.output}")
                    report.expect(len(found) > 5, f"{label}: no report")
                report.expect(not differences(wanted, found), f"{program}: {label}: not the same: {differences(wanted, found)[:5]}")


if __name__ == "__main__":
    result = Report()
    main(sys.argv[1], sys.argv[2:], result)
    result.end()
