#!/usr/bin/env python3
"""Prints web/scenes/street-lamp.json: a lamp in fog behind a fence and a bare tree.

The tree's limbs part at random, from a seed, each a cone between two points.
"""

from json import dumps
from random import Random

LAMP = (0.9, 3.1, -5.5)
WOOD = {"color": [0.22, 0.2, 0.18]}
BARK = {"color": [0.02, 0.018, 0.015]}
IRON = {"color": [0.008, 0.008, 0.008]}
random = Random(4)


def rounded(point):
    return [round(x, 3) + 0.0 for x in point]


def cone(base, cap, base_radius, cap_radius, material):
    return {"type": "cone", "base": rounded(base), "cap": rounded(cap), "base_radius": round(base_radius, 4),
            "cap_radius": round(cap_radius, 4), "material": material}


def lamp():
    x, y, z = LAMP
    yield {"name": "globe", "type": "sphere", "center": LAMP, "radius": 0.28,
           "material": {"color": [0, 0, 0], "emission": [52, 38, 21]}}
    yield cone((x, y + 0.25, z), (x, y + 0.42, z), 0.2, 0.03, "iron")
    yield cone((x, 0, z), (x, y - 0.26, z), 0.06, 0.05, "iron")
    yield cone((x, 0, z), (x, 0.5, z), 0.11, 0.09, "iron")


def fence():
    for i in range(26):
        if i not in range(12, 16):  # the gate
            x = -3.6 + 0.27 * i
            yield {"type": "box", "min": rounded((x, 0.08, -4.05)), "max": rounded((x + 0.13, 1.25, -4)),
                   "material": "wood"}
    for left, right in ((-3.7, -0.33), (0.66, 3.5)):
        for y in (0.3, 0.95):
            yield {"type": "box", "min": [left, y, -4.1], "max": [right, round(y + 0.09, 2), -4.05],
                   "material": "wood"}


def tree(root, way, length, radius, forks):
    end = [p + length * w for p, w in zip(root, way)]
    yield cone(root, end, radius, 0.72 * radius, "bark")
    for _ in range(0 if forks == 0 else 2 if forks < 3 else 3):
        turned = [w + random.uniform(-0.75, 0.75) for w in way]
        turned[1] += 0.12
        size = sum(t * t for t in turned) ** 0.5
        yield from tree(end, [t / size for t in turned], length * random.uniform(0.6, 0.8), 0.7 * radius, forks - 1)


objects = [{"name": "street", "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
            "material": {"type": "principled", "base_color": [0.035, 0.036, 0.04], "roughness": 0.6, "specular": 0.5}},
           *lamp(), *fence(), *tree((1.9, 0, -4.6), (-0.08, 1, 0.05), 1.25, 0.11, 4)]
lines = ",\n".join("    " + dumps(each) for each in objects)
materials = ",\n".join(f'    "{name}": {dumps(each)}' for name, each in (("wood", WOOD), ("bark", BARK), ("iron", IRON)))
print(f"""{{
  "title": "A street lamp in fog",
  "description": "Fog scatters the light of the lamp towards the eye, and what stands in its way throws shadows into the air.",
  "camera": {{"location": [-0.5, 1.45, 1.8], "look_at": [0.35, 1.62, -5], "fov_degrees": 40}},
  "fog": {{"density": 0.08, "albedo": [0.7, 0.7, 0.72], "g": 0.4}},
  "materials": {{
{materials}
  }},
  "objects": [
{lines}
  ],
  "options": {{"integrator": "path", "samples": 128, "max_depth": 4, "exposure": 2, "transfer": "aces"}}
}}""")
