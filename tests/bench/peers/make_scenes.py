"""Scenes that are easier computed than written down: name -> Tia scene."""

import base64
import math
import random
import struct

from vectors import add, cross, scaled, subtract, unit

FLOOR = {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"}
FLOOR_MATERIAL = {"color": [0.45, 0.45, 0.5]}


def shiny_balls():
    """Seven times seven balls of all colours on a plane, with highlights of two coloured lights."""
    pick = random.Random(1)
    balls = [{"type": "sphere", "center": [1.25 * i, 0.5, 1.25 * j], "radius": 0.5,
              "material": {"color": [round(pick.uniform(0.1, 0.9), 3) for _ in range(3)],
                           "diffuse": 0.8, "specular": 0.6, "roughness": 0.02}}
             for j in range(-3, 4) for i in range(-3, 4)]
    return {
        "camera": {"location": [0, 6, 11], "look_at": [0, 0, 0.5], "fov_degrees": 35},
        "background": [0.2, 0.3, 0.5],
        "materials": {"floor": FLOOR_MATERIAL},
        "objects": [FLOOR, *balls],
        "lights": [{"type": "point", "position": [-8, 10, 6], "color": [0.7, 0.6, 0.4]},
                   {"type": "point", "position": [7, 6, 9], "color": [0.3, 0.4, 0.6]}],
    }


def around(way):
    """Two unit vectors square to a third."""
    side = unit(cross(way, (1, 0, 0) if abs(way[0]) < 0.6 else (0, 1, 0)))
    return side, cross(way, side)


def flake_balls(center, radius, way, depth):
    """A ball and the nine of a third of its size that sit on it; `way` points away from its own."""
    yield {"type": "sphere", "center": list(center), "radius": radius}
    if depth == 0:
        return
    side, other = around(way)
    for slant, count, turn in ((90, 6, 0), (35, 3, 30)):
        up, out = math.cos(math.radians(slant)), math.sin(math.radians(slant))
        for i in range(count):
            angle = math.radians(turn + 360 * i / count)
            flat = add(scaled(side, math.cos(angle)), scaled(other, math.sin(angle)))
            onward = add(scaled(way, up), scaled(flat, out))
            yield from flake_balls(add(center, scaled(onward, radius * 4 / 3)), radius / 3, onward,
                                   depth - 1)


def sphere_flake():
    """Haines' flake: 7381 balls of five sizes."""
    return {
        "camera": {"location": [3.4, 4.6, 5.6], "look_at": [0, 1.9, 0], "fov_degrees": 30},
        "background": [0.1, 0.15, 0.25],
        "materials": {"floor": FLOOR_MATERIAL,
                      "gold": {"color": [0.9, 0.65, 0.3], "diffuse": 0.8, "specular": 0.4,
                               "roughness": 0.04}},
        "objects": [FLOOR, {"type": "group", "material": "gold",
                            "children": list(flake_balls((0, 1.8, 0), 1, (0, 1, 0), 4))}],
        "lights": [{"type": "point", "position": [8, 12, 6], "color": [0.9, 0.9, 0.9]}],
    }


def knot_point(t, strand):
    """A point of a knotted tube (a 2,3 torus knot) and the normal there."""
    def middle(s):
        r = 2 + math.cos(3 * s)
        return (r * math.cos(2 * s), r * math.sin(2 * s), math.sin(3 * s))
    way = unit(subtract(middle(t + 1e-4), middle(t - 1e-4)))
    side = unit(cross(way, (0, 0, 1)))
    other = cross(way, side)
    normal = add(scaled(side, math.cos(strand)), scaled(other, math.sin(strand)))
    return add(middle(t), scaled(normal, 0.45)), normal


def packed(kind, values):
    """A typed array in base64."""
    code = {"float32": "f", "uint32": "I"}[kind]
    return {kind: base64.b64encode(struct.pack(f"<{len(values)}{code}", *values)).decode()}


def knot_mesh(along, round_, smooth):
    """The tube as a mesh of along * round_ * 2 triangles."""
    positions, normals, indices = [], [], []
    for i in range(along):
        for j in range(round_):
            p, n = knot_point(2 * math.pi * i / along, 2 * math.pi * j / round_)
            positions += p
            normals += n
            a, b = i * round_ + j, i * round_ + (j + 1) % round_
            c, d = ((x + round_) % (along * round_) for x in (a, b))
            indices += [a, b, c, b, d, c]
    mesh = {"type": "mesh", "material": "jade", "positions": packed("float32", positions),
            "indices": packed("uint32", indices), "transform": [{"translate": [0, 3.6, 0]}]}
    return {**mesh, "normals": packed("float32", normals)} if smooth else mesh


def knot(smooth, along=256, round_=20):
    """A knot on a plane: 10 240 triangles unless told otherwise."""
    return {
        "camera": {"location": [2, 6, 14], "look_at": [0, 3, 0], "fov_degrees": 32},
        "background": [0.6, 0.7, 0.8],
        "materials": {"floor": FLOOR_MATERIAL,
                      "jade": {"color": [0.3, 0.7, 0.5], "diffuse": 0.8, "specular": 0.4,
                               "roughness": 0.03}},
        "objects": [FLOOR, knot_mesh(along, round_, smooth)],
        "lights": [{"type": "point", "position": [-6, 14, 10]}],
    }


def strewn_balls(count):
    """Balls strewn over a cube, of which they fill a ninth however many they are."""
    pick = random.Random(2)
    balls = [{"type": "sphere", "center": [round(pick.uniform(-1, 1), 5) for _ in range(3)],
              "radius": round(0.6 / count ** (1 / 3), 6)} for _ in range(count)]
    return {
        "camera": {"location": [0, 0, 4], "look_at": [0, 0, 0], "fov_degrees": 38},
        "background": [0.2, 0.3, 0.5],
        "materials": {"chalk": {"color": [0.8, 0.75, 0.6], "diffuse": 0.9}},
        "objects": [{"type": "group", "material": "chalk", "children": balls}],
        "lights": [{"type": "point", "position": [3, 5, 6]}],
    }


def computed_scenes():
    """All of them by name."""
    return {"shiny-balls": shiny_balls(), "sphere-flake": sphere_flake(),
            "knot-flat": knot(False), "knot-smooth": knot(True),
            "knot-192000": knot(False, 1600, 60),
            **{f"balls-{count}": strewn_balls(count) for count in (1000, 10_000, 100_000)}}
