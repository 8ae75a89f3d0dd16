# SPDX-License-Identifier: GPL-3.0-or-later
"""Statements and values as nested tuples: the kind first, then its parts."""
from words import NotRead, Tokens, WORDS


class Trees(Tokens):
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
        if some == "all":
            self.takes("all")
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
