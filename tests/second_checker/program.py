# SPDX-License-Identifier: GPL-3.0-or-later
"""The straight-line program of a certificate: what its symbols are, and its terms as polynomials in normal form."""
from polynomial import NotJudged, Polynomial
from reading import Malformed, listed, members, need, only_member, rational, text, whole
from tower import Refused, Tower


class Program:
    """After all generators and functions are there, `term(i)` is node i in normal form."""

    def __init__(self, certificate):
        statement, evidence = certificate["statement"], certificate["evidence"]
        self.nodes = []
        self.numbers = {}     # {name: number of its symbol}
        self.generators = {}  # {symbol: None for a root, or (function, argument)}
        self.functions = {}   # {symbol: (kind, term)} in the order of the statement, kind a degree or a name
        self.tower = Tower()
        self.memo = {}
        self.in_radicands = set()
        self.read_nodes(statement["nodes"])
        self.of_statement = len(self.nodes)
        stated = {node[1] for node in self.nodes if node[0] == "symbol"}
        for generator in listed(statement["generators"]):
            self.add_generator(generator, self.of_statement)
        for function in listed(statement.get("functions", [])):
            self.add_function(function)
        self.read_nodes(evidence["nodes"])
        for generator in listed(evidence["generators"]):
            if isinstance(generator, dict) and generator.get("name") in stated:
                raise Refused("a generator of the evidence takes the name of a symbol of the statement")
            self.add_generator(generator, len(self.nodes))

    def read_nodes(self, nodes):
        for node in listed(nodes):
            here = len(self.nodes)
            kind, content = ("rational", node) if isinstance(node, str) else only_member(node)
            if kind == "rational":
                content = Polynomial.constant(rational(content))
            elif kind == "symbol":
                content = text(content)
            elif kind in ("sum", "product"):
                content = [whole(term, 0, here) for term in listed(content)]
            elif kind == "power":
                base, exponent = listed(content, 2)
                content = whole(base, 0, here), whole(exponent)
            else:
                raise Malformed("no node: " + kind)
            self.nodes.append((kind, content))

    def symbol(self, name):
        return self.numbers.setdefault(name, len(self.numbers))

    def fresh(self):
        """A symbol that stands in no term: a coordinate."""
        return self.symbol(("coordinate", len(self.numbers)))

    def new_name(self, name):
        symbol = self.symbol(text(name))
        if symbol in self.generators or symbol in self.functions:
            raise Refused("two generators or functions of one name")
        return symbol

    def add_generator(self, generator, below):
        need(isinstance(generator, dict), "expected a generator")
        if "polynomial" in generator:
            name, polynomial, low, high = members(generator, "name", "polynomial", "low", "high")
            symbol = self.new_name(name)
            polynomial = self.term(whole(polynomial, 0, below))
            self.within(polynomial, set(self.generators) | {symbol}, "the polynomial of a generator")
            self.tower.add_root(symbol, polynomial, rational(low), rational(high))
            self.generators[symbol] = None
        elif generator.get("function") == "pi":
            symbol = self.new_name(members(generator, "name", "function")[0])
            self.tower.add_value(symbol, "pi", None)
            self.generators[symbol] = "pi", Polynomial()
        else:
            name, function, argument = members(generator, "name", "function", "argument")
            need(function in ("exp", "log", "sin", "cos"), "another function of a generator")
            symbol = self.new_name(name)
            argument = self.term(whole(argument, 0, below))
            self.within(argument, set(self.generators), "the argument of a generator")
            self.tower.add_value(symbol, function, argument)
            self.square_of_sine(self.generators, symbol, function, argument)
            self.generators[symbol] = function, argument
        self.memo.clear()

    def add_function(self, function):
        need(isinstance(function, dict), "expected a function")
        if "radicand" in function:
            name, radicand, kind = members(function, "name", "radicand", "degree")
            whole(kind, 2)
        else:
            name, kind, radicand = members(function, "name", "function", "argument")
            need(kind in ("exp", "log", "sin", "cos"), "another function")
        symbol = self.new_name(name)
        term = self.term(whole(radicand, 0, self.of_statement))
        self.in_radicands |= self.written([radicand])
        if symbol in self.in_radicands:
            raise Refused("a function in its own radicand, or in that of an earlier one")
        if isinstance(kind, int):
            self.tower.rules.append((symbol, kind, term))
        else:
            self.square_of_sine(self.functions, symbol, kind, term)
        self.functions[symbol] = kind, term, radicand
        self.memo.clear()

    def square_of_sine(self, known, symbol, function, argument):
        """sin^2 = 1 - cos^2 for a cos before it with the same argument."""
        cosine = self.cosine_before(known, function, argument)
        if cosine is not None:
            self.tower.rules.append((symbol, 2, Polynomial.constant(1) - Polynomial.symbol(cosine, 2)))

    def cosine_before(self, known, function, argument):
        """Of generators or functions, the first cos before a sin of this argument."""
        if function == "sin":
            for other, entry in known.items():
                if entry and entry[0] == "cos" and entry[1] == argument:
                    return other
                if entry and entry[:2] == ("sin", argument):
                    return None
        return None

    @staticmethod
    def within(polynomial, allowed, what):
        if not polynomial.support() <= allowed:
            raise Refused("a symbol that is not known in " + what)

    def closure(self, terms):
        """The nodes that these need, ascending."""
        seen, todo = set(), list(terms)
        while todo:
            node = todo.pop()
            if node not in seen:
                seen.add(node)
                kind, content = self.nodes[node]
                todo += content if kind in ("sum", "product") else content[:1] if kind == "power" else []
        return sorted(seen)

    def term(self, index):
        if index not in self.memo:
            for node in self.closure([index]):
                if node not in self.memo:
                    self.memo[node] = self.tower.reduce(self.expand(*self.nodes[node]))
        return self.memo[index]

    def expand(self, kind, content):
        if kind == "rational":
            return content
        if kind == "symbol":
            return Polynomial.symbol(self.symbol(content))
        if kind == "power":
            base, exponent = self.memo[content[0]], content[1]
            if exponent > 4096:
                raise NotJudged("a power beyond all bounds")
            return base ** exponent
        result = Polynomial.constant(kind == "product")
        for operand in content:
            operand = self.memo[operand]
            result = result + operand if kind == "sum" else self.tower.reduce(result * operand)
        return result

    def written(self, terms):
        """The symbols that stand in these terms as written."""
        return {self.symbol(self.nodes[n][1]) for n in self.closure(terms) if self.nodes[n][0] == "symbol"}

    def functions_of(self, terms):
        """The functions that stand in these terms, in the radicands of these and so on, and the cos of a sin; by the
        order of the statement."""
        found, todo = set(), {s for s in self.written(terms) if s in self.functions}
        while todo:
            found |= todo
            todo = {s for s in self.written([self.functions[f][2] for f in todo]) if s in self.functions}
            todo |= {self.cosine_before(self.functions, *self.functions[f][:2]) for f in found} - {None}
            todo -= found
        return [s for s in self.functions if s in found]

    def variables(self, polynomial):
        """What stands in it beside generators and functions."""
        return {s for s in polynomial.support() if s not in self.generators and s not in self.functions}

    def is_number(self, polynomial):
        return polynomial.support() <= set(self.generators)

    def number(self, index):
        """A term without variables."""
        polynomial = self.term(index)
        if not self.is_number(polynomial):
            raise Refused("expected a number")
        return polynomial

    def sign(self, number):
        return self.tower.sign(number)


def relation_holds(sign, relation):
    return {">": sign > 0, ">=": sign >= 0, "=": sign == 0, "!=": sign != 0, "<=": sign <= 0, "<": sign < 0}[relation]


RELATIONS = (">", ">=", "=", "!=", "<=", "<")
