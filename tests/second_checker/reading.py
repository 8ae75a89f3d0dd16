# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the text of a certificate: exactly the members of docs/certificates.md, rationals, digests."""
import hashlib
import json
import re
from fractions import Fraction

RATIONAL = re.compile(r"(-?)(0|[1-9][0-9]*)(?:/([1-9][0-9]*))?")


class Malformed(Exception):
    """The text is no certificate."""


def need(condition, message):
    if not condition:
        raise Malformed(message)


def members(value, *names):
    """The members of an object that has exactly these."""
    need(isinstance(value, dict) and set(value) == set(names), "expected an object with " + ", ".join(names))
    return [value[name] for name in names]


def only_member(value):
    """The kind and the content of an object with one member; of a string, the kind alone."""
    if isinstance(value, str):
        return value, None
    need(isinstance(value, dict) and len(value) == 1, "expected an object with one member")
    return next(iter(value.items()))


def listed(value, length=None):
    need(isinstance(value, list) and length in (None, len(value)), "expected a list")
    return value


def text(value):
    need(isinstance(value, str), "expected a text")
    return value


def truth(value):
    need(isinstance(value, bool), "expected true or false")
    return value


def whole(value, low=0, below=None):
    need(type(value) is int and value >= low and (below is None or value < below), "expected a whole number")
    return value


def rational(value):
    match = RATIONAL.fullmatch(text(value))
    need(match, "no rational: " + value)
    sign, over, under = match.groups()
    need(under != "1" and not (sign and over == "0"), "no rational: " + value)
    return Fraction(int(sign + over), int(under or 1))


def digest(statement):
    """The SHA-256 of the JSON text without blanks. Members stand in the order in which they were read."""
    line = json.dumps(statement, ensure_ascii=False, separators=(",", ":"))
    return hashlib.sha256(line.encode("utf-8")).hexdigest()


def no_double(pairs):
    need(len({name for name, _ in pairs}) == len(pairs), "a member twice")
    return dict(pairs)


def certificate(data):
    """The object that the text of a certificate stands for."""
    try:
        value = json.loads(data, object_pairs_hook=no_double)
    except (ValueError, RecursionError) as error:
        raise Malformed(str(error)) from None
    form, claim, correction, verdict, using, _, evidence = members(
        value, "format", "claim", "correction", "verdict", "using", "statement", "evidence")
    need(form == "seamproof certificate 1", "another format")
    text(claim), truth(correction), text(verdict), [text(name) for name in listed(using)]
    members(evidence, "generators", "nodes", "proofs")
    statement = value["statement"]
    names = ["generators", "nodes", "obligations", "guards", "goal"]
    if isinstance(statement, dict) and "functions" in statement:
        names.insert(1, "functions")
    members(statement, *names)
    return value
