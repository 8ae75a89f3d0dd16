# SPDX-License-Identifier: GPL-3.0-or-later
"""Patches glued along sides: each side on one seam, the whole connected, V - E + F as said."""
from reading import listed, members, truth, whole
from tower import Refused


class Parts:
    """Sets that are joined (union and find)."""

    def __init__(self, items):
        self.above = {item: item for item in items}

    def find(self, item):
        while self.above[item] != item:
            self.above[item] = self.above[self.above[item]]
            item = self.above[item]
        return item

    def join(self, a, b):
        self.above[self.find(a)] = self.find(b)

    def count(self):
        return sum(item == above for item, above in self.above.items())


def is_polygon(sides):
    """Whether the sides form one closed polygon through all corners; in which sense each runs is not asked."""
    ends = [corner for side in sides for corner in side]
    corners = Parts(range(len(sides)))
    for a, b in sides:
        corners.join(a, b)
    return all(ends.count(c) == 2 for c in range(len(sides))) and corners.count() == 1


def holds(content):
    patches, seams, euler = members(content, "patches", "seams", "euler")
    whole(euler, -10 ** 9)
    patches = [[tuple(whole(c, 0, len(patch)) for c in listed(side, 2)) for side in listed(patch)]
               for patch in listed(patches)]
    if not patches or not all(map(is_polygon, patches)):
        raise Refused("no patch, or one that is no polygon")
    free = {(p, s) for p, patch in enumerate(patches) for s in range(len(patch))}
    corners = Parts((p, c) for p, patch in enumerate(patches) for c in range(len(patch)))
    whole_patches = Parts(range(len(patches)))
    for seam in listed(seams):
        one, side, other, other_side, reverse = members(seam, "patch", "side", "other_patch", "other_side", "reversed")
        for place in ((one, side), (other, other_side)):
            whole(place[1], 0, len(patches[whole(place[0], 0, len(patches))]))
            if place not in free:
                return False
            free.remove(place)
        a, b = patches[one][side]
        c, d = patches[other][other_side]
        if truth(reverse):
            c, d = d, c
        corners.join((one, a), (other, c))
        corners.join((one, b), (other, d))
        whole_patches.join(one, other)
    return not free and whole_patches.count() == 1 and corners.count() - len(seams) + len(patches) == euler
