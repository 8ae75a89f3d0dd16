# SPDX-License-Identifier: GPL-3.0-or-later
"""The words of the language, one after the other."""
import re

GREEK = dict(zip("αβγδεζηθικλμνξοπρσςτυφχψω", "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi "
                 "omicron pi rho sigma sigma tau upsilon phi chi psi omega".split()))
GREEK.update({upper.upper(): name.capitalize() for upper, name in list(GREEK.items()) if upper.upper() != upper})
SIGNS = {"·": "*", "≤": "<=", "≥": ">=", "≠": "!=", "≈": "~", "∈": " in ", "∀": "for all ", "∃": "for some ", "¬": "not ",
         "∧": " and ", "∨": " or ", "√": " sqrt ", "\r\n": "\n", "\ufeff": ""}
NAME = r"[A-Za-z][A-Za-z0-9_']*(?:\.[A-Za-z0-9_'][A-Za-z0-9_']*)*"
TOKEN = re.compile(r"\s*(?:#[^\n]*\s*)*(?:(\d+(?:\.\d+)?)|(" + NAME + r")|\"([^\"\n]*)\"|(<=|>=|!=|->|\.\.|[-+*/^=<>~()\[\]{},:;])|$)")
ITEMS = set("paper section let sequence param root include define claim table figure ask".split())
CLAUSES = set("corrected expect using by truncated then of in where labelled coloured with digits generic at".split())
WORDS = CLAUSES | ITEMS | set("and or not implies iff for solve gives none one".split()) - {"at", "of", "then", "with", "digits", "generic", "labelled", "coloured"}


class NotRead(Exception):
    pass


class Tokens:
    def __init__(self, text):
        for sign, spelled in {**SIGNS, **GREEK}.items():
            text = text.replace(sign, spelled)
        self.text, self.at, self.cache = text, 0, {}

    # ---- tokens
    def token(self, at=None):
        at = self.at if at is None else at
        if at not in self.cache:
            match = TOKEN.match(self.text, at)
            if not match:
                raise NotRead(self.text[at:at + 40])
            kind = match.lastindex or 0
            self.cache[at] = (kind, match.group(kind) if kind else "", match.end(), match.start(kind) if kind else match.end())
        return self.cache[at]

    def peek(self):
        return self.token()[1] if self.token()[0] != 3 else '"'

    def next(self):
        kind, text, end, _ = self.token()
        self.at = end
        return text

    def takes(self, *words):
        if self.token()[0] != 3 and self.token()[1] in words and self.token()[1]:
            return self.next()
        return None

    def needs(self, word):
        if not self.takes(word):
            raise NotRead("expected %s at %s" % (word, self.text[self.at:self.at + 40]))

    def name(self):
        if self.token()[0] != 2:
            raise NotRead("expected a name at " + self.text[self.at:self.at + 40])
        return self.next()

    def at_line_begin(self):
        start = self.token()[3]
        return self.text[:start].rsplit("\n", 1)[-1].strip() == ""
