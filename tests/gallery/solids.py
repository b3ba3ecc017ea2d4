"""Surfaces of triangles with normals: turned on a lathe, drawn along a curve, boxes, balls.

A surface is counter-clockwise from outside, +y is up, and angles are radians.
"""

from math import cos, pi, sin


def add(a, b, s=1.0):
    return tuple(x + s * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = dot(a, a) ** 0.5
    return tuple(x / length for x in a)


class Surface:
    """Points, their unit normals, and triangles as numbers of points."""

    def __init__(self, points=(), normals=(), triangles=()):
        self.points, self.normals = list(points), list(normals)
        self.triangles = list(triangles)

    def __add__(self, other):
        base = len(self.points)
        return Surface(self.points + other.points, self.normals + other.normals,
                       self.triangles + [tuple(base + i for i in t) for t in other.triangles])

    def moved(self, by=(0, 0, 0), turn=0.0, scale=1.0):
        """Scaled, turned about +y, then moved."""
        c, s = cos(turn), sin(turn)

        def turned(p):
            return c * p[0] + s * p[2], p[1], c * p[2] - s * p[0]
        return Surface([add(by, turned(p), scale) for p in self.points],
                       [turned(n) for n in self.normals], self.triangles)


def grid(rows, columns, point, normal, closed=False):
    """A sheet of rows x columns points; where it is closed the last column meets the first."""
    at = [(i, j) for i in range(rows) for j in range(columns)]
    triangles = []
    for i in range(rows - 1):
        for j in range(columns if closed else columns - 1):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            triangles += [(a, a + columns, b), (b, a + columns, b + columns)]
    return Surface([point(i, j) for i, j in at], [normal(i, j) for i, j in at], triangles)


def without_slivers(surface):
    """Without triangles two of whose corners are one point."""
    p = surface.points
    surface.triangles = [t for t in surface.triangles if len({p[i] for i in t}) == 3]
    return surface


# ---- the lathe ----------------------------------------------------------------------------------


def spline(points, steps):
    """A Catmull-Rom curve through the points, so many steps between two of them."""
    ends = [points[0], *points, points[-1]]
    curve = []
    for k in range(1, len(ends) - 2):
        p0, p1, p2, p3 = ends[k - 1:k + 3]
        for step in range(steps):
            t = step / steps
            curve.append(tuple(
                0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                       (3 * b - a - 3 * c + d) * t ** 3) for a, b, c, d in zip(p0, p1, p2, p3)))
    return curve + [tuple(points[-1])]


def arc(center, radius, begin, end, steps):
    """Of a profile: (radius, height) around a centre, angles from outward to upward."""
    return [(center[0] + radius * cos(begin + (end - begin) * k / steps),
             center[1] + radius * sin(begin + (end - begin) * k / steps))
            for k in range(steps + 1)]


def turned(*runs, around=36):
    """A profile of (radius, height) about +y, upward with its outside to the right: it is smooth
    within each run and has an edge between two."""
    all_runs = Surface()
    for run in runs:
        all_runs += without_slivers(turned_run(run, around))
    return all_runs


def turned_run(run, around):
    slopes = []
    for k, here in enumerate(run):
        before, after = run[max(k - 1, 0)], run[min(k + 1, len(run) - 1)]
        out = unit((after[1] - before[1], before[0] - after[0]))
        slopes.append((0.0, 1.0 if out[1] > 0 else -1.0) if here[0] == 0 else out)

    def placed(r, y, j):
        angle = 2 * pi * j / around
        return r * cos(angle) + 0.0, y, -r * sin(angle) + 0.0
    return flipped(grid(len(run), around, lambda i, j: placed(*run[i], j),
                              lambda i, j: placed(*slopes[i], j), closed=True))


def flipped(surface):
    surface.triangles = [(a, c, b) for a, b, c in surface.triangles]
    return surface


def edges(*points):
    """Straight runs from point to point."""
    return [[a, b] for a, b in zip(points, points[1:])]


def ball(center, radius, rows=8, around=12):
    run = [(0.0, -1.0), *arc((0, 0), 1, -pi / 2, pi / 2, rows)[1:-1], (0.0, 1.0)]
    return turned(run, around=around).moved(center, 0, radius)


# ---- along a curve ------------------------------------------------------------------------------


def carried(tangents):
    """Of each place along a curve two axes across it, carried on without turning about it."""
    first = tangents[0]
    u = unit(cross(first, (0, 0, 1) if abs(first[2]) < 0.9 else (1, 0, 0)))
    frames = []
    for t in tangents:
        u = unit(add(u, t, -dot(u, t)))
        frames.append((u, cross(t, u)))
    return frames


def tangents_of(curve, closed=False):
    n = len(curve)
    if closed:
        return [unit(add(curve[(k + 1) % n], curve[k - 1], -1)) for k in range(n)]
    return [unit(add(curve[min(k + 1, n - 1)], curve[max(k - 1, 0)], -1)) for k in range(n)]


def drawn(curve, radii, around=12, frames=None, lids=True):
    """A tube along a curve. Its cross-sections are ellipses of two radii, or circles of one."""
    tangents = tangents_of(curve)
    frames = frames or carried(tangents)
    radii = [r if isinstance(r, tuple) else (r, r) for r in radii]

    def across(i, j, a, b):
        angle, (u, v) = 2 * pi * j / around, frames[i]
        return add(tuple(a * cos(angle) * x for x in u), v, b * sin(angle))

    def point(i, j):
        return add(curve[i], across(i, j, *radii[i]))

    def normal(i, j):
        before, after = max(i - 1, 0), min(i + 1, len(curve) - 1)
        along = add(point(after, j), point(before, j), -1)
        a, b = radii[i]
        side = across(i, j, 1 / max(a, 1e-9), 1 / max(b, 1e-9))
        flat = add(side, along, -dot(side, along) / max(dot(along, along), 1e-12))
        return unit(flat) if dot(flat, flat) > 1e-9 else unit(side)
    tube = grid(len(curve), around, point, normal, closed=True)
    return without_slivers(flipped(tube)) + (lids_of(tube, len(curve), around, tangents)
                                                   if lids else Surface())


def lids_of(tube, rows, around, tangents):
    lids = Surface()
    for row, way in ((0, -1), (rows - 1, 1)):
        rim = tube.points[row * around:(row + 1) * around]
        middle = tuple(sum(c) / around for c in zip(*rim))
        n = tuple(way * x for x in tangents[row])
        fan = [(0, 1 + j, 1 + (j + 1) % around) for j in range(around)]
        lid = Surface([middle, *rim], [n] * (around + 1), fan)
        lids += without_slivers(lid if facing(lid) else flipped(lid))
    return lids


def facing(surface):
    """Whether its triangles are counter-clockwise from where its normals point."""
    a, b, c = (surface.points[i] for i in surface.triangles[0])
    return dot(cross(add(b, a, -1), add(c, a, -1)), surface.normals[0]) > 0


# ---- boxes --------------------------------------------------------------------------------------


def box(low, high, bevel=0.0):
    """A box whose edges are cut at 45 degrees, as wide as bevel on either side."""
    middle = tuple((a + b) / 2 for a, b in zip(low, high))
    half = tuple((b - a) / 2 for a, b in zip(low, high))
    made = Surface()
    signs = (-1, 0, 1)
    for n in [(x, y, z) for x in signs for y in signs for z in signs if (x, y, z) != (0, 0, 0)]:
        if bevel == 0 and n.count(0) < 2:
            continue
        corners = [add(middle, c) for c in box_face(n, half, bevel)]
        fan = [(0, k, k + 1) for k in range(1, len(corners) - 1)]
        face = Surface(corners, [unit(n)] * len(corners), fan)
        made += face if facing(face) else flipped(face)
    return made


def box_face(n, half, bevel):
    """The corners of a side, a bevelled edge or a corner, which n points to; around it."""
    inner = [h - bevel for h in half]
    free = [k for k in range(3) if n[k] == 0]
    fixed = [k for k in range(3) if n[k] != 0]
    if len(fixed) == 3:
        return [tuple(n[k] * (half[k] if k == out else inner[k]) for k in range(3))
                for out in range(3)]
    if len(fixed) == 2:
        ends = [(fixed[0], -1), (fixed[1], -1), (fixed[1], 1), (fixed[0], 1)]
        return [tuple(way * inner[k] if k == free[0] else n[k] * (half[k] if k == out else inner[k])
                      for k in range(3)) for out, way in ends]
    around = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    return [tuple(n[k] * half[k] if k == fixed[0] else ways[free.index(k)] * inner[k]
                  for k in range(3)) for ways in around]
