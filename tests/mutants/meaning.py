# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions as values, by docs/language.md."""
from fractions import Fraction

import enclosures as N
import formulas as F
import nets
import solids
import values as W
from values import Closure, Function, Items, Matrix, Patch, Plane, Surface, Text, Unsupported, Vector

SOLIDS = ("tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron")
DOMAINS = ("triangle", "square")
PARAMETERS = {"u": 0, "s": 0, "v": 1, "t": 1}


class Range(list):
    pass


class Meaning:
    """The definitions of a file. Integer parameters and meshes have one value each, from `chosen`."""

    def __init__(self, items, chosen):
        self.definitions, self.chosen, self.values = {}, chosen, {}
        self.parameters = {}  # name of a continuous parameter: (set, condition)
        for item in items:
            if item[0] in ("let", "sequence", "root"):
                self.definitions[item[1]] = item
            if item[0] == "param":
                for name in item[1]:
                    self.definitions[name] = item
        self.conditions = [item[4] for item in items if item[0] == "param" and item[4] and "mesh" not in item[2]]
        self.variables = {}  # of continuous parameters: the variable, and the set it is in

    # ---- names
    def lookup(self, name, scope):
        if name in scope:
            return scope[name]
        if name in self.values:
            return self.values[name]
        if name in self.definitions:
            value = self.define(name, self.definitions[name])
            self.values[name] = value
            return value
        if name in SOLIDS:
            return solids.solid(name)
        if name == "pi":
            return F.make("pi")
        if name in ("u", "v", "w", "s", "t"):
            return F.var(name)
        return Text(name)

    def define(self, name, item):
        if item[0] == "let":
            return Closure(item[2], item[3], {}) if item[2] else self.value(item[3], {})
        if item[0] == "sequence":
            return item
        if item[0] == "root":
            return self.root(item)
        kind, domain = item[2], item[3]
        if kind[:1] == ["integer"]:
            return F.const(self.chosen[name])
        if kind[:1] == ["mesh"]:
            return solids.solid(self.chosen[name])
        dimension = int(kind[1]) if kind[:1] == ["vector"] else None
        rest = kind[2:] if dimension else kind
        if rest[:1] == ["function"]:
            arity = int(rest[2]) if len(rest) > 2 else 1
            if arity > 2:
                raise Unsupported("an arbitrary function of more than two numbers")
            parts = [self.arbitrary("%s.%d" % (name, i), arity) for i in range(dimension or 1)]
            return Function(arity, Vector(parts) if dimension else parts[0])
        if dimension:
            return Vector(self.parameter("%s[%d]" % (name, i + 1), None) for i in range(dimension))
        return self.parameter(name, domain)

    def parameter(self, name, domain):
        self.variables[name] = domain
        return F.var(name)

    def arbitrary(self, name, arity):
        """A polynomial with coefficients that are parameters."""
        powers = [(i, 0) for i in range(5)] if arity == 1 else [(i, j) for i in range(3) for j in range(3)]
        return F.total(F.mul(self.parameter("%s^%d,%d" % (name, i, j), None), F.mul(F.power(W.U, i), F.power(W.V, j))) for i, j in powers)

    def root(self, item):
        _, name, polynomial, domain = item
        f = self.scalar(polynomial, {name: F.var("#x")})
        low, high = (N.interval(F.evaluate(self.scalar(x, {}), {}, {})) for x in domain[2:4])
        low, high = low.low, high.high

        def sign(x):
            return N.sign(F.evaluate(f, {"#x": Fraction(x, N.ONE)}, {}))
        first, last = sign(low), sign(high)
        if first is None or last is None or first * last >= 0:
            raise Unsupported("a root without a change of sign")
        while high - low > 8:
            middle = (low + high) >> 1
            s = sign(middle)
            if not s:
                break
            low, high = (middle, high) if s == first else (low, middle)
        return F.make("solution", name, N.Interval(low, high))

    # ---- expressions
    def scalar(self, tree, scope):
        value = self.value(tree, scope)
        if not isinstance(value, F.Formula):
            raise Unsupported("expected a number, found " + type(value).__name__)
        return value

    def integer(self, tree, scope):
        return as_integer(self.value(tree, scope))

    def value(self, tree, scope):
        kind = tree[0]
        if kind == "number":
            return F.const(Fraction(tree[1]))
        if kind == "printed":
            return self.value(tree[2], scope)
        if kind == "name":
            return self.lookup(tree[1], scope)
        if kind in "+-*/^" and len(tree) == 3:
            return self.operation(kind, self.value(tree[1], scope), self.value(tree[2], scope))
        if kind == "minus":
            return self.operation("*", F.const(-1), self.value(tree[1], scope))
        if kind == "tuple":
            return Vector(self.value(x, scope) for x in tree[1])
        if kind == "list":
            return self.items(tree[1], scope)
        if kind == "matrix":
            rows = [self.items(row, scope) for row in tree[1]]
            if all(isinstance(x, F.Formula) for row in rows for x in row):
                return Matrix([list(row) for row in rows])
            return Items(rows)
        if kind == "range":
            return Range(F.const(k) for k in range(self.integer(tree[1], scope), self.integer(tree[2], scope) + 1))
        if kind == "index":
            return self.index(self.value(tree[1], scope), [self.integer(x, scope) for x in tree[2]])
        if kind == "call":
            return self.call(tree, scope)
        if kind == "plane":
            return Plane(self.value(tree[1], scope), self.scalar(tree[2], scope))
        if kind in ("net", "indexed", "from"):
            return nets.patch(self, tree, scope)
        raise Unsupported("a value of kind " + kind)

    def items(self, trees, scope):
        result = Items()
        for tree in trees:
            if tree[0] == "each":
                result += self.each(tree, scope)
            else:
                result.append(self.value(tree, scope))
        return result

    def each(self, tree, scope):
        return [self.value(tree[1], inner) for inner in self.scopes(tree[2], scope)]

    def scopes(self, bindings, scope):
        if not bindings:
            yield scope
            return
        names, domain, condition = bindings[0]
        if domain is None or condition is not None:
            raise Unsupported("a list over no finite set")
        for inner in self.bound(names, self.finite(domain, scope), scope):
            yield from self.scopes(bindings[1:], inner)

    def finite(self, domain, scope):
        if domain[0] == "interval":
            if domain[1] != "[" or domain[4] != "]":
                raise Unsupported("a list over an interval")
            return [self.value(domain[2], scope), self.value(domain[3], scope)]
        value = self.value(domain, scope)
        if not isinstance(value, (Items, Range)):
            raise Unsupported("no finite set")
        return value

    @staticmethod
    def bound(names, values, scope):
        for value in values:
            if len(names) == 1:
                yield {**scope, names[0]: value}
            else:
                if len(value) != len(names):
                    raise Unsupported("names for the wrong number of entries")
                yield {**scope, **dict(zip(names, value))}

    def operation(self, op, a, b):
        scalar_a, scalar_b = isinstance(a, F.Formula), isinstance(b, F.Formula)
        if scalar_a and scalar_b:
            if op == "^":
                return power(a, b)
            return {"+": F.add, "-": F.sub, "*": F.mul, "/": F.div}[op](a, b)
        if op in "+-":
            if isinstance(a, Patch) and isinstance(b, Vector):
                return W.mapped(a, None, b if op == "+" else W.scaled(F.const(-1), b))
            if isinstance(a, (Vector, Matrix)) and type(a) is type(b) and len(a) == len(b):
                f = F.add if op == "+" else F.sub
                if isinstance(a, Matrix):
                    return Matrix([[f(x, y) for x, y in zip(p, q)] for p, q in zip(a, b)])
                return Vector(self.operation(op, x, y) for x, y in zip(a, b))
        if op == "*":
            if scalar_b and not scalar_a:
                a, b, scalar_a = b, a, True
            if scalar_a:
                if isinstance(b, (Vector, Matrix)):
                    return W.scaled(a, b)
                if isinstance(b, (Patch, Surface)):
                    return self.image(Matrix([[a if i == j else F.ZERO for j in range(3)] for i in range(3)]), b)
            if isinstance(a, Matrix) and isinstance(b, Vector) and len(a[0]) == len(b):
                return W.times_vector(a, b)
            if isinstance(a, Matrix) and isinstance(b, Matrix) and len(a[0]) == len(b):
                return W.product(a, b)
            if isinstance(a, Vector) and isinstance(b, Matrix) and len(a) == len(b):
                return Vector(F.total(F.mul(x, row[j]) for x, row in zip(a, b)) for j in range(len(b[0])))
            if isinstance(a, Matrix) and isinstance(b, (Patch, Surface)):
                return self.image(a, b)
        if op == "/" and scalar_b and isinstance(a, (Vector, Matrix)):
            return W.scaled(F.div(F.ONE, b), a)
        raise Unsupported("%s %s %s" % (type(a).__name__, op, type(b).__name__))

    @staticmethod
    def image(matrix, b):
        if isinstance(b, Patch):
            return W.mapped(b, matrix)
        surface = Surface([W.mapped(p, matrix) for p in b.patches])
        surface.is_orbit = b.is_orbit and all(matrix[i][j] is (matrix[0][0] if i == j else F.ZERO) for i in range(3) for j in range(3))
        return surface

    def index(self, value, indices):
        if isinstance(value, Matrix) or (isinstance(value, Items) and len(indices) == 2):
            rows = value
            if len(indices) == 1 and 1 <= indices[0] <= len(rows):
                return Vector(rows[indices[0] - 1])
            if len(indices) == 2 and 1 <= indices[0] <= len(rows) and 1 <= indices[1] <= len(rows[indices[0] - 1]):
                return rows[indices[0] - 1][indices[1] - 1]
        elif isinstance(value, list) and len(indices) == 1 and 1 <= indices[0] <= len(value):
            return value[indices[0] - 1]
        raise Unsupported("an index out of range")

    # ---- calls
    def call(self, tree, scope):
        callee, arguments = tree[1], tree[2]
        name = callee[1] if callee[0] == "name" and callee[1] not in scope and callee[1] not in self.definitions else None
        if name:
            import functions
            return functions.call(self, name, arguments, scope)
        f = self.lookup(callee[1], scope) if callee[0] == "name" else self.value(callee, scope)
        if isinstance(f, tuple) and f[0] == "sequence":
            return self.sequence(f, self.integer(arguments[0], scope))
        return self.apply(f, [self.value(a, scope) for a in arguments])

    def sequence(self, item, index):
        _, name, parameter, start, step = item
        if index < 0:
            raise Unsupported("a sequence before its start")
        value = self.value(start, {})
        for k in range(index):
            value = self.value(step, {parameter: F.const(k), name: Function(1, value)})
        return value

    def apply(self, f, arguments):
        if isinstance(f, Closure):
            if len(f.parameters) != len(arguments):
                raise Unsupported("a function with the wrong number of arguments")
            return self.value(f.body, {**f.scope, **dict(zip(f.parameters, arguments))})
        if isinstance(f, Function):
            if len(arguments) != f.arity or not all(isinstance(a, F.Formula) for a in arguments):
                raise Unsupported("a function with the wrong number of arguments")
            return W.at(f.value, arguments)
        raise Unsupported("a call of " + type(f).__name__)

    def function(self, f, arity=None):
        """A closure, patch or curve as a function of #1, #2."""
        if isinstance(f, Function):
            return f
        if isinstance(f, Closure) and len(f.parameters) in (1, 2):
            return Function(len(f.parameters), self.apply(f, [W.U, W.V][:len(f.parameters)]))
        raise Unsupported("no function: " + type(f).__name__)


def as_integer(value):
    x = F.value(value) if isinstance(value, F.Formula) else None
    if x is None or x.denominator != 1:
        raise Unsupported("expected an integer")
    return int(x)


def power(a, b):
    n = F.value(b)
    if n is None:
        base = F.value(a)
        if base is not None and base > 0:
            return F.call("exp", F.mul(b, F.call("log", a)))
        raise Unsupported("an exponent that is no number")
    if n.denominator != 1:
        raise Unsupported("a broken exponent")
    if abs(n) > 10000:
        raise Unsupported("a huge exponent")
    return F.power(a, int(n))
