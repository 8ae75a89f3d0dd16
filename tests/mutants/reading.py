# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the text of a .seam file, as docs/language.md says; shares nothing with the programs."""
import re

from trees import Trees
from words import ITEMS, NotRead

ID = re.compile(r"\s*([A-Za-z0-9_](?:[.:-]*[A-Za-z0-9_])*)")


class Reader(Trees):
    def items(self):
        while self.token()[0]:
            yield self.item()

    def id(self):
        self.token()  # past blanks and comments
        match = ID.match(self.text, self.token()[3])
        if not match:
            raise NotRead("expected an id")
        self.at = match.end()
        return match.group(1)

    def heading(self):
        while self.token()[0] == 3 or self.peek() == "at":
            self.next()

    def header(self):
        name, parameters = self.name(), []
        if self.takes("("):
            parameters = [self.name()]
            while self.takes(","):
                parameters.append(self.name())
            self.needs(")")
        return name, parameters

    def item(self):
        word = self.next()
        if word in ("paper", "section", "include"):
            self.skip()
            return (word,)
        if word == "let":
            name, parameters = self.header()
            self.needs("=")
            return ("let", name, parameters, self.range())
        if word == "define":
            name, parameters = self.header()
            self.needs(":")
            return ("let", name, parameters, self.statement())
        if word == "sequence":
            name, parameters = self.header()
            self.needs("=")
            start = self.sum()
            self.needs("then")
            return ("sequence", name, parameters[0], start, self.sum())
        if word == "root":
            name = self.name()
            self.needs("of")
            polynomial = self.sum()
            self.needs("in")
            return ("root", name, polynomial, self.set())
        if word == "curve":
            names = self.names()
            self.needs("generic")
            return ("param", names, ["vector", "3", "function"], None, None)
        if word == "param":
            return self.param()
        if word == "claim":
            return self.claim()
        if word == "table":
            return self.table()
        if word in ("figure", "ask"):
            self.skip()
            return (word,)
        raise NotRead("no item begins with '%s'" % word)

    def skip(self):
        while not (self.at_line_begin() and self.peek() in ITEMS | {"curve"}) and self.token()[0]:
            self.next()

    def names(self):
        names = [self.name()]
        while self.takes(","):
            names.append(self.name())
        return names

    def param(self):
        names, kind, domain, condition = self.names(), [], None, None
        if self.takes(":"):
            while (self.token()[0] in (1, 2) and self.peek() not in ("in", "where") and not self.at_line_begin()):
                kind.append(self.next())
        if self.takes("in"):
            domain = self.set()
        if self.takes("where"):
            condition = self.statement()
        return ("param", names, kind, domain, condition)

    def claim(self):
        identity = self.id()
        self.heading()
        self.needs(":")
        claim = {"id": identity, "printed": self.statement()}
        while True:
            if self.takes("corrected"):
                self.needs(":")
                claim["corrected"] = self.statement()
            elif self.takes("expect"):
                claim["expect"] = self.next()
            elif self.takes("using"):
                self.id()
                while self.takes(","):
                    self.id()
            elif self.takes("by"):
                raise NotRead("a hint")
            else:
                return ("claim", claim)

    def table(self):
        identity = self.id()
        self.heading()
        binding, labels, rows = None, [], []
        if self.takes("for"):
            binding = self.bindings()
        if self.takes("labelled"):
            labels = [self.next()]
            while self.takes(","):
                labels.append(self.next())
        self.needs(":")
        while self.token()[0] == 3:
            label, value, cells = self.next(), self.sum(), []
            self.needs("~")
            while True:
                begin = self.token()[3]
                printed = self.minus()
                cell = {"printed": ("printed", self.text[begin:self.at], printed)}
                if self.takes("corrected"):
                    begin = self.token()[3]
                    right = self.minus()
                    cell["corrected"] = ("printed", self.text[begin:self.at], right)
                cells.append(cell)
                if not self.takes(","):
                    break
            rows.append((label, value, cells, bool(self.takes("truncated"))))
        return ("table", identity, binding, labels, rows)


def slug(label):
    return re.sub(r"[^A-Za-z0-9_]+", "-", label).strip("-")


def read(text):
    return list(Reader(text).items())
