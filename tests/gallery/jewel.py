#!/usr/bin/env python3
"""Prints web/scenes/jewel.json: a round brilliant of diamond, which lies on one of its facets.

The stone is what the half spaces of its 73 facets have in common: M. Tolkowsky, "Diamond Design"
(1919), with the angles of today's cut. Its girdle, in the plane y = 0, has radius 1.
"""

from itertools import combinations
from math import atan2, cos, pi, radians, sin, tan

GIRDLE, TABLE, CROWN, PAVILION = 0.02, 0.56, radians(34.5), radians(40.75)


def facet(azimuth, tilt, radius, height):
    """The plane through a point of that azimuth, as (n, n.p): tilted so far from the horizontal."""
    n = (sin(tilt) * cos(azimuth), cos(tilt), sin(tilt) * sin(azimuth))
    return n, sin(tilt) * radius + cos(tilt) * height


def facets():
    top = GIRDLE + (1 - TABLE) * tan(CROWN)
    between = cos(pi / 16)  # of a polygon of 16 sides: the middle of one
    yield (0, 1, 0), top
    for k in range(8):
        main = k * pi / 4
        yield facet(main, CROWN, 1, GIRDLE)
        yield facet(main + pi / 8, radians(21), TABLE * cos(pi / 8), top)
        yield facet(main, pi - PAVILION, 1, -GIRDLE)
    for k in range(16):
        half = (k + 0.5) * pi / 8
        yield facet(half, radians(40), between, GIRDLE)
        yield facet(half, pi / 2, between, 0)
        yield facet(half, pi - radians(42), between, -GIRDLE)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def meeting(a, b, c):
    """The point of three planes; none where they have no single one."""
    det = dot(a[0], cross(b[0], c[0]))
    if abs(det) < 1e-9:
        return None
    parts = [cross(b[0], c[0]), cross(c[0], a[0]), cross(a[0], b[0])]
    return tuple(sum(d * part[i] for d, part in zip((a[1], b[1], c[1]), parts)) / det for i in range(3))


def polyhedron(planes):
    """The vertices, and of each plane those on it, counter-clockwise from outside."""
    vertices = []
    for three in combinations(planes, 3):
        p = meeting(*three)
        if p is None or any(dot(n, p) > d + 1e-7 for n, d in planes):
            continue
        if all(max(abs(x - y) for x, y in zip(p, q)) > 1e-6 for q in vertices):
            vertices.append(p)
    faces = []
    for n, d in planes:
        own = [i for i, p in enumerate(vertices) if abs(dot(n, p) - d) < 1e-6]
        middle = [sum(vertices[i][k] for i in own) / len(own) for k in range(3)]
        across = [x - m for x, m in zip(vertices[own[0]], middle)]
        along = cross(n, across)

        def angle(i):
            out = [x - m for x, m in zip(vertices[i], middle)]
            return atan2(dot(out, along) / dot(along, along), dot(out, across) / dot(across, across))

        faces.append(sorted(own, key=angle))
    return vertices, faces


def number(x):
    return f"{round(x, 6) + 0.0:.6f}".rstrip("0").rstrip(".")


vertices, faces = polyhedron(list(facets()))
positions = ", ".join(number(x) for p in vertices for x in p)
indices = ", ".join(f"{f[0]}, {f[i]}, {f[i + 1]}" for f in faces for i in range(1, len(f) - 1))
lying = number(cos(PAVILION) * GIRDLE + sin(PAVILION))
print(f"""{{
  "title": "A diamond",
  "description": "It bends blue more than red, and what leaves it after many mirrorings has parted into colours: its fire. A path that enters it is of one wavelength from there on.",
  "camera": {{"location": [0, 2.7, 5.2], "look_at": [0, 0.62, 0.1], "fov_degrees": 27}},
  "objects": [
    {{"name": "floor", "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": {{"color": [0.6, 0.6, 0.62]}}}},
    {{"name": "diamond", "type": "mesh", "material": {{"type": "principled", "transmission": 1, "roughness": 0, "ior": 2.417, "dispersion": 0.36}},
     "transform": [{{"rotate_degrees": [0, 22.5, 0]}}, {{"rotate_degrees": [{number(PAVILION * 180 / pi)}, 0, 0]}}, {{"translate": [0, {lying}, 0]}}],
     "positions": [{positions}],
     "indices": [{indices}]}}
  ],
  "background": [0.3, 0.32, 0.36],
  "lights": [
    {{"type": "quad", "corner": [-4, 3.5, -4], "u": [2.4, 0, 0], "v": [0, 1.6, 1.4], "intensity": 9}},
    {{"type": "quad", "corner": [1.8, 4, -3], "u": [1.4, 0, 0.8], "v": [0, 1.2, 1], "intensity": 14}},
    {{"type": "quad", "corner": [-0.8, 6, 2], "u": [1.6, 0, 0], "v": [0, 0, 1.4], "intensity": 12}},
    {{"type": "quad", "corner": [-5, 1.6, 2.4], "u": [0.8, 0, 1.6], "v": [0, 1.8, 0], "intensity": 8}}
  ],
  "options": {{"integrator": "path", "samples": 192, "max_depth": 24, "exposure": -0.3, "transfer": "aces"}}
}}""")
