"""Flattens a Tia scene into primitives in world space that other ray tracers have words for."""

import base64
import struct
from dataclasses import dataclass

from vectors import IDENTITY, after, dot, length, point_by, transform_of, unit, vector_by

DEFAULT_MATERIAL = {
    "color": [1, 1, 1], "ambient": 0, "diffuse": 1, "brilliance": 1, "specular": 0,
    "roughness": 0.05, "reflection": 0, "transmission": 0, "ior": 1.5,
}
FORMULAS = ("implicit", "explicit", "parametric", "algebraic", "quadric")


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


def numbers(array):
    """A flat array of numbers, or base64 of a little-endian typed one."""
    if not isinstance(array, dict):
        return array
    (kind, text), = array.items()
    data = base64.b64decode(text)
    return struct.unpack(f"<{len(data) // 4}{'f' if kind == 'float32' else 'I'}", data)


def triples(array):
    """A flat array as vectors."""
    flat = numbers(array)
    return [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]


def similarity_scale(m):
    """How many times longer lengths become. Errors: for what would bend a ball."""
    columns = list(zip(*m))[:3]
    lengths = [length(c) for c in columns]
    skew = max(abs(dot(columns[i], columns[j])) for i, j in ((0, 1), (0, 2), (1, 2)))
    if max(lengths) - min(lengths) > 1e-9 * max(lengths) or skew > 1e-9 * max(lengths) ** 2:
        raise CannotExpress("a transform that is no similarity")
    return lengths[0]


def box_by(m, fields):
    """A box that stays along the axes."""
    corners = [point_by(m, fields[name]) for name in ("min", "max")]
    if any(sum(abs(x) > 1e-12 for x in row[:3]) != 1 for row in m):
        raise CannotExpress("a turned box")
    return {"min": tuple(map(min, *corners)), "max": tuple(map(max, *corners))}


def mesh_by(m, fields):
    """A mesh: lists of tuples."""
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
    if kind in FORMULAS:  # which stay in object space
        return {**fields, "place": m}
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


def placed(objects, materials, material=None, m=IDENTITY):
    """Yields every object that is no group, the fields of its material, and its place; of a
    repeated group those of all copies."""
    for item in objects:
        own = item.get("material", material)
        here = after(m, transform_of(item.get("transform", [])))
        if item["type"] == "group":
            for place in copies(item):
                yield from placed(item["children"], materials, own, after(here, place))
        else:
            yield item, materials.get(own, {}) if isinstance(own, str) else own or {}, here


def flatten(objects, materials):
    """Yields every primitive of a list of objects; a repeated group yields all of its copies."""
    for item, whole, here in placed(objects, materials):
        strange = set(whole) - set(DEFAULT_MATERIAL) - {"type"}
        if strange:
            raise CannotExpress(", ".join(sorted(strange)))
        yield Primitive(item["type"], moved(item["type"], item, here),
                        {**DEFAULT_MATERIAL, **whole})


def primitives(scene):
    """All of a scene's surfaces."""
    found = list(flatten(scene["objects"], scene.get("materials", {})))
    glass = any(p.material["transmission"] > 0 for p in found)
    if glass and not scene.get("options", {}).get("transparent_shadows"):
        raise CannotExpress("glass that casts a full shadow")
    return found
