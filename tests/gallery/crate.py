#!/usr/bin/env python3
"""Writes web/models/crate.glb: a wooden crate with every texture that glTF's core has.

Two thirds of each picture are a panel of planks with a stencil that glows, the last third is a
board with nails: base colour, metal and roughness, normals, occlusion, and emission. The panel is
0.9 m wide. Tangents come with the file; u runs along them.
"""

import struct
import sys
import zlib
from math import sin

from glb import FLOAT, Glb
from solids import add, cross, unit

SIZE = 192  # texels across
PANEL = 144  # rows of the panel; those of the board are below
STENCIL = ("#####.###...#...", "..#....#...#.#..", "..#....#..#...#.", "..#....#..#####.",
           "..#....#..#...#.", "..#...###.#...#.")


# ---- pictures -----------------------------------------------------------------------------------


def png(rows, channels):
    """A PNG of rows of bytes: RFC 2083, each row as what it adds to the one above."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    above, lines = bytes(len(rows[0])), []
    for row in rows:
        lines.append(b"\2" + bytes((a - b) & 255 for a, b in zip(row, above)))
        above = row
    head = struct.pack(">IIBBBBB", len(rows[0]) // channels, len(rows), 8,
                       {1: 0, 3: 2}[channels], 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
            chunk(b"IDAT", zlib.compress(b"".join(lines), 9)) + chunk(b"IEND", b""))


def picture(glb, color_at, channels=3):
    """The number of a texture whose texels are what a function of column and row gives, 0 to 1."""
    rows = [bytes(min(255, max(0, int(255 * c + 0.5))) for x in range(SIZE)
                  for c in color_at(x, y)) for y in range(SIZE)]
    view = glb.view(png(rows, channels))
    image = glb.add("images", {"mimeType": "image/png", "bufferView": view})
    return {"index": glb.add("textures", {"sampler": 0, "source": image})}


def scatter(x, y):
    """A number from 0 to 1 for two whole numbers, without a pattern."""
    h = (x * 374761393 + y * 668265263) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((h ^ (h >> 16)) & 0xFFFF) / 65535


def smooth(x, y):
    """Value noise: what scatter gives at whole numbers, blended between them."""
    i, j = int(x // 1), int(y // 1)
    s, t = ((3 - 2 * f) * f * f for f in (x - i, y - j))
    low = scatter(i, j) * (1 - s) + scatter(i + 1, j) * s
    high = scatter(i, j + 1) * (1 - s) + scatter(i + 1, j + 1) * s
    return low * (1 - t) + high * t


# ---- what the wood is like at a texel -----------------------------------------------------------


def is_board(y):
    return y >= PANEL


def plank(x, y):
    """Which plank, and how far from its nearest edge, in texels."""
    if is_board(y):
        return 9, min(y - PANEL, SIZE - 1 - y) + 0.5
    wide = PANEL / 5
    k = int(y // wide)
    return k, min(y - k * wide, (k + 1) * wide - y)


def nail(x, y):
    """The way from the nearest nail's middle in its radii, and how far that is."""
    centers = ([(12, PANEL + 12), (12, SIZE - 13), (SIZE - 13, PANEL + 12),
                (SIZE - 13, SIZE - 13)] if is_board(y) else
               [(cx, PANEL / 5 * (k + 0.5)) for k in range(5) for cx in (22, SIZE - 23)])
    ways = [((x - a) / 3.6, (y - b) / 3.6) for a, b in centers]
    dx, dy = min(ways, key=lambda way: way[0] ** 2 + way[1] ** 2)
    return dx, dy, (dx * dx + dy * dy) ** 0.5


def grain(x, y):
    """From 0 to 1: rings that are drawn out along the planks."""
    k, _ = plank(x, y)
    bend = 5 * smooth(x / 40 + 13 * k, y / 9)
    ring = 0.5 + 0.5 * sin(0.9 * y + 6 * bend + 2 * k)
    return 0.6 * ring + 0.4 * smooth(x / 14, y * 1.1 + 50 * k)


def stencilled(x, y):
    """How far the stencil's paint covers the wood."""
    column, row = int((x - 48) // 6), int((y - 54) // 6)
    inside = 0 <= row < len(STENCIL) and 0 <= column < len(STENCIL[0])
    return 1.0 if inside and STENCIL[row][column] == "#" else 0.0


def height(x, y):
    """In texels: planks with round edges, grain, nails."""
    _, edge = plank(x, y)
    round_edge = -1.6 * max(0.0, 1 - edge / 3.5) ** 2
    dx, dy, far = nail(x, y)
    head = 1.3 * max(0.0, 1 - far * far) ** 0.5 if far < 1 else 0.0
    return round_edge + 0.35 * grain(x, y) * (far >= 1) + head


def wood_color(x, y):
    k, edge = plank(x, y)
    if nail(x, y)[2] < 1:
        return 0.62, 0.6, 0.57
    g = grain(x, y)
    shade = (0.86 + 0.14 * scatter(k, 5)) * (0.45 if edge < 1 else 1)
    light, dark = (0.80, 0.60, 0.38), (0.53, 0.35, 0.19)
    paint = 0.85 * stencilled(x, y)
    wood = [shade * (a * g + b * (1 - g)) for a, b in zip(light, dark)]
    return [c * (1 - paint) + p * paint for c, p in zip(wood, (0.05, 0.2, 0.2))]


def metal_and_roughness(x, y):
    if nail(x, y)[2] < 1:
        return 0.0, 0.3, 1.0
    return 0.0, 0.5 if stencilled(x, y) else 0.62 + 0.25 * grain(x, y), 0.0


def normal(x, y):
    """Of the height: red along +u, green along the picture's upward side."""
    n = unit((height(x - 1, y) - height(x + 1, y), height(x, y + 1) - height(x, y - 1), 2.0))
    return [0.5 + 0.5 * c for c in n]


def occlusion(x, y):
    _, edge = plank(x, y)
    far = nail(x, y)[2]
    near_nail = 0.3 * max(0.0, 1 - abs(far - 1.15) / 0.5)
    return (1 - 0.65 * max(0.0, 1 - edge / 4) - near_nail,) * 3


def glow(x, y):
    part = stencilled(x, y)
    return 0.1 * part, 0.95 * part, 0.8 * part


# ---- the crate ----------------------------------------------------------------------------------


class Faces:
    """Rectangles with uvs and tangents."""

    def __init__(self):
        self.points, self.normals, self.uvs, self.tangents, self.triangles = [], [], [], [], []

    def rectangle(self, corner, u, v, uv_box):
        """From the corner along u and v, which n = u x v goes out of; v is up in the picture."""
        base, (u0, v0, u1, v1) = len(self.points), uv_box
        n = unit(cross(u, v))
        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
            self.points.append(add(add(corner, u, a), v, b))
            self.normals.append(n)
            self.uvs.append((u0 + (u1 - u0) * a, v1 + (v0 - v1) * b))
            self.tangents.append((*unit(u), 1.0))
        self.triangles += [(base, base + 1, base + 2), (base, base + 2, base + 3)]

    def slab(self, corner, u, v, out, uv_box):
        """A rectangle that stands out by a vector, with its four sides."""
        low = add(corner, out)
        u0, v0, u1, v1 = uv_box
        edge = (u0, v1 - 0.03, u1, v1)
        self.rectangle(low, u, v, uv_box)
        for start, along in ((corner, u), (add(corner, u), v),
                             (add(add(corner, u), v), [-x for x in u]),
                             (add(corner, v), [-x for x in v])):
            self.rectangle(start, along, out, edge)


PANEL_BOX = (0.0, 0.0, 1.0, PANEL / SIZE)
BOARD_BOX = (0.0, PANEL / SIZE, 1.0, 1.0)


def times(x, vector):
    return tuple(x * c for c in vector)


HALF, DEEP, WIDE = 0.45, 0.045, 0.115  # of the panels; how far boards stand out; a board


def side(faces, u, v, reach, braced):
    """One of the six: a panel, a frame of boards that reach so far along u and v, a brace."""
    n, (far_u, far_v) = cross(u, v), reach
    out = times(DEEP, n)

    def at(a, b):
        return add(add(times(HALF, n), u, a), v, b)
    faces.rectangle(at(-HALF, -HALF), times(2 * HALF, u), times(2 * HALF, v), PANEL_BOX)
    for a in (-far_u, far_u - WIDE):
        faces.slab(at(a + WIDE, -far_v), times(2 * far_v, v), times(-WIDE, u), out, BOARD_BOX)
    inner = far_u - WIDE
    for b in (-far_v, far_v - WIDE):
        faces.slab(at(-inner, b), times(2 * inner, u), times(WIDE, v), out, BOARD_BOX)
    if braced:
        along, across = unit(add(u, v)), unit(add(times(-1, u), v))
        faces.slab(add(at(-inner, WIDE - far_v), across, -0.045), times(1.01, along),
                   times(0.09, across), times(0.6, out), BOARD_BOX)


def crate():
    """Front and back have the corners, then left and right; top and bottom lie between them."""
    faces, full = Faces(), HALF + DEEP
    x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
    back, left = (-1, 0, 0), (0, 0, -1)
    for u, v in ((x, y), (back, y)):
        side(faces, u, v, (full, full), False)
    for u, v in ((left, y), (z, y)):
        side(faces, u, v, (HALF, full), True)
    for u, v in ((x, left), (x, z)):
        side(faces, u, v, (HALF, HALF), False)
    return faces


def material(glb):
    glb.add("samplers", {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497})
    return glb.add("materials", {
        "name": "crate",
        "pbrMetallicRoughness": {"baseColorTexture": picture(glb, wood_color),
                                 "metallicRoughnessTexture": picture(glb, metal_and_roughness)},
        "normalTexture": picture(glb, normal),
        "occlusionTexture": picture(glb, occlusion),
        "emissiveTexture": picture(glb, glow), "emissiveFactor": [1, 1, 1]})


def main():
    glb, faces = Glb("A crate with every texture"), crate()
    primitive = glb.primitive(faces, material(glb), TEXCOORD_0=(faces.uvs, FLOAT),
                              TANGENT=(faces.tangents, FLOAT))
    node = glb.node("crate", mesh=glb.mesh("crate", primitive), translation=[0, 0.495, 0])
    sys.stdout.buffer.write(glb.file(node))


if __name__ == "__main__":
    main()
