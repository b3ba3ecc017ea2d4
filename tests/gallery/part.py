#!/usr/bin/env python3
"""Writes web/models/part.stl: a spur gear with a web, holes to lighten it, a hub and a keyway.

Twenty teeth of module 4 mm, involutes of 20 degrees. Lengths are millimetres, up is +z. Binary STL:
80 bytes of text, a count, and of each triangle its normal and corners in 32 bits.
Source: the involute from Litvin and Fuentes, "Gear Geometry and Applied Theory" (2004), 10.2.
"""

import struct
import sys
from math import atan2, cos, hypot, pi, radians, sin, tan

TEETH, MODULE = 20, 4.0
PITCH = TEETH * MODULE / 2
BASE, TIP, ROOT = PITCH * cos(radians(20)), PITCH + MODULE, PITCH - 1.25 * MODULE
RIM, WEB, HUB = 10.0, 4.0, 15.0  # half as thick as each is
RIM_INSIDE, HUB_OUTSIDE, BORE = 28.0, 13.5, 7.5
CHAMFER = 0.8


# ---- outlines, counter-clockwise from above -----------------------------------------------------


def circle(radius, count, center=(0.0, 0.0)):
    return [(center[0] + radius * cos(2 * pi * k / count),
             center[1] + radius * sin(2 * pi * k / count)) for k in range(count)]


def involute(angle):
    return tan(angle) - angle


def flank():
    """Half of a tooth: (radius, angle from its middle), from the root outward."""
    half = pi / (2 * TEETH) + involute(radians(20))
    points = [(ROOT, half + 0.012)]
    for k in range(3):
        r = BASE + (TIP - BASE) * k / 2
        points.append((r, half - involute(atan2((r * r / BASE / BASE - 1) ** 0.5, 1))))
    return points


def teeth():
    outline = []
    for tooth in range(TEETH):
        middle = 2 * pi * tooth / TEETH
        for r, a in flank():
            outline.append((r * cos(middle - a), r * sin(middle - a)))
        for r, a in reversed(flank()):
            outline.append((r * cos(middle + a), r * sin(middle + a)))
    return outline


def bore():
    """With a keyway, 4 mm wide."""
    half, top = 2.0, BORE + 1.8
    corner = atan2(half, (BORE * BORE - half * half) ** 0.5)
    steps = 26
    round_part = [corner + (2 * pi - 2 * corner) * k / steps for k in range(steps + 1)]
    return ([(BORE * cos(a), BORE * sin(a)) for a in round_part] +
            [(top, -half), (top, half)])


# ---- surfaces -----------------------------------------------------------------------------------


class Part:
    def __init__(self):
        self.triangles = []

    def strip(self, low, low_z, high, high_z):
        """A wall between two outlines of as many points; its outside is right of them."""
        for k in range(len(low)):
            a, b = (*low[k - 1], low_z), (*low[k], low_z)
            c, d = (*high[k], high_z), (*high[k - 1], high_z)
            self.triangles += [(a, b, c), (a, c, d)]

    def ring(self, outer, inner, z, center=(0.0, 0.0)):
        """What lies between two outlines, both seen from the centre all around, on both faces."""
        def angle(p):
            return atan2(p[1] - center[1], p[0] - center[0])
        both = [sorted(outline, key=angle) for outline in (outer, inner)]
        n, m = (len(outline) for outline in both)
        i = j = 0
        while i < n or j < m:
            far, near = both[0][i % n], both[1][j % m]
            next_far = angle(both[0][i]) if i < n else 9
            next_near = angle(both[1][j]) if j < m else 9
            if next_far <= next_near:
                self.faces(both[0][i - 1], far, both[1][(j - 1) % m], z)
                i += 1
            else:
                self.faces(both[0][(i - 1) % n], near, both[1][j - 1], z)
                j += 1

    def faces(self, a, b, c, z):
        self.triangles += [((*a, z), (*b, z), (*c, z)), ((*b, -z), (*a, -z), (*c, -z))]

    def wall(self, outline, z, inside=False):
        self.strip(*((outline, z, outline, -z) if inside else (outline, -z, outline, z)))

    def step(self, outline, high, low):
        """A wall on both faces, from one height down to another, that looks outward."""
        self.strip(outline, low, outline, high)
        self.strip(outline, -high, outline, -low)


def shrunk(outline, by):
    return [((1 - by / hypot(x, y)) * x, (1 - by / hypot(x, y)) * y) for x, y in outline]


def chamfered(part, outline, z, grow):
    """A wall outward (grow 1) or inward (-1) with both its edges cut. Returns: the faces' edge."""
    edge = shrunk(outline, grow * CHAMFER)
    flat = z - CHAMFER
    loops = [(edge, -z), (outline, -flat), (outline, flat), (edge, z)]
    for (a, low), (b, high) in zip(loops, loops[1:]):
        part.strip(*((a, low, b, high) if grow > 0 else (b, high, a, low)))
    return edge


def web(part):
    """Six sectors, each around a hole."""
    for k in range(6):
        middle = pi / 3 * k + pi / 6
        center = (20.75 * cos(middle), 20.75 * sin(middle))
        angles = [middle - pi / 6 + pi / 18 * j for j in range(7)]
        sector = ([(RIM_INSIDE * cos(a), RIM_INSIDE * sin(a)) for a in angles] +
                  [(HUB_OUTSIDE * cos(a), HUB_OUTSIDE * sin(a)) for a in reversed(angles)])
        hole = circle(4.8, 18, center)
        part.ring(sector, hole, WEB, center)
        part.wall(hole, WEB, inside=True)


def gear():
    part = Part()
    rim = circle(RIM_INSIDE, 36)
    part.ring(chamfered(part, teeth(), RIM, 1), rim, RIM)
    part.strip(rim, RIM, rim, WEB)
    part.strip(rim, -WEB, rim, -RIM)
    web(part)
    hub = circle(HUB_OUTSIDE, 36)
    part.step(hub, HUB - CHAMFER, WEB)
    edge = shrunk(hub, CHAMFER)
    part.strip(hub, HUB - CHAMFER, edge, HUB)
    part.strip(edge, -HUB, hub, CHAMFER - HUB)
    part.ring(edge, chamfered(part, bore(), HUB, -1), HUB)
    return part.triangles


def normal(a, b, c):
    u, v = ([q - p for p, q in zip(a, other)] for other in (b, c))
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = sum(x * x for x in n) ** 0.5
    return [x / length for x in n]


def rounded(triangle):
    return [[round(x, 4) + 0.0 for x in corner] for corner in triangle]


def main():
    triangles = [rounded(t) for t in gear()]
    out = [b"A spur gear, by tests/gallery of Tia".ljust(80), struct.pack("<I", len(triangles))]
    for t in triangles:
        numbers = [*(round(x, 4) + 0.0 for x in normal(*t)), *(x for corner in t for x in corner)]
        out.append(struct.pack("<12fH", *numbers, 0))
    sys.stdout.buffer.write(b"".join(out))


if __name__ == "__main__":
    main()
