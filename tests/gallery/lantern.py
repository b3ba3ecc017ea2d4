#!/usr/bin/env python3
"""Writes web/models/lantern.glb: a storm lantern that burns on a stump at night, and a moth.

Its globe is glass with an inside (KHR_materials_transmission, volume, ior), its flame shines
(emissive_strength), and the moth's wings are half seen through (alphaMode BLEND). The file has an
eye and lights of its own: the moon, and a window behind the eye. Lengths are metres.
"""

import sys
from math import cos, pi, radians, sin, sqrt

from glb import Glb, srgb
from solids import Surface, add, arc, ball, cross, drawn, edges, spline, turned, unit


def tank():
    """The fuel's tank and the burner on it, up to the globe."""
    body = turned([(0, 0), (0.052, 0)], arc((0.052, 0.006), 0.006, -pi / 2, pi / 2, 5),
                  arc((0.05, 0.022), 0.01, -pi / 2, pi / 2, 6),
                  spline([(0.05, 0.032), (0.046, 0.041), (0.03, 0.047), (0.022, 0.049)], 3),
                  arc((0.022, 0.052), 0.003, -pi / 2, pi / 2, 4),
                  spline([(0.022, 0.055), (0.019, 0.058), (0.021, 0.064)], 3),
                  *edges((0.021, 0.064), (0.036, 0.066), (0.036, 0.07), (0.014, 0.07)),
                  spline([(0.014, 0.07), (0.012, 0.077), (0.006, 0.081)], 3),
                  [(0.006, 0.081), (0, 0.081)], around=28)
    cap = turned([(0.008, 0), (0.008, 0.007)], [(0.008, 0.007), (0.0065, 0.008)],
                 [(0.0065, 0.008), (0, 0.008)], around=16)
    return body + cap.moved((0.036, 0.041, 0))


def hood():
    """What the globe's smoke goes out through."""
    return turned(*edges((0, 0.166), (0.03, 0.166), (0.031, 0.171), (0.024, 0.173)),
                  spline([(0.024, 0.173), (0.023, 0.183), (0.018, 0.193)], 3),
                  *edges((0.018, 0.193), (0.018, 0.2), (0.034, 0.2025)),
                  spline([(0.034, 0.2025), (0.026, 0.211), (0.014, 0.217), (0.006, 0.222)], 3),
                  arc((0, 0.2245), 0.0065, -0.4, pi / 2 - 0.001, 6)[:-1] + [(0, 0.231)], around=28)


def tube(points, radius, around=8, steps=4, lids=True):
    curve = spline(points, steps)
    return drawn(curve, [radius] * len(curve), around, lids=lids)


def frame():
    """The pipes on both sides, which carry the hood, and the handle that swings from them."""
    made = Surface()
    for s in (-1, 1):
        made += tube([(s * 0.04, 0.036, 0), (s * 0.06, 0.043, 0), (s * 0.066, 0.07, 0),
                      (s * 0.066, 0.11, 0), (s * 0.066, 0.15, 0), (s * 0.058, 0.176, 0),
                      (s * 0.03, 0.187, 0), (s * 0.014, 0.187, 0)], 0.0048)
        made += ball((s * 0.071, 0.148, 0), 0.0042, 6, 10)
    return made


def handle():
    angles = [pi * k / 16 for k in range(17)]
    lean = radians(38)
    arch = [(0.073 * cos(a), 0.148 + 0.125 * sin(a) * cos(lean), -0.125 * sin(a) * sin(lean))
            for a in angles]
    return tube(arch, 0.0016, 6, 1)


def guard():
    """Two wires around the globe, held where they meet the pipes."""
    made = Surface()
    for y in (0.103, 0.133):
        ring = [(0.0535 * cos(a), y, 0.0535 * sin(a))
                for a in (2 * pi * k / 36 for k in range(37))]
        made += drawn(ring, [0.0011] * len(ring), 5, lids=False)
        for s in (-1, 1):
            made += drawn([(s * 0.053, y, 0), (s * 0.064, y, 0)], [0.0013] * 2, 6)
    return made


def globe():
    """Glass 1.8 mm thick: its outside, and its inside the other way round."""
    side = [(0.031, 0.0705), (0.0375, 0.08), (0.0475, 0.1), (0.05, 0.118), (0.046, 0.138),
            (0.036, 0.155), (0.0275, 0.1655)]
    outer = spline(side, 3)
    inner = [(r - 0.0018, y) for r, y in reversed(outer)]
    return turned(outer, [outer[-1], inner[0]], inner, [inner[-1], outer[0]], around=32)


def flame():
    """A teardrop."""
    low, high, shares = 0.084, 0.126, [k / 14 for k in range(15)]
    return turned([(0.025 * t ** 0.7 * (1 - t) ** 1.2, low + (high - low) * t) for t in shares],
                  around=16)


# ---- the moth -----------------------------------------------------------------------------------


def wing(outline, side, lift):
    """A flat wing, which is lifted about the body's axis."""
    flat = [(side * x * cos(lift), x * sin(lift), z) for x, z in spline(outline, 4)]
    n = (-side * sin(lift), cos(lift), 0)
    fan = [(0, k, k + 1) for k in range(1, len(flat) - 1)]
    return Surface(flat, [n] * len(flat), fan if side < 0 else [(a, c, b) for a, b, c in fan])


def wings():
    fore = [(0.0015, -0.003), (0.012, -0.0125), (0.0215, -0.014), (0.0235, -0.01),
            (0.019, -0.002), (0.0105, 0.0025), (0.0015, 0.001)]
    hind = [(0.0015, 0.0), (0.0095, 0.001), (0.0145, 0.0065), (0.0125, 0.0125), (0.006, 0.013),
            (0.0015, 0.006)]
    made = Surface()
    for side in (-1, 1):
        made += wing(fore, side, radians(24)) + wing(hind, side, radians(16))
    return made


def moth():
    body = spline([(0, 0.0002, -0.0085), (0, 0.0006, -0.006), (0, 0.0004, -0.002),
                   (0, 0, 0.004), (0, -0.0008, 0.012)], 3)
    widths = [w for w, in spline([(0.0004,), (0.0019,), (0.0026,), (0.0019,), (0.0003,)], 3)]
    made = drawn(body, widths, 12)
    for side in (-1, 1):
        made += tube([(side * 0.0008, 0.0012, -0.0078), (side * 0.003, 0.003, -0.0125),
                      (side * 0.0065, 0.0038, -0.0155)], 0.00022, 5, 3)
        made += ball((side * 0.0011, 0.001, -0.0078), 0.0008, 6, 8)
    return made


# ---- the stump ----------------------------------------------------------------------------------


def stump():
    """Bark with ridges; its top is a separate surface."""
    around, rows = 56, (-0.16, -0.085, -0.012, -0.003)

    def radius(j, y):
        a = 2 * pi * j / around
        ridges = 0.006 * abs(sin(7 * a + 2 * sin(3 * a))) + 0.003 * sin(17 * a + 30 * y)
        return 0.155 + 0.008 * sin(3 * a + 1) + (ridges if y < -0.004 else 0.003) - 0.1 * y * y

    def at(j, y):
        a = 2 * pi * j / around
        return radius(j, y) * cos(a), y, -radius(j, y) * sin(a)
    rings = [[at(j, y) for j in range(around)] for y in rows]
    rim = [(0.965 * x, 0.0, 0.965 * z) for x, _, z in rings[-1]]
    bark = Surface()
    for low, high in zip([*rings], [*rings[1:], rim]):
        for j in range(around):
            k = (j + 1) % around
            bark += flat_quad(low[j], low[k], high[k], high[j])
    fan = [(0, 1 + j, 1 + (j + 1) % around) for j in range(around)]
    return bark, Surface([(0, 0, 0), *rim], [(0, 1, 0)] * (around + 1), fan)


def flat_quad(a, b, c, d):
    n = unit(cross(add(c, a, -1), add(d, b, -1)))
    return Surface([a, b, c, d], [n] * 4, [(0, 1, 2), (0, 2, 3)])


# ---- all of it ----------------------------------------------------------------------------------


def materials(glb):
    glass = {"KHR_materials_transmission": {"transmissionFactor": 1.0},
             "KHR_materials_ior": {"ior": 1.5},
             "KHR_materials_volume": {"thicknessFactor": 0.0018, "attenuationDistance": 0.012,
                                      "attenuationColor": [0.82, 0.93, 0.86]}}
    shining = {"KHR_materials_emissive_strength": {"emissiveStrength": 12.0}}
    return {
        "paint": glb.material("paint", srgb(148, 34, 26), 0.0, 0.35,
                              {"KHR_materials_clearcoat": {"clearcoatFactor": 0.7,
                                                           "clearcoatRoughnessFactor": 0.1}}),
        "steel": glb.material("steel", srgb(196, 192, 186), 1.0, 0.28),
        "brass": glb.material("brass", srgb(232, 190, 108), 1.0, 0.2),
        "glass": glb.material("glass", [1, 1, 1], 0.0, 0.0, glass),
        "flame": glb.material("flame", [0, 0, 0], 0.0, 1.0, shining,
                              emissiveFactor=[1.0, 0.52, 0.16]),
        "wings": glb.material("wings", [*srgb(224, 206, 170), 0.6], 0.0, 0.8, alphaMode="BLEND",
                              doubleSided=True),
        "fur": glb.material("fur", srgb(128, 100, 70), 0.0, 0.9),
        "bark": glb.material("bark", srgb(86, 66, 50), 0.0, 0.95),
        "wood": glb.material("wood", srgb(176, 136, 92), 0.0, 0.7)}


def things(glb):
    """Nodes, each with its material."""
    of = materials(glb)
    bark, top = stump()
    turn = [0.0, sin(radians(12)), 0.0, cos(radians(12))]
    parts = [("tank", tank(), "paint"), ("hood", hood(), "paint"), ("frame", frame(), "paint"),
             ("handle", handle(), "steel"), ("guard", guard(), "steel"),
             ("wick", turned([(0.0035, 0.08), (0.0035, 0.0855)], [(0.0035, 0.0855), (0, 0.0855)],
                             around=12), "brass"),
             ("globe", globe(), "glass"), ("flame", flame(), "flame")]
    children = []
    for name, surface, material in parts:
        primitive = glb.primitive(surface, of[material], material != "glass")
        children.append(glb.node(name, mesh=glb.mesh(name, primitive)))
    lantern = glb.node("lantern", rotation=[round(c, 6) for c in turn], children=children)
    insect = glb.mesh("moth", glb.primitive(moth(), of["fur"], True),
                      glb.primitive(wings(), of["wings"]))
    flying = glb.node("moth", mesh=insect, translation=[0.072, 0.1, 0.066],
                      rotation=quaternion((0.3, 0.75, -0.25), 1.5))
    log = glb.mesh("stump", glb.primitive(bark, of["bark"], True), glb.primitive(top, of["wood"]))
    return [lantern, flying, glb.node("stump", mesh=log)]


def quaternion(axis, angle):
    length = sqrt(sum(x * x for x in axis))
    return [round(x / length * sin(angle / 2), 6) for x in axis] + [round(cos(angle / 2), 6)]


def looking(glb, name, place, down, left, **more):
    """A node there whose -z looks so far down and to the left, in degrees."""
    (x, w), (y, v) = ((sin(a / 2), cos(a / 2)) for a in (-radians(down), radians(left)))
    turn = [round(c, 6) for c in (v * x, y * w, -y * x, v * w)]
    return glb.node(name, translation=list(place), rotation=turn, **more)


def views(glb):
    """The eye, the moon, and the window behind the eye."""
    lens = {"yfov": 0.5, "znear": 0.01}
    eye = glb.add("cameras", {"name": "night", "type": "perspective", "perspective": lens})
    moon = glb.light(name="moon", type="directional", color=srgb(150, 180, 255), intensity=0.9)
    window = glb.light(name="window", type="spot", color=srgb(255, 200, 140), intensity=0.55,
                       spot={"innerConeAngle": 0.16, "outerConeAngle": 0.5})
    return [looking(glb, "eye", (0.22, 0.21, 0.56), 13, 21, camera=eye),
            looking(glb, "moon", (-1, 1, -0.4), 48, -125, extensions=moon),
            looking(glb, "window", (0.5, 0.4, 0.65), 24, 38, extensions=window)]


def main():
    glb = Glb("A storm lantern")
    sys.stdout.buffer.write(glb.file(*things(glb), *views(glb)))


if __name__ == "__main__":
    main()
