# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the text of a .seam file into nested tuples, as docs/language.md says; shares nothing with the programs."""
import re

GREEK = dict(zip("αβγδεζηθικλμνξοπρσςτυφχψω", "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi "
                 "omicron pi rho sigma sigma tau upsilon phi chi psi omega".split()))
GREEK.update({upper.upper(): name.capitalize() for upper, name in list(GREEK.items()) if upper.upper() != upper})
SIGNS = {"·": "*", "≤": "<=", "≥": ">=", "≠": "!=", "≈": "~", "∈": " in ", "∀": "for all ", "∃": "for some ", "¬": "not ",
         "∧": " and ", "∨": " or ", "√": " sqrt ", "\r\n": "\n", "\ufeff": ""}
NAME = r"[A-Za-z][A-Za-z0-9_']*(?:\.[A-Za-z0-9_'][A-Za-z0-9_']*)*"
TOKEN = re.compile(r"\s*(?:#[^\n]*\s*)*(?:(\d+(?:\.\d+)?)|(" + NAME + r")|\"([^\"\n]*)\"|(<=|>=|!=|->|\.\.|[-+*/^=<>~()\[\]{},:;])|$)")
ID = re.compile(r"\s*([A-Za-z0-9_](?:[.:-]*[A-Za-z0-9_])*)")
ITEMS = set("paper section let sequence param root include define claim table figure ask".split())
CLAUSES = set("corrected expect using by truncated then of in where labelled coloured with digits generic at".split())
WORDS = CLAUSES | ITEMS | set("and or not implies iff for solve gives none one".split()) - {"at", "of", "then", "with", "digits", "generic", "labelled", "coloured"}


class NotRead(Exception):
    pass


class Reader:
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

    # ---- statements
    def statement(self):
        left = self.implication()
        while self.takes("iff"):
            left = ("iff", left, self.implication())
        return left

    def implication(self):
        left = self.disjunction()
        return ("implies", left, self.implication()) if self.takes("implies") else left

    def disjunction(self):
        left = self.conjunction()
        while self.takes("or"):
            left = ("or", left, self.conjunction())
        return left

    def conjunction(self):
        left = self.negation()
        while self.takes("and"):
            left = ("and", left, self.negation())
        return left

    def negation(self):
        if self.takes("not"):
            return ("not", self.negation())
        if self.peek() == "for":
            return self.quantified()
        if self.peek() == "solve":
            return self.solve()
        return self.relation()

    def relation(self):
        parts, operators = [self.range()], []
        while self.peek() in ("=", "!=", "<", "<=", ">", ">=", "~"):
            operators.append(self.next())
            begin = self.token()[3]
            parts.append(self.range())
            if operators[-1] == "~":
                parts[-1] = ("printed", self.text[begin:self.at], parts[-1])
        if not operators:
            return parts[0]
        return ("relation", operators, parts, bool(operators[-1] == "~" and self.takes("truncated")))

    def quantified(self):
        self.needs("for")
        some = "some" if self.takes("some") else "all"
        everywhere = some == "all" and bool(self.takes("all"))
        bindings = self.bindings(True)
        self.needs(":")
        return ("for", some, bindings, self.statement())

    def bindings(self, may_be_bare=False):
        bindings = []
        while True:
            if self.takes("("):
                names = [self.name()]
                while self.takes(","):
                    names.append(self.name())
                self.needs(")")
            else:
                names = [self.name()]
            domain = self.set() if self.takes("in") else None
            if domain is None and not may_be_bare:
                raise NotRead("a binding without a set")
            bindings.append([names, domain, None])
            if self.takes("where"):
                bindings[-1][2] = self.disjunction()
            if not self.takes(","):
                return bindings

    def set(self):
        if self.peek() in ("[", "("):
            start, opening = self.at, self.next()
            try:
                low = self.range()
                if self.takes(","):
                    high = self.range()
                    closing = self.takes("]", ")")
                    if closing and (opening, closing) != ("[", "]") or closing == "]" and opening == "[":
                        if self.peek() not in ("[", "(", "*", "+", "..") :
                            return ("interval", opening, low, high, closing)
            except NotRead:
                pass
            self.at = start
        return self.range()

    def solve(self):
        self.needs("solve")
        unknowns = self.bindings(True)
        self.needs(":")
        system = self.disjunction()
        condition = self.disjunction() if self.takes("where") else None
        self.needs("gives")
        if self.takes("none"):
            return ("solve", unknowns, system, condition, [])
        if self.takes("one"):
            approximation = None
            if self.takes("~"):
                begin = self.token()[3]
                value = self.range()
                approximation = ("printed", self.text[begin:self.at], value)
            return ("solve one", unknowns, system, condition, approximation)
        solutions = [self.range()]
        while self.takes(","):
            solutions.append(self.range())
        return ("solve", unknowns, system, condition, solutions)

    # ---- values
    def range(self):
        left = self.sum()
        return ("range", left, self.sum()) if self.takes("..") else left

    def sum(self):
        left = self.product()
        while self.peek() in ("+", "-"):
            left = (self.next(), left, self.product())
        return left

    def product(self):
        left = self.minus()
        while self.peek() in ("*", "/"):
            left = (self.next(), left, self.minus())
        return left

    def minus(self):
        if self.takes("-"):
            return ("minus", self.minus())
        return self.power()

    def power(self):
        base = self.postfix(self.primary())
        return ("^", base, self.minus()) if self.takes("^") else base

    def postfix(self, value, adjacent=False):
        while self.peek() in ("(", "[") and self.token()[0] == 4:
            if adjacent and self.token()[3] != self.at:
                break
            if self.at_line_begin() and self.peek() == "[":
                break
            if self.takes("("):
                value = ("call", value, self.arguments(")"))
            else:
                self.needs("[")
                value = ("index", value, self.arguments("]"))
        return value

    def arguments(self, closing):
        result = []
        while not self.takes(closing):
            result.append(self.argument())
            if self.peek() != closing:
                self.needs(",")
        return result

    def argument(self):
        start = self.at
        if self.token()[0] == 2:
            name = self.next()
            if self.takes("="):
                return ("named", name, self.sum())
            self.at = start
        value = self.statement()
        return self.each(value)

    def each(self, value):
        if not self.takes("for"):
            return value
        start = self.at
        if self.token()[0] == 2:
            name = self.next()
            if self.takes("->"):
                target = ("infinity",) if self.takes("infinity") else self.sum()
                return ("limit", value, name, target)
            self.at = start
        return ("each", value, self.bindings(True))

    def rows(self):
        """What stands between [ and ], as rows."""
        self.needs("[")
        rows = [[]]
        while not self.takes("]"):
            rows[-1].append(self.weighted())
            if self.takes(";"):
                if self.peek() != "]":
                    rows.append([])
            elif self.peek() != "]":
                self.needs(",")
        return rows

    def weighted(self):
        value = self.each(self.statement())
        return ("weighted", value, self.range()) if self.takes(":") else value

    def primary(self):
        kind, text, end, _ = self.token()
        if kind == 1:
            self.at = end
            return ("number", text)
        if kind == 3:
            self.at = end
            return ("string", text)
        if text == "(":
            self.next()
            values = [self.statement()]
            while self.takes(","):
                values.append(self.statement())
            self.needs(")")
            return values[0] if len(values) == 1 else ("tuple", values)
        if text == "[":
            rows = self.rows()
            return ("list", rows[0]) if len(rows) == 1 else ("matrix", rows)
        if kind != 2:
            raise NotRead("expected a value at " + self.text[self.at:self.at + 40])
        if text in ("triangle_patch", "quad_patch", "curve", "rational"):
            return self.patch()
        if text == "plane":
            self.next()
            normal = self.postfix(self.primary(), adjacent=True)
            return ("plane", normal, self.minus())
        if text == "sqrt" and self.token(end)[1] != "(":
            self.next()
            return ("call", ("name", "sqrt"), [self.postfix(self.primary())])
        if text in WORDS:
            raise NotRead("'%s' is a word, at %s" % (text, self.text[self.at:self.at + 40]))
        self.at = end
        return ("infinity",) if text == "infinity" else ("name", text)

    def patch(self):
        if self.takes("rational"):
            raise NotRead("a rational patch")
        shape = self.next()
        if self.takes("from"):
            return ("from", shape, self.sum())
        if self.peek() != "[":
            degree = self.primary()
            self.needs("{")
            points = {}
            while not self.takes("}"):
                key = self.next()
                while self.takes(","):
                    key += "," + self.next()
                self.needs(":")
                points[key] = self.range()
                self.takes(";")
            return ("indexed", shape, degree, points)
        return ("net", shape, self.rows())

    # ---- items
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
