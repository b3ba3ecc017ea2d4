"""Reads a Tia formula: `+ - * / ^`, functions, numbers, names. `^` binds tightest, above unary
minus, and to the right: -x^2 is -(x^2), 2^3^2 is 2^9.

A tree is a number, a name, or a tuple: (operation, operand, ...).
"""

import math
import re

from primitives import CannotExpress

TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|(\w+)|(.))")
BINDS = {"+": 1, "-": 1, "*": 2, "/": 2}  # of what stands between two operands, but for ^
CONSTANTS = {"pi": math.pi, "e": math.e}
FUNCTIONS = {
    "sin": math.sin, "cos": math.cos, "tan": math.tan, "asin": math.asin, "acos": math.acos,
    "atan": math.atan, "atan2": math.atan2, "sinh": math.sinh, "cosh": math.cosh,
    "tanh": math.tanh, "exp": math.exp, "log": math.log, "ln": math.log, "sqrt": math.sqrt,
    "abs": abs, "min": min, "max": max, "floor": math.floor, "ceil": math.ceil, "pow": pow,
}


class Reader:
    """Goes through the tokens of one formula."""

    def __init__(self, text):
        self.text = text
        self.tokens = [next(filter(None, found.groups())) for found in TOKEN.finditer(text.strip())]
        self.at = 0

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, wanted=None):
        token = self.peek()
        if not token or (wanted and token != wanted):
            raise CannotExpress(f"the formula {self.text}: {wanted or 'more'} expected at "
                                f"token {self.at + 1}")
        self.at += 1
        return token

    def sum(self, least=1):
        """What `+ - * /` that bind at least so tightly join."""
        left = self.signed()
        while BINDS.get(self.peek(), 0) >= least:
            operator = self.take()
            left = (operator, left, self.sum(BINDS[operator] + 1))
        return left

    def signed(self):
        if self.peek() in ("-", "+"):
            sign, operand = self.take(), self.signed()
            return ("neg", operand) if sign == "-" else operand
        base = self.operand()
        if self.peek() == "^":
            self.take()
            return ("^", base, self.signed())
        return base

    def operand(self):
        token = self.take()
        if token == "(":
            inner = self.sum()
            self.take(")")
            return inner
        if token[0].isdigit() or token[0] == ".":
            return float(token)
        if self.peek() != "(":
            return token
        self.take("(")
        arguments = [self.sum()]
        while self.peek() == ",":
            self.take()
            arguments.append(self.sum())
        self.take(")")
        return (token, *arguments)


def parsed(text, values=None):
    """The tree of a formula; names among `values` and constants become numbers."""
    reader = Reader(text)
    tree = reader.sum()
    if reader.peek():
        raise CannotExpress(f"the formula {text}: {reader.peek()} is one too many")
    return with_values(tree, {**CONSTANTS, **(values or {})})


def with_values(tree, values):
    if isinstance(tree, tuple):
        return (tree[0], *(with_values(primitive, values) for primitive in tree[1:]))
    return float(values[tree]) if tree in values else tree


def size(tree):
    """How many operations and operands."""
    return 1 + sum(map(size, tree[1:])) if isinstance(tree, tuple) else 1


def folded(tree):
    """The tree with what is a number computed."""
    if not isinstance(tree, tuple):
        return tree
    primitives = [folded(primitive) for primitive in tree[1:]]
    if all(isinstance(primitive, float) for primitive in primitives):
        return float(evaluator((tree[0], *primitives), ())())
    return (tree[0], *primitives)


# ---- as Python ------------------------------------------------------------------------------

def python_text(tree):
    if isinstance(tree, float):
        return f"({tree!r})"
    if isinstance(tree, str):
        return tree
    word, *primitives = tree
    primitives = [python_text(primitive) for primitive in primitives]
    if word == "neg":
        return f"(-{primitives[0]})"
    if word in BINDS or word == "^":
        return f"({primitives[0]} {'**' if word == '^' else word} {primitives[1]})"
    if word not in FUNCTIONS:
        raise CannotExpress(f"the function {word}")
    return f"{word}({', '.join(primitives)})"


def evaluator(tree, names):
    """A Python function of the names in their order."""
    return eval(f"lambda {', '.join(names)}: {python_text(tree)}", dict(FUNCTIONS))


# ---- as POV-Ray's functions -----------------------------------------------------------------

POV_WORDS = {"log": "ln"}  # POV-Ray's own log has the base 10
MOST_FACTORS, MOST_REPEATED = 4, 3


def pov_text(tree):
    """For `function { }`. Small powers of what is short become products: POV-Ray computes any power
    with pow(), which takes ten times as long."""
    if isinstance(tree, float):
        return f"{tree:.17g}" if tree >= 0 else f"({tree:.17g})"
    if isinstance(tree, str):
        return tree
    word, *operands = tree
    if word in ("^", "pow"):
        return pov_power(*operands)
    primitives = [pov_text(primitive) for primitive in operands]
    if word == "neg":
        return f"(-{primitives[0]})"
    if word in BINDS:
        return f"({primitives[0]} {word} {primitives[1]})"
    if word not in FUNCTIONS:
        raise CannotExpress(f"the function {word}")
    return f"{POV_WORDS.get(word, word)}({', '.join(primitives)})"


def pov_power(base, exponent):
    if exponent in range(2, MOST_FACTORS + 1) and size(base) <= MOST_REPEATED:
        return "(" + "*".join([pov_text(base)] * int(exponent)) + ")"
    return f"pow({pov_text(base)}, {pov_text(exponent)})"


# ---- as polynomials -------------------------------------------------------------------------

def product(a, b):
    total = {}
    for (i, j, k), c in a.items():
        for (l, m, n), d in b.items():
            powers = (i + l, j + m, k + n)
            total[powers] = total.get(powers, 0) + c * d
    return total


def total(a, b, sign=1):
    result = dict(a)
    for powers, c in b.items():
        result[powers] = result.get(powers, 0) + sign * c
    return result


def polynomial(tree):
    """{(i, j, k): c} for the sum of c x^i y^j z^k. Errors: CannotExpress for what is none."""
    if isinstance(tree, float):
        return {(0, 0, 0): tree}
    if tree in ("x", "y", "z"):
        return {tuple(int(tree == axis) for axis in "xyz"): 1.0}
    word, *primitives = tree
    if word == "^" and isinstance(primitives[1], float) and primitives[1] in range(0, 33):
        result = {(0, 0, 0): 1.0}
        for _ in range(int(primitives[1])):
            result = product(result, polynomial(primitives[0]))
        return result
    if word == "/" and isinstance(primitives[1], float):
        return product(polynomial(primitives[0]), {(0, 0, 0): 1 / primitives[1]})
    if word == "neg":
        return product(polynomial(primitives[0]), {(0, 0, 0): -1.0})
    if word not in ("+", "-", "*"):
        raise CannotExpress(f"{word} in a polynomial")
    a, b = map(polynomial, primitives)
    return product(a, b) if word == "*" else total(a, b, 1 if word == "+" else -1)


def terms(text, values=None):
    """A formula as `algebraic` has it: [[i, j, k, c], ...]."""
    found = polynomial(folded(parsed(text, values)))
    return [[*powers, c] for powers, c in sorted(found.items(), reverse=True) if abs(c) > 1e-14]
