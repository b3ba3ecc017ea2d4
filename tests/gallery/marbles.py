#!/usr/bin/env python3
"""Prints web/scenes/marbles.json: marbles in chutes, of which each is a mesh with a V's section.

A chute begins under the end of the one above it, where a post sends back what comes too fast; the last one is closed.
"""

from json import dumps

RADIUS, COUNT = 0.42, 3           # of a marble; of the chutes
LONG, OVER, FALL, DROP = 9.0, 1.3, 1.9, 1.1   # of a chute, in x; beyond the end of the one above; in y; to the next one
HALF, RISE = 0.85, 0.62           # of the V
MARBLES = [("ruby", [0.75, 0.04, 0.06], 0.55), ("amber", [0.9, 0.5, 0.03], 0.45), ("emerald", [0.03, 0.5, 0.16], 0.5),
           ("sapphire", [0.05, 0.14, 0.7], 0.4), ("amethyst", [0.4, 0.08, 0.55], 0.5), ("pearl", [0.85, 0.83, 0.78], 0.45)]


def rounded(values):
    return [round(x, 4) + 0.0 for x in values]


def chute(k):
    """From its upper to its lower end: their x and y, and the way that it leads."""
    way = 1 if k % 2 == 0 else -1
    y = -k * (FALL + DROP)
    return (-way * (LONG / 2 + OVER), y), (way * LONG / 2, y - FALL), way


def trough(k):
    (x0, y0), (x1, y1), _ = chute(k)
    positions = [c for x, y in ((x0, y0), (x1, y1)) for z, up in ((HALF, RISE), (0, 0), (-HALF, RISE)) for c in (x, y + up, z)]
    indices = [0, 3, 1, 1, 3, 4, 1, 4, 2, 2, 4, 5]
    return {"name": f"chute {k + 1}", "type": "mesh", "positions": rounded(positions), "indices": indices, "material": "pine"}


def posts():
    """Two that carry the upper ends, and against which marbles fly; a third where the run ends."""
    end = LONG / 2 + OVER
    (_, y), (x1, y1), way = chute(COUNT - 1)
    for name, x, high in (("left post", -end - 0.3, 1.4), ("right post", end, y + FALL + 2 * DROP + 1.2),
                          ("last post", x1 if way > 0 else x1 - 0.3, y1 + 1.3)):
        yield {"name": name, "type": "box", "min": rounded((x, y1 - 1.2, -HALF - 0.1)),
               "max": rounded((x + 0.3, high, HALF + 0.1)), "material": "beech"}


def marbles():
    (x0, y0), (x1, y1), _ = chute(0)
    lift = RADIUS * ((HALF ** 2 + RISE ** 2) ** 0.5 / HALF) * (1 + ((y1 - y0) / (x1 - x0)) ** 2) ** 0.5
    for i, (name, color, _) in enumerate(MARBLES):
        x = x0 + 0.6 + 1.02 * i
        y = y0 + (y1 - y0) * (x - x0) / (x1 - x0) + 1.02 * lift
        yield {"name": name, "type": "sphere", "center": rounded((x, y, 0)), "radius": RADIUS, "material": {
            "color": color, "ambient": 0.15, "diffuse": 0.8, "specular": 0.8, "roughness": 0.004, "reflection": 0.1}}


NEXT = ",\n"
parts = [*map(trough, range(COUNT)), *posts()]
objects = NEXT.join("    " + dumps(each) for each in (*parts, *marbles()))
bodies = NEXT.join(f'      {{ "object": "{name}", "density": 2.5, "restitution": {e} }}' for name, _, e in MARBLES)
stand = NEXT.join(f'      {{ "object": "{name}" }}' for name in ["floor"] + [each["name"] for each in parts])
FLOOR = round(chute(COUNT - 1)[1][1] - 1.2, 4)
print(f"""{{
  "title": "A marble run",
  "description": "Six marbles slide down three chutes that are meshes, bounce off posts, and come to rest in a row. Give a time from 0 to 11.",
  "camera": {{ "location": [-6, 6, 22], "look_at": [0.1, -3.9, 0], "fov_degrees": 34.5 }},
  "background": [0.62, 0.72, 0.82],
  "materials": {{
    "pine": {{ "ambient": 0.2, "diffuse": 0.8, "texture": {{ "type": "wood", "colors": [[0.8, 0.6, 0.36], [0.66, 0.45, 0.24]], "scale": 0.25, "transform": [{{ "rotate_degrees": [0, 90, 0] }}, {{ "translate": [0, -2, 1] }}] }} }},
    "beech": {{ "color": [0.55, 0.3, 0.16], "ambient": 0.2, "diffuse": 0.8 }}
  }},
  "objects": [
    {{ "name": "floor", "type": "plane", "point": [0, {FLOOR}, 0], "normal": [0, 1, 0], "material": {{ "color": [0.5, 0.53, 0.56], "ambient": 0.3, "diffuse": 0.7, "reflection": 0.08 }} }},
{objects}
  ],
  "lights": [
    {{ "type": "sphere", "position": [-10, 16, 12], "radius": 1.2, "samples": 9 }}
  ],
  "physics": {{ "duration": 11,
    "bodies": [
{bodies}],
    "fixed": [
{stand}] }},
  "options": {{ "samples": 4 }}
}}""")
