#!/usr/bin/env python3
"""Prints web/scenes/trefoil.json: a mesh of a tube around a trefoil knot.

The curve is (sin t + 2 sin 2t, -sin 3t, cos t - 2 cos 2t), 0 <= t < 2 pi. The tube's circles stand
in a frame that is carried along the curve without turning about it; what is missing after one round
is made up for bit by bit, so that the texture closes.
"""

import base64
import struct
import zlib
from math import acos, cos, pi, sin

ALONG, AROUND, RADIUS, TWIST = 150, 16, 0.62, 3


def add(a, b, s=1.0):
    return tuple(x + s * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(x / dot(a, a) ** 0.5 for x in a)


def place(t):
    return sin(t) + 2 * sin(2 * t), -sin(3 * t), cos(t) - 2 * cos(2 * t)


def tangent(t):
    return unit((cos(t) + 4 * cos(2 * t), -3 * cos(3 * t), -sin(t) + 4 * sin(2 * t)))


def carried(normal, along):
    return unit(add(normal, along, -dot(normal, along)))


def frames():
    ts = [2 * pi * i / ALONG for i in range(ALONG + 1)]
    normals = [carried((0.0, 1.0, 0.0), tangent(0))]
    for t in ts[1:]:
        normals.append(carried(normals[-1], tangent(t)))
    first, last, way = normals[0], normals[-1], tangent(0)
    missing = acos(max(-1.0, min(1.0, dot(first, last))))
    if dot(cross(last, first), way) < 0:
        missing = -missing
    for i, t in enumerate(ts):
        n, b = normals[i], cross(tangent(t), normals[i])
        turn = missing * i / ALONG
        yield t, i / ALONG, add(tuple(cos(turn) * x for x in n), b, sin(turn))


def packed(kind, letter, values):
    data = struct.pack(f"<{len(values)}{letter}", *values)
    return f'{{ "{kind}": "{base64.b64encode(data).decode()}" }}'


def png(rows, palette):
    """A file with a palette, in base64. Stored, not deflated: every zlib writes the same bytes."""
    def chunk(name, data):
        return (struct.pack(">I", len(data)) + name + data +
                struct.pack(">I", zlib.crc32(name + data)))

    size = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 3, 0, 0, 0)
    pixels = b"".join(b"\0" + bytes(row) for row in rows)
    file = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size) +
            chunk(b"PLTE", b"".join(bytes(c) for c in palette)) +
            chunk(b"IDAT", zlib.compress(pixels, 0)) + chunk(b"IEND", b""))
    return base64.b64encode(file).decode()


STRIPES = png([[0], [0], [0], [1], [2], [2], [1]], [(214, 58, 40), (250, 240, 220), (30, 60, 120)])

positions, normals, uvs, indices = [], [], [], []
for t, u, n in frames():
    b = cross(tangent(t), n)
    for k in range(AROUND + 1):
        angle = 2 * pi * k / AROUND
        out = add(tuple(cos(angle) * x for x in n), b, sin(angle))
        positions += add(place(t), out, RADIUS)
        normals += out
        uvs += [u, k / AROUND + TWIST * u]
for i in range(ALONG):
    for k in range(AROUND):
        a = i * (AROUND + 1) + k
        c = a + AROUND + 1
        indices += [a, a + 1, c, c, a + 1, c + 1]

print(f"""{{
  "title": "A trefoil",
  "description": "A mesh of {len(indices) // 3} triangles: a tube around the trefoil knot (sin t + 2 sin 2t, -sin 3t, cos t - 2 cos 2t). The normals of its vertices make it look round, its uvs lay a picture of stripes along it. tests/gallery/trefoil.py wrote it.",
  "camera": {{ "location": [0, 8.4, 6.6], "look_at": [0, 0.1, -0.15], "fov_degrees": 39 }},
  "background": [0.35, 0.45, 0.6],
  "objects": [
    {{ "name": "floor", "type": "plane", "point": [0, -1.65, 0], "normal": [0, 1, 0], "material": {{ "color": [0.4, 0.5, 0.45], "ambient": 0.15 }} }},
    {{ "name": "trefoil", "type": "mesh",
      "material": {{ "ambient": 0.15, "diffuse": 0.85, "specular": 0.6, "roughness": 0.02, "texture": {{ "type": "image", "filter": "nearest", "repeat": [1, 2], "data": "{STRIPES}" }} }},
      "positions": {packed("float32", "f", positions)},
      "normals": {packed("float32", "f", normals)},
      "uvs": {packed("float32", "f", uvs)},
      "indices": {packed("uint32", "I", indices)} }}
  ],
  "lights": [
    {{ "type": "point", "position": [-7, 14, 7] }}
  ],
  "options": {{ "samples": 8, "threshold": 0.03 }}
}}""")
