# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes a certificate at random, in a way that keeps most of it readable: numbers, indices, relations, lists."""
import copy
import re

RELATIONS = (">", ">=", "=", "!=", "<=", "<")
PARTS = ("statement nodes", "statement obligations", "statement obligations", "statement generators",
         "statement functions", "statement goal", "evidence nodes", "evidence proofs", "evidence proofs")


def places(value, path=()):
    """The paths to all lists and to all that is neither list nor object."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from places(inner, path + (name,))
        return
    if path:
        yield path, value
    if isinstance(value, list):
        for i, inner in enumerate(value):
            yield from places(inner, path + (i,))


def other(value, nodes, chance):
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return chance.choice((value + 1, value - 1, value + 2, 0, 1, chance.randrange(max(nodes, 1))))
    if value in RELATIONS:
        return chance.choice(RELATIONS)
    if value == "plain":
        return chance.choice(({"outside": 0}, {"outside": 1}))
    if re.fullmatch(r"-?\d+(/\d+)?", value):
        negative = value[1:] if value[0] == "-" else "1" if value == "0" else "-" + value
        return chance.choice((negative, "0", "1", "-1", "2", "-2", "1/2", "3", "1000", "1/1000"))
    return value


def change_list(value, chance):
    """One element less, one twice, two exchanged, or one in the place of another."""
    i, j = chance.randrange(len(value)), chance.randrange(len(value))
    way = chance.randrange(4)
    if way == 0:
        value.pop(i)
    elif way == 1:
        value.insert(i, copy.deepcopy(value[j]))
    elif way == 2:
        value[i], value[j] = value[j], value[i]
    else:
        value[i] = copy.deepcopy(value[j])


def tamper(certificate, chance):
    """Changes one thing, or nothing where there was none of the part that was chosen."""
    side, part = chance.choice(PARTS).split()
    within = certificate[side].get(part)
    found = list(places(within))
    if not found:
        return
    path, value = chance.choice(found)
    if isinstance(value, list):
        if value:
            change_list(value, chance)
        return
    nodes = len(certificate["statement"]["nodes"]) + len(certificate["evidence"]["nodes"])
    for name in path[:-1]:
        within = within[name]
    within[path[-1]] = other(value, nodes, chance)
