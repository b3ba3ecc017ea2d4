"""Flattens a Tia scene into primitives in world space that other ray tracers have words for."""

import base64
import math
import struct
from dataclasses import dataclass

DEFAULT_MATERIAL = {
    "color": [1, 1, 1], "ambient": 0, "diffuse": 1, "brilliance": 1, "specular": 0,
    "roughness": 0.05, "reflection": 0, "transmission": 0, "ior": 1.5,
}
IDENTITY = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0))


class CannotExpress(Exception):
    """A scene has something that a program has no words for."""


@dataclass
class Primitive:
    """One surface: its kind, its fields in world space, its whole material."""
    kind: str
    fields: dict
    material: dict


def rgb(value):
    """A colour; a number means grey."""
    return tuple(value) if isinstance(value, (list, tuple)) else (value,) * 3


# ---- vectors and transforms: a transform is three rows of four ------------------------------------

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


def unit(a):
    return scaled(a, 1 / math.sqrt(dot(a, a)))


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
            one = [[x * k for x in row] for row, k in zip(IDENTITY, rgb(value))]
        else:
            one = value[:3]
        m = after(one, m)
    return m


def similarity_scale(m):
    """How much longer lengths become; refuses what would bend a ball."""
    columns = list(zip(*m))[:3]
    lengths = [math.sqrt(dot(c, c)) for c in columns]
    skew = max(abs(dot(columns[i], columns[j])) for i, j in ((0, 1), (0, 2), (1, 2)))
    if max(lengths) - min(lengths) > 1e-9 * max(lengths) or skew > 1e-9 * max(lengths) ** 2:
        raise CannotExpress("a transform that is no similarity")
    return lengths[0]


# ---- objects --------------------------------------------------------------------------------------

def numbers(array):
    """A flat array of numbers, or base64 of a little-endian typed one."""
    if not isinstance(array, dict):
        return array
    (kind, text), = array.items()
    data = base64.b64decode(text)
    return struct.unpack(f"<{len(data) // 4}{'f' if kind == 'float32' else 'I'}", data)


def triples(array):
    flat = numbers(array)
    return [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]


def box_by(m, fields):
    """A box that stays along the axes."""
    corners = [point_by(m, fields[name]) for name in ("min", "max")]
    if any(sum(abs(x) > 1e-12 for x in row[:3]) != 1 for row in m):
        raise CannotExpress("a turned box")
    return {"min": tuple(map(min, *corners)), "max": tuple(map(max, *corners))}


def mesh_by(m, fields):
    similarity_scale(m)  # else normals would need another transform
    return {"positions": [point_by(m, p) for p in triples(fields["positions"])],
            "normals": [unit(vector_by(m, n)) for n in triples(fields.get("normals", []))],
            "indices": [tuple(map(int, t)) for t in triples(fields["indices"])]}


def moved(kind, fields, m):
    """The fields of an object in world space."""
    if kind == "box":
        return box_by(m, fields)
    if kind == "mesh":
        return mesh_by(m, fields)
    ways = {"center": point_by, "point": point_by, "base": point_by, "cap": point_by,
            "a": point_by, "b": point_by, "c": point_by, "normal": vector_by,
            "radius": lambda transform, r: r * similarity_scale(transform)}
    known = {"sphere": ("center", "radius"), "plane": ("point", "normal"),
             "disc": ("center", "normal", "radius"), "cylinder": ("base", "cap", "radius"),
             "triangle": ("a", "b", "c")}
    if kind not in known:
        raise CannotExpress(kind)
    if "normal" in fields:
        similarity_scale(m)
    return {name: ways[name](m, fields[name]) for name in known[kind]}


def copies(group):
    """The places of a group's copies."""
    repeat = group.get("repeat", {"count": [1, 1, 1], "step": [0, 0, 0]})
    nx, ny, nz = repeat["count"]
    for k in range(nz):
        for j in range(ny):
            for i in range(nx):
                yield transform_of([{"translate": [n * s for n, s in
                                                   zip((i, j, k), repeat["step"])]}])


def flatten(objects, materials, material=None, m=IDENTITY):
    """Yields every primitive of a list of objects; a repeated group yields all of its copies."""
    for item in objects:
        own = item.get("material", material)
        here = after(m, transform_of(item.get("transform", [])))
        if item["type"] == "group":
            for place in copies(item):
                yield from flatten(item["children"], materials, own, after(here, place))
        else:
            whole = materials.get(own, {}) if isinstance(own, str) else own or {}
            strange = set(whole) - set(DEFAULT_MATERIAL) - {"type"}
            if strange:
                raise CannotExpress(", ".join(sorted(strange)))
            yield Primitive(item["type"], moved(item["type"], item, here),
                            {**DEFAULT_MATERIAL, **whole})


def primitives(scene):
    """All of a scene's surfaces."""
    return list(flatten(scene["objects"], scene.get("materials", {})))


# ---- the rest of a scene --------------------------------------------------------------------------

@dataclass
class Lamp:
    """A light that shines from one point; a luminous ball where it has a radius."""
    position: tuple
    color: tuple
    radius: float


def lamps(scene):
    """All of a scene's lights."""
    found = []
    for light in scene.get("lights", []):
        if light["type"] not in ("point", "sphere") or set(light) & {"fade_distance", "samples"}:
            raise CannotExpress(f"a light like {light}")
        color = scaled(rgb(light.get("color", 1)), light.get("intensity", 1))
        found.append(Lamp(tuple(light["position"]), color, light.get("radius", 0)))
    return found


@dataclass
class Eye:
    """A camera: unit vectors that make a right-handed basis, and half the picture's height at
    distance 1."""
    location: tuple
    direction: tuple
    right: tuple
    up: tuple
    half_height: float


def eye(scene):
    """The eye of a scene whose camera has location, look_at, up and fov_degrees."""
    camera = scene.get("camera", {})
    strange = set(camera) - {"location", "look_at", "up", "fov_degrees"}
    if strange:
        raise CannotExpress(f"camera: {', '.join(sorted(strange))}")
    location = tuple(camera.get("location", (0, 0, 0)))
    look_at = camera.get("look_at", (location[0], location[1], location[2] - 1))
    direction = unit(subtract(look_at, location))
    right = unit(cross(direction, camera.get("up", (0, 1, 0))))
    half = math.tan(math.radians(camera.get("fov_degrees", 25)) / 2)
    return Eye(location, direction, right, cross(right, direction), half)
