"""Shapes of a Tia scene as meshes, for programs that know nothing else: lists of flat numbers."""

import math
from array import array
from dataclasses import dataclass, field

from make_scenes import around
from primitives import CannotExpress, numbers
from vectors import add, cross, length, point_by, scaled, subtract, unit

NEAR, FAR = 20, 20_000  # half the sides of a square that stands for a plane and of its middle part
ROUND = 96  # sides of what is round


@dataclass
class Triangles:
    """Corners x, y, z in `positions`, three of them a triangle in `indices`; `smooth`: whether
    the normals at its corners, the means of the faces around them, shade a triangle."""
    positions: array = field(default_factory=lambda: array("f"))
    indices: array = field(default_factory=lambda: array("i"))
    smooth: bytearray = field(default_factory=bytearray)

    def add(self, points, triangles, smooth=False):
        """Appends triangles of indices into `points`."""
        first = len(self.positions) // 3
        for p in points:
            self.positions.extend(p)
        for t in triangles:
            self.indices.extend(first + i for i in t)
        self.smooth.extend(bytes([smooth]) * (len(self.indices) // 3 - len(self.smooth)))

    def add_square(self, center, side, other):
        """Appends center +- side +- other."""
        self.add([add(center, add(scaled(side, i), scaled(other, j)))
                  for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))], [(0, 1, 2), (0, 2, 3)])


def add_mesh(to, fields, m):
    flat = numbers(fields["positions"])
    to.add((point_by(m, flat[i:i + 3]) for i in range(0, len(flat), 3)),
           zip(*[iter(map(int, numbers(fields["indices"])))] * 3))


def add_plane(to, fields):
    """Nine rectangles, of which the middle one is small, for the sake of float."""
    side, other = around(unit(fields["normal"]))
    middle, half = (FAR + NEAR) / 2, (FAR - NEAR) / 2
    parts = [(-middle, half), (0, NEAR), (middle, half)]
    for i, own_half in parts:
        for j, other_half in parts:
            center = add(fields["point"], add(scaled(side, i), scaled(other, j)))
            to.add_square(center, scaled(side, own_half), scaled(other, other_half))


def add_box(to, fields):
    low, high = fields["min"], fields["max"]
    center, half = scaled(add(low, high), 0.5), scaled(subtract(high, low), 0.5)
    axes = [tuple(half[i] * (i == axis) for i in range(3)) for axis in range(3)]
    for axis in range(3):
        for way in (-1, 1):
            to.add_square(add(center, scaled(axes[axis], way)), axes[axis - 1], axes[axis - 2])


def add_sphere(to, fields):
    """Meridians and parallels; the poles' own triangles are degenerate and left out."""
    rows = ROUND // 2
    angles = [(math.pi * i / rows, 2 * math.pi * j / ROUND)
              for i in range(rows + 1) for j in range(ROUND)]
    ways = [(math.sin(a) * math.cos(b), math.cos(a), math.sin(a) * math.sin(b)) for a, b in angles]
    to.add([add(fields["center"], scaled(way, fields["radius"])) for way in ways],
           list(sphere_faces(rows)), True)


def sphere_faces(rows):
    for i in range(rows):
        for j in range(ROUND):
            a, b = i * ROUND + j, i * ROUND + (j + 1) % ROUND
            if i < rows - 1:
                yield (a, b + ROUND, a + ROUND)
            if i > 0:
                yield (a, b, b + ROUND)


def icosphere():
    """Unit vectors and 80 triangles: an icosahedron whose edges are halved once."""
    g = (1 + math.sqrt(5)) / 2
    ways = [unit(v) for a in (-1, 1) for b in (-g, g) for v in ((0, a, b), (a, b, 0), (b, 0, a))]
    edge = min(length(subtract(ways[0], way)) for way in ways[1:])
    near = [[length(subtract(p, q)) < 1.1 * edge for q in ways] for p in ways]
    middle, triangles = {}, []
    def half(i, j):
        key = (min(i, j), max(i, j))
        if key not in middle:
            middle[key] = len(ways)
            ways.append(unit(add(ways[i], ways[j])))
        return middle[key]
    corners = range(12)
    for i, j, k in [(i, j, k) for i in corners for j in range(i) for k in range(j)
                    if near[i][j] and near[j][k] and near[i][k]]:
        a, b, c = half(i, j), half(j, k), half(k, i)
        triangles += [(i, a, c), (j, b, a), (k, c, b), (a, b, c)]
    return ways, triangles


def add_luminous_sphere(to, fields):
    """A ball of few triangles, for each is a light, and of the sphere's area."""
    ways, triangles = icosphere()
    area = sum(length(cross(subtract(ways[j], ways[i]), subtract(ways[k], ways[i]))) / 2
               for i, j, k in triangles)
    radius = fields["radius"] * math.sqrt(4 * math.pi / area)
    to.add([add(fields["center"], scaled(way, radius)) for way in ways], triangles)


def add_cylinder(to, fields):
    base, cap, radius = fields["base"], fields["cap"], fields["radius"]
    side, other = around(unit(subtract(cap, base)))
    ring = [scaled(add(scaled(side, math.cos(t)), scaled(other, math.sin(t))), radius)
            for t in (2 * math.pi * i / ROUND for i in range(ROUND))]
    rings = [add(end, out) for end in (base, cap) for out in ring]
    nexts = [(i, (i + 1) % ROUND) for i in range(ROUND)]
    to.add(rings, [t for i, j in nexts for t in ((i, j, ROUND + j), (i, ROUND + j, ROUND + i))],
           True)
    for end in (0, 1):  # corners of their own, for they have other normals
        to.add([(base, cap)[end], *rings[end * ROUND:(end + 1) * ROUND]],
               [(0, 1 + i, 1 + j) for i, j in nexts])


WAYS = {"plane": add_plane, "box": add_box, "sphere": add_sphere, "cylinder": add_cylinder,
        "luminous sphere": add_luminous_sphere}


def add_shape(to, kind, fields):
    """Appends a shape in world space. Errors: CannotExpress."""
    if kind not in WAYS:
        raise CannotExpress(kind)
    WAYS[kind](to, fields)
