#!/usr/bin/env python3
"""Writes web/models/worm.glb: a caterpillar that walks.

Its body hangs on a chain of joints (a skin of two joints a vertex), breathes and stretches by morph
targets, and its one animation, two seconds long, moves both: a wave that runs along the joints, and
the targets' weights. As the file stands it shows the wave's beginning. Lengths are decimetres.
"""

import sys
from math import cos, pi, sin

from glb import BYTE, Glb, srgb
from solids import Surface, add, ball, drawn, unit

JOINTS, LENGTH, BULGES, AROUND = 9, 4.0, 9, 14
RINGS = BULGES * 6 + 1
SPACING = LENGTH / (JOINTS - 1)
SECONDS, STEPS = 2.0, 8


# ---- the body -----------------------------------------------------------------------------------


def thickness(s, swell=0.0):
    """Of the body at a share of its length: nine bulges, both ends round."""
    ends = (1 - (2 * s - 1) ** 6) ** 0.5
    bulge = 1 + (0.1 + swell) * abs(sin(pi * BULGES * s)) ** 0.7
    return 0.36 * ends * bulge * (0.8 + 0.2 * s)


def body(swell=0.0, stretch=0.0):
    """Along +z, the head's end at +z."""
    shares = [min(max(k / (RINGS - 1), 0.0004), 0.9996) for k in range(RINGS)]
    curve = [(0, 0.36, LENGTH * (s - 0.5)) for s in shares]
    radii = [thickness(s, swell + stretch * sin(2 * pi * s)) for s in shares]
    frames = [((1, 0, 0), (0, 1, 0))] * RINGS
    return drawn(curve, [(0.94 * r, r) for r in radii], AROUND, frames, lids=False)


def bones(points):
    """The two joints next to each point and their weights in 255ths, as four of each."""
    joints, weights = [], []
    for _, _, z in points:
        place = min(max((z / LENGTH + 0.5) * (JOINTS - 1), 0), JOINTS - 1.001)
        share = place % 1
        second = int(255 * share + 0.5)
        joints.append((int(place) if second < 255 else 0, int(place) + 1 if second else 0, 0, 0))
        weights.append((255 - second, second, 0, 0))
    return joints, weights


def striped(surface):
    """Its triangles in two lots: green, and yellow for the hollow between two bulges."""
    lots = ([], [])
    for t in surface.triangles:
        ring = min(t) // AROUND
        lots[ring % 6 in (0, 5)].append(t)
    return lots


def skinned_mesh(glb, materials):
    """Two primitives of the same points, with morph targets breathe and stretch."""
    rest, targets = body(), []
    for other in (body(swell=0.14), body(stretch=0.2)):
        shifts = [add(q, p, -1) for p, q in zip(rest.points, other.points)]
        turns = [add(m, n, -1) for n, m in zip(rest.normals, other.normals)]
        targets.append({"POSITION": glb.vertices(shifts, bounds=True),
                        "NORMAL": glb.vertices(turns)})
    joints, weights = bones(rest.points)
    whole = glb.primitive(rest, materials[0], JOINTS_0=(joints, BYTE))
    whole["attributes"]["WEIGHTS_0"] = glb.vertices(weights, BYTE, normalized=True)
    lots = striped(rest)
    parts = [whole | {"indices": glb.indices(lot), "material": wears, "targets": targets}
             for lot, wears in zip(lots, materials)]
    return glb.mesh("body", *parts, weights=[0.0, 0.0],
                    extras={"targetNames": ["breathe", "stretch"]})


# ---- what hangs on joints -----------------------------------------------------------------------


def head(glb, of):
    """Seen from the last joint, which is at the neck."""
    skull = ball((0, 0, 0.1), 0.43, 11, 18)
    eyes, pupils, horns, knobs = Surface(), Surface(), Surface(), Surface()
    for side in (-1, 1):
        out = unit((side * 0.52, 0.42, 0.75))
        eyes += ball(add((0, 0, 0.1), out, 0.36), 0.135, 7, 12)
        pupils += ball(add((0, 0, 0.1), add(out, (side * -0.05, 0.02, 0.12)), 0.44), 0.07, 6, 10)
        root, tip = (side * 0.15, 0.36, 0.1), (side * 0.34, 0.8, 0.16)
        middle = (side * 0.2, 0.6, 0.08)
        horns += drawn([root, middle, tip], [0.035, 0.028, 0.022], 8)
        knobs += ball(tip, 0.07, 6, 9)
    smile = [(0.27 * sin(a), -0.12 - 0.1 * cos(a), 0.1 + 0.345 + 0.03 * cos(2 * a))
             for a in (-1.2 + 0.3 * k for k in range(9))]
    mouth = drawn(smile, [0.022] * len(smile), 6)
    return glb.mesh("head", *(glb.primitive(surface, of[name]) for surface, name in (
        (skull, "face"), (eyes, "white"), (pupils, "black"), (horns, "face"), (knobs, "yellow"),
        (mouth, "black"))))


def feet(glb, of):
    pair = Surface()
    for side in (-1, 1):
        pair += ball((side * 0.2, -0.27, 0), 0.11, 6, 9)
    return glb.mesh("feet", glb.primitive(pair, of["feet"]))


# ---- motion -------------------------------------------------------------------------------------


def pitch(joint, phase):
    """How far a joint turns about +x: each against the one before, so that a hump runs along."""
    def slope(k):
        return 0.5 * sin(2 * pi * (k / 5.2 - phase)) * (0.45 + 0.55 * k / JOINTS)
    return -slope(joint) if joint == 0 else slope(joint - 1) - slope(joint)


def turn(joint, phase):
    """As a quaternion; the head stays a little up."""
    angle = pitch(joint, phase) - (0.15 if joint == JOINTS - 1 else 0)
    return sin(angle / 2), 0.0, 0.0, cos(angle / 2)


def lift(phase):
    """Where the first joint is: as high as its lowest foot must be."""
    y, z, low, angle = 0.0, 0.0, 0.0, 0.0
    for joint in range(JOINTS):
        if joint:
            y, z = y - SPACING * sin(angle), z + SPACING * cos(angle)
        angle += pitch(joint, phase)
        low = min(low, y)
    return 0.0, 0.38 - low, -LENGTH / 2


def skeleton(glb, mesh_of_head, mesh_of_feet):
    """The joints' nodes, each the child of the one before; their skin."""
    joints = []
    for k in range(JOINTS):
        place = lift(0) if k == 0 else (0, 0, SPACING)
        joints.append(glb.node(f"joint {k}", translation=[round(x, 6) for x in place],
                               rotation=[round(x, 6) for x in turn(k, 0)]))
    nodes = glb.document["nodes"]
    for k in range(JOINTS):
        below = [joints[k + 1]] if k + 1 < JOINTS else [glb.node("head", mesh=mesh_of_head)]
        if 0 < k < JOINTS - 1:
            below.append(glb.node(f"feet {k}", mesh=mesh_of_feet))
        nodes[joints[k]]["children"] = below
    binds = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.36, LENGTH / 2 - k * SPACING, 1)
             for k in range(JOINTS)]
    skin = glb.add("skins", {"name": "worm", "joints": joints, "skeleton": joints[0],
                             "inverseBindMatrices": glb.accessor(binds)})
    return joints, skin


def walk(glb, joints, worm):
    phases = [k / STEPS for k in range(STEPS + 1)]
    times = glb.accessor([SECONDS * p for p in phases], bounds=True)
    samplers, channels = [], []

    def channel(node, path, rows):
        samplers.append({"input": times, "output": glb.accessor(rows), "interpolation": "LINEAR"})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})
    for k, joint in enumerate(joints):
        channel(joint, "rotation", [turn(k, p) for p in phases])
    channel(joints[0], "translation", [lift(p) for p in phases])
    channel(worm, "weights", [w for p in phases
                              for w in (0.5 - 0.5 * cos(2 * pi * p), 0.5 + 0.5 * sin(4 * pi * p))])
    glb.add("animations", {"name": "walk", "samplers": samplers, "channels": channels})


def main():
    glb = Glb("A caterpillar that walks")
    of = {name: glb.material(name, srgb(*color), 0.0, roughness) for name, color, roughness in (
        ("green", (104, 176, 52), 0.45), ("yellow", (240, 200, 60), 0.45),
        ("face", (206, 120, 48), 0.4), ("white", (244, 242, 236), 0.15),
        ("black", (22, 20, 24), 0.1), ("feet", (70, 60, 48), 0.6))}
    joints, skin = skeleton(glb, head(glb, of), feet(glb, of))
    mesh = skinned_mesh(glb, (of["green"], of["yellow"]))
    worm = glb.node("worm", mesh=mesh, skin=skin)
    walk(glb, joints, worm)
    sys.stdout.buffer.write(glb.file(joints[0], worm))


if __name__ == "__main__":
    main()
