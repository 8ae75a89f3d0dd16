# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 templates_test.py PROJECT BIN: the steps of the templates in docs/ci, run as GitHub and GitLab run them.

The sources that a step builds are stood in for by a script `dev` that puts the programs of BIN where
the build would.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import yaml

PROJECT, BIN = (pathlib.Path(path) for path in sys.argv[1:3])
GITHUB = yaml.safe_load((PROJECT / "docs/ci/github/action.yml").read_text())
WORKFLOW = yaml.safe_load((PROJECT / "docs/ci/github/workflow.yml").read_text())
GITLAB = yaml.safe_load((PROJECT / "docs/ci/gitlab.yml").read_text())[".seamproof"]
PLAIN_PATH = "/usr/bin:/bin"


class Templates(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.write("claims/right.seam", "claim a: 1 + 1 = 2\n")
        self.write("more claims/wrong.seam", "claim w: 1 + 1 = 3\n")
        self.write("open.seam", "param a : function\nclaim o: for all s, t: (s - t)*(a(s) - a(t)) = 0\n")
        self.write("broken.seam", "claim a: 1 + ##[stop-commands]x = 3\n")
        dev = self.write("seamproof/dev",
                         f'#!/bin/sh\n[ "$1" = build ] && cd "$(dirname "$0")" && mkdir -p build/release && '
                         f'ln -sfn "{BIN}" build/release/bin\n')
        dev.chmod(0o755)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def bash(self, script, environment):
        return subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script], cwd=self.folder,
                              env={"HOME": str(self.folder), "LC_ALL": "C.UTF-8"} | environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def github(self, **given):
        """Runs the action: its last step's exit status and what all print."""
        inputs = {name: value.get("default") for name, value in GITHUB["inputs"].items()}
        inputs |= {name.replace("_", "-"): value for name, value in given.items()}
        self.assertNotIn(None, inputs.values(), "a required input is missing")
        path, summary = self.write("path", ""), self.write("summary", "")
        printed = ""
        for step in GITHUB["runs"]["steps"]:
            self.assertNotIn("${{", step["run"], "inputs come by the environment, lest they be run")
            if step.get("if") == "inputs.source != ''" and not inputs["source"]:
                continue
            environment = {name: re.sub(r"\$\{\{ inputs\.([a-z-]+) \}\}", lambda found: inputs[found[1]], value)
                           for name, value in step["env"].items()}
            ways = [*path.read_text().split(), PLAIN_PATH]
            finished = self.bash(step["run"], environment | {"PATH": ":".join(ways), "GITHUB_PATH": str(path),
                                                             "GITHUB_STEP_SUMMARY": str(summary)})
            printed += finished.stdout
            if finished.returncode:
                break
        return finished.returncode, printed

    def gitlab(self, **given):
        variables = {name: str(value).replace("$CI_PROJECT_DIR", str(self.folder))
                     for name, value in GITLAB["variables"].items()}
        script = "\n".join(GITLAB["before_script"] + GITLAB["script"])
        finished = self.bash(script, variables | given | {"PATH": PLAIN_PATH})
        return finished.returncode, finished.stdout

    def cases(self):
        return {case.get("name"): [part.tag for part in case if part.tag != "system-out"]
                for case in xml.parse(self.folder / "seamproof-results/junit.xml").iter("testcase")}

    def test_the_action_passes_where_all_is_as_expected(self):
        status, printed = self.github(files="claims", source="seamproof")
        self.assertEqual(status, 0, printed)
        self.assertNotIn("::", printed)
        self.assertEqual(self.cases(), {"a": []})
        for name in ("results.json", "results.sarif", "report.html", "certificates/a.json"):
            self.assertTrue((self.folder / "seamproof-results" / name).is_file(), name)
        self.assertIn("1 proven", (self.folder / "summary").read_text())

    def test_the_action_fails_where_a_claim_is_refuted_and_says_where(self):
        status, printed = self.github(files="claims\nmore claims\n", source="seamproof")
        self.assertEqual(status, 1, printed)
        self.assertRegex(printed, r"(?m)^::error file=more claims/wrong\.seam,line=1,")
        self.assertEqual(self.cases(), {"a": [], "w": ["failure"]})

    def test_undecided_claims_fail_unless_they_are_allowed(self):
        self.assertEqual(self.github(files="open.seam", source="seamproof")[0], 2)
        self.assertEqual(self.github(files="open.seam", source="seamproof", allow_undecided="true")[0], 0)
        self.assertEqual(self.cases(), {"o": ["skipped"]})

    def test_an_error_in_a_file_is_shown_and_gives_the_runner_no_command(self):
        status, printed = self.github(files="broken.seam", source="seamproof")
        self.assertEqual(status, 65, printed)
        self.assertRegex(printed, r"(?m)^::error file=broken\.seam,line=1,")
        self.assertNotIn("##[", printed)

    def test_inputs_are_never_run(self):
        self.github(files="$(touch run)\n`touch run`", source="seamproof", arguments="; touch run")
        self.assertFalse((self.folder / "run").exists())

    def test_the_workflow_gives_the_action_what_it_asks_for(self):
        steps = WORKFLOW["jobs"]["claims"]["steps"]
        given = next(step["with"] for step in steps if step.get("uses") == "./.github/actions/seamproof")
        self.assertEqual(self.github(**given)[0], 0)
        kept = next(step["with"] for step in steps if "upload-sarif" in step.get("uses", ""))
        self.assertTrue((self.folder / kept["sarif_file"]).is_file())

    def test_the_gitlab_job_has_the_status_of_the_claims_and_leaves_its_report(self):
        self.assertEqual(self.gitlab()[0], 0)
        self.assertEqual(self.gitlab(SEAMPROOF_FILES="claims open.seam")[0], 2)
        self.assertEqual(self.cases(), {"a": [], "o": ["failure"]})
        status, printed = self.gitlab(SEAMPROOF_FILES="open.seam", SEAMPROOF_ARGUMENTS="--allow-undecided")
        self.assertEqual(status, 0, printed)
        self.assertTrue((self.folder / GITLAB["artifacts"]["reports"]["junit"]).is_file())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
