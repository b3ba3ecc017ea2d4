#!/usr/bin/env python3
"""Writes web/models/scan.ply: points with colours, as of a sea shell on a scanner's turntable.

The shell's surface: a circle that grows as it turns about the axis and sinks along it.
Source: Moseley, "On the Geometrical Forms of Turbinated and Discoid Shells" (1838). Binary, up is
+z. Colours are sRGB codes.
"""

import struct
import sys
from itertools import count
from math import cos, exp, pi, sin

POINTS, TURNS, GROWTH = 5600, 6, 0.085
LIGHT, DARK, PINK = (240, 222, 192), (150, 84, 48), (236, 150, 128)


def shell(t, a):
    """The point at the angle t along the spiral, from 0 outward, and a around its tube."""
    size = exp(GROWTH * (t - 2 * pi * TURNS))
    ribs = 1 + 0.05 * cos(11 * t) * max(0.0, cos(a - 0.6))
    out = 0.52 + 0.5 * ribs * cos(a)
    z = 2.1 * (1 - size) + size * 0.62 * ribs * sin(a) + 0.62 * size
    return size * out * cos(t), size * out * sin(t), z


def area(t, a, d=1e-4):
    """Of the surface, for a change of both."""
    p, q, r = shell(t, a), shell(t + d, a), shell(t, a + d)
    u, v = ([(y - x) / d for x, y in zip(p, other)] for other in (q, r))
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return sum(x * x for x in n) ** 0.5


def color(t, a):
    """Cream with brown flames; the inside, near the mouth, is pink."""
    flame = sin(9 * t + 1.2 * sin(4 * a)) * 0.6 + sin(23 * t + 3 * a) * 0.4
    share = min(1.0, max(0.0, 1.6 * flame - 0.1)) * (0.55 + 0.45 * cos(3 * a))
    mouth = max(0.0, 1 - (2 * pi * TURNS - t) / 0.5) * max(0.0, -cos(a))
    return [int(x + (y - x) * share + (z - x) * mouth) for x, y, z in zip(LIGHT, DARK, PINK)]


def chance():
    """Points spread evenly in the unit square, and a number that does not go with them.
    Source: Roberts, The Unreasonable Effectiveness of Quasirandom Sequences (2018)."""
    for k in count(1):
        yield tuple(k * share % 1 for share in (0.7548776662466927, 0.5698402909980532,
                                                0.8191725133961645))


def points():
    """As many to each part of the surface as it is large."""
    full = 2 * pi * TURNS
    most = max(area(full, 2 * pi * k / 64) for k in range(64)) * 1.05
    found = []
    for x, y, keep in chance():
        t, a = full * x, 2 * pi * y
        if area(t, a) > keep * most:
            found.append((*shell(t, a), *color(t, a)))
        if len(found) == POINTS:
            return found


def main():
    head = ["ply", "format binary_little_endian 1.0",
            "comment a sea shell, by tests/gallery of Tia", f"element vertex {POINTS}",
            *(f"property float {axis}" for axis in "xyz"),
            *(f"property uchar {channel}" for channel in ("red", "green", "blue")), "end_header"]
    rows = (struct.pack("<3f3B", *(round(c, 5) + 0.0 for c in row[:3]), *row[3:])
            for row in points())
    sys.stdout.buffer.write("".join(line + "\n" for line in head).encode() + b"".join(rows))


if __name__ == "__main__":
    main()
