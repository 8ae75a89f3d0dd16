# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates that were tampered with: coqc must refuse what is exported of them, in the
theorem of the obligation, because the computation does not come to `true`.

    tampered_test.py SEAMPROOF REPORTS WORK
"""

import json
import re
import shutil
import sys

import coqc

PAPER = "platonic-spheroids"


def is_pieces(proof):
    return isinstance(proof, dict) and "pieces" in proof


def is_split(step):
    return isinstance(step, dict) and "split" in step


def new_node(certificate, node):
    nodes = certificate["evidence"]["nodes"]
    nodes.append(node)
    return len(certificate["statement"]["nodes"]) + len(nodes) - 1


def first(certificate, wanted):
    for index, (obligation, proof) in enumerate(zip(certificate["statement"]["obligations"],
                                                    certificate["evidence"]["proofs"])):
        if wanted(obligation, proof):
            return index
    return None


def leaf_removed(certificate):
    """The last piece of a subdivision is not looked at."""
    index = first(certificate, lambda o, p: is_pieces(p) and any(map(is_split, p["pieces"]["steps"])))
    if index is not None:
        certificate["evidence"]["proofs"][index]["pieces"]["steps"].pop()
    return index


def leaf_added(certificate):
    """A subdivision has a piece more than there are."""
    index = first(certificate, lambda o, p: is_pieces(p))
    if index is not None:
        certificate["evidence"]["proofs"][index]["pieces"]["steps"].append("plain")
    return index


def split_undone(certificate):
    """A piece that had to be split is said to be plain."""
    index = first(certificate, lambda o, p: is_pieces(p) and is_split(p["pieces"]["steps"][0]))
    if index is not None:
        certificate["evidence"]["proofs"][index]["pieces"]["steps"] = ["plain"]
    return index


def weight_negative(certificate):
    """A split at a point outside the piece."""
    index = first(certificate, lambda o, p: is_pieces(p) and is_split(p["pieces"]["steps"][0]))
    if index is not None:
        at = certificate["evidence"]["proofs"][index]["pieces"]["steps"][0]["at"]
        at[0] = new_node(certificate, "-1")
    return index


def sign_turned(certificate):
    """The opposite is claimed, with the same evidence."""
    index = first(certificate, lambda o, p: is_pieces(p))
    if index is not None:
        sign = certificate["statement"]["obligations"][index]["sign"]
        sign["relation"] = {">": "<", "<": ">", ">=": "<", "<=": ">"}[sign["relation"]]
    return index


def coefficient_changed(certificate):
    """A number in an identity is another one."""
    index = first(certificate, lambda o, p: "zero" in o and p == "computation")
    if index is None or certificate["verdict"] != "proven":
        return None
    nodes = certificate["statement"]["nodes"]
    zero = certificate["statement"]["obligations"][index]
    nodes_before = len(nodes)
    nodes += ["1/1000000007", {"sum": [zero["zero"], nodes_before]}]
    for proof in certificate["evidence"]["proofs"]:
        if proof != "computation":
            return None  # terms of the evidence would have to be numbered anew
    if certificate["evidence"]["nodes"]:
        return None
    zero["zero"] = nodes_before + 1
    return index


def witness_moved(certificate):
    """A point at which a sign fails is another point, outside the domain."""
    index = first(certificate, lambda o, p: isinstance(p, dict) and "witness" in p and "sign" in o and
                  o["sign"]["factors"])
    if index is not None:
        values = certificate["evidence"]["proofs"][index]["witness"]["point"]["values"]
        values[0] = new_node(certificate, "7")
    return index


def interval_moved(certificate):
    """A generator is the other root of its polynomial."""
    generators = certificate["statement"]["generators"]
    index = first(certificate, lambda o, p: "sign" in o and not o["sign"]["factors"] and p == "computation")
    if not generators or index is None or generators[0]["low"] != "2" or generators[0]["high"] != "3":
        return None
    generators[0]["low"], generators[0]["high"] = "-3", "-2"
    return -1  # some theorem


TAMPERINGS = [leaf_removed, leaf_added, split_undone, weight_negative, sign_turned,
              coefficient_changed, witness_moved, interval_moved]


def refusal(folder, name, index):
    """Empty if coqc refuses the file for the stated reason, else what happened."""
    status, said = coqc.compile_file(folder, name, 200)
    if status == 0:
        return "coqc accepts it"
    place = re.search(r"line (\d+)", said)
    if status != 1 or not place:
        return f"coqc: {status}: {said[:500]}"
    lines = (folder / name).read_text().splitlines()[:int(place[1])]
    theorem = [line.split()[1] for line in lines if line.startswith("Theorem ")][-1]
    if index >= 0 and theorem != f"obligation_{index + 1}":
        return f"coqc refuses {theorem}, not obligation_{index + 1}"
    if not re.search(r'"true = true"\s+while\s+it\s+is\s+expected', said):
        return f"coqc refuses it for another reason: {said[:500]}"
    return ""


coqc.need_coqc()
seamproof, reports, work = sys.argv[1], coqc.folder(sys.argv[2]), coqc.folder(sys.argv[3])
certificates = reports / PAPER / "certificates"
bad = []
for tamper in TAMPERINGS:
    done = False
    for path in sorted(certificates.iterdir(), key=lambda path: (path.stat().st_size, path.name)):
        certificate = json.loads(path.read_text())
        index = tamper(certificate)
        if index is None or ".corrected" in path.name:
            continue
        source = work / "tampered"
        shutil.rmtree(source, ignore_errors=True)
        shutil.copytree(reports / PAPER, source, ignore=shutil.ignore_patterns("*.pdf", "*.tex"))
        (source / "certificates" / path.name).write_text(json.dumps(certificate))
        out = work / "out"
        names, _ = coqc.export(seamproof, source, out, "--claim", certificate["claim"])
        coqc.compile_library(out, work / "library")
        what = refusal(out, names[0], index)
        if what:
            bad.append(f"{tamper.__name__}: {certificate['claim']}: {what}")
        print(f"{tamper.__name__}: {certificate['claim']}: {what or 'refused'}")
        done = True
        break
    if not done:
        bad.append(f"{tamper.__name__}: there is no certificate to tamper with")
for fault in bad:
    print("FAILED:", fault)
sys.exit(1 if bad else 0)
