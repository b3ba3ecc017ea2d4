"""Vectors as tuples, and affine transforms as three rows of four."""

import math

IDENTITY = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0))


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scaled(a, k):
    return tuple(x * k for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return scaled(a, 1 / length(a))


def point_by(m, p):
    return tuple(dot(row[:3], p) + row[3] for row in m)


def vector_by(m, v):
    return tuple(dot(row[:3], v) for row in m)


def after(outer, inner):
    """The transform that applies `inner` first."""
    columns = [vector_by(outer, [row[i] for row in inner]) for i in range(3)]
    columns.append(point_by(outer, [row[3] for row in inner]))
    return tuple(zip(*columns))


def rotation(degrees):
    """About x, then y, then z."""
    m = IDENTITY
    for axis, angle in enumerate(degrees):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        i, j = (axis + 1) % 3, (axis + 2) % 3
        turn = [list(row) for row in IDENTITY]
        turn[i][i], turn[i][j], turn[j][i], turn[j][j] = c, -s, s, c
        m = after(turn, m)
    return m


def transform_of(steps):
    """One transform of a list of steps, the first step first."""
    m = IDENTITY
    for step in steps:
        (word, value), = step.items()
        if word == "rotate_degrees":
            one = rotation(value)
        elif word == "translate":
            one = [[*row[:3], t] for row, t in zip(IDENTITY, value)]
        elif word == "scale":
            factors = value if isinstance(value, list) else [value] * 3
            one = [[x * k for x in row] for row, k in zip(IDENTITY, factors)]
        else:
            one = value[:3]
        m = after(one, m)
    return m
