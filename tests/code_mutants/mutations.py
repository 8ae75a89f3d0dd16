# SPDX-License-Identifier: GPL-3.0-or-later
"""One-line changes of C++ sources, in the order in which they stand: a demand dropped, a part of a condition dropped, a
comparison, a connective, a sign, a number, a relation or a word turned into another.

It reads the layout that clang-format gives the sources, in which binary operators have blanks around them and
templates have none.
"""
import re
from dataclasses import dataclass
from pathlib import Path

SWAPS = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " && ": " || ",
         " || ": " && ", " + ": " - ", " - ": " + ", " += ": " -= ", " -= ": " += "}
WORDS = {"true": "false", "false": "true", "nonnegative": "positive", "nonpositive": "negative", "positive": "nonnegative",
         "negative": "nonpositive", "min": "max", "max": "min", "low": "high", "high": "low", "all_of": "any_of",
         "any_of": "all_of", "none_of": "any_of"}
TOKEN = re.compile("|".join(re.escape(sign) for sign in sorted(SWAPS, key=len, reverse=True))
                   + r"|(?<![\w:.])-(?=[\w(])|(?<![\w)\]])!(?=[\w(])|(?<![\w.])[012](?![\w.'])"
                   + r"|\b(?:" + "|".join(WORDS) + r")\b")


@dataclass(frozen=True)
class Mutant:
    path: str    # relative to the root
    kind: str
    start: int   # of what is replaced, in the text of the file
    end: int
    text: str    # in its place
    key: str     # names it for as long as its line is not changed: path | kind | line | which of them

    def applied(self, source):
        return source[:self.start] + self.text + source[self.end:]


def blanked(source):
    """The source with comments and texts blanked out, of the same length."""
    return re.sub(r'//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|#include[^\n]*',
                  lambda found: " " * len(found.group()), source)


def closing(code, opening):
    """Where the bracket that opens there is closed."""
    depth = 0
    for i in range(opening, len(code)):
        depth += (code[i] in "([{") - (code[i] in ")]}")
        if depth == 0:
            return i
    raise ValueError("brackets do not match")


def parts(code, start, end, sign):
    """The parts of code[start:end] that the sign connects, outside all brackets, as pairs of start and end."""
    found, depth, begin = [], 0, start
    for i in range(start, end):
        depth += (code[i] in "([{") - (code[i] in ")]}")
        if depth == 0 and code.startswith(sign, i):
            found.append((begin, i))
            begin = i + len(sign)
    return found + [(begin, end)]


def changes(code):
    """Triples: kind, place, what stands there then."""
    for call in re.finditer(r"(?<![\w.])demand\(", code):
        if re.search(r"\b(void|bool)\s*$", code[:call.start()]):
            continue
        end = closing(code, call.end() - 1)
        yield "demand dropped", (call.start(), end + 1), "(void)0"
        condition = parts(code, call.end(), end, ",")[0]
        conjuncts = parts(code, *condition, "&&")
        if len(conjuncts) > 1:
            for begin, stop in conjuncts:
                yield "part of a condition dropped", (begin, stop), " true "
    for test in re.finditer(r"\bif \(", code):
        end = closing(code, test.end() - 1)
        if re.search(r";|[^=!<>]=[^=]", code[test.end():end]):
            continue  # it declares something
        yield "condition always true", (test.end(), end), "true"
        yield "condition never true", (test.end(), end), "false"
    for token in TOKEN.finditer(code):
        before = token.group()
        if before in SWAPS:
            yield "operator", token.span(), SWAPS[before]
        elif before in WORDS:
            yield "word", token.span(), WORDS[before]
        elif before in "!-":
            yield "sign dropped", token.span(), ""
        else:
            yield "number", token.span(), {"0": "1", "1": "0", "2": "1"}[before]


SWITCH = {"demand dropped": "({m} ? (void)0 : {code})", "part of a condition dropped": "({m} || ({code}))",
          "condition always true": "({m} || ({code}))", "condition never true": "(!{m} && ({code}))"}


def switched(source, chosen):
    """The source with all the mutants chosen in it, each at work where the global `mutant` has its number. Of those that
    stand in one place, or one in another, the outer ones are put round the inner ones."""
    found = sorted(chosen, key=lambda numbered: (numbered[1].start, -numbered[1].end))

    def written(start, end, inside):
        result, at = "", start
        while inside:
            number, first = inside[0]
            within = [other for other in inside[1:] if other[1].start < first.end]
            code = written(first.start, first.end, within)
            result += source[at:first.start] + SWITCH[first.kind].format(m=f"(mutant == {number})", code=code)
            inside, at = inside[1 + len(within):], first.end
        return result + source[at:end]

    return "#include <cstdlib>\nnamespace { const int mutant = std::atoi(std::getenv(\"MUTANT\")); }\n" + written(
        0, len(source), found)


def mutants(root, path):
    """Those of a file, in the order in which they stand."""
    return mutants_in(path, Path(root, path).read_text(encoding="utf-8"))


def mutants_in(path, source):
    seen = {}
    for kind, (start, end), text in sorted(changes(blanked(source)), key=lambda change: (change[1], change[0])):
        if source[start:end] == text:
            continue
        line = source[source.rfind("\n", 0, start) + 1:source.find("\n", start)].strip()
        name = f"{path} | {kind} | {line}"
        seen[name] = seen.get(name, 0) + 1
        yield Mutant(path, kind, start, end, text, f"{name} | {seen[name]}")
