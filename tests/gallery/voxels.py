#!/usr/bin/env python3
"""Prints web/scenes/voxels.json: a lighthouse on its rock, built of cells of a grid, in runs; with the
argument `clay` web/scenes/clay.json, the same all of one material."""

import sys
from math import atan2, floor, hypot, pi

NX, NY, NZ = 72, 72, 60
TOWER_X, TOWER_Z, GROUND, TOP = 30, 26, 13, 50
HOUSE_X, HOUSE_Z = 46, 24
MATERIALS = [
    ("rock", [0.16, 0.14, 0.13]), ("pale rock", [0.26, 0.235, 0.21]), ("grass", [0.12, 0.3, 0.05]),
    ("light grass", [0.2, 0.4, 0.08]), ("white", [0.86, 0.84, 0.79]), ("red", [0.62, 0.05, 0.035]),
    ("dark", [0.03, 0.032, 0.04]), ("wood", [0.3, 0.16, 0.07]), ("pine", [0.03, 0.13, 0.05]),
    ("lamp", None), ("window", None)]
NUMBERS = {name: i + 1 for i, (name, _) in enumerate(MATERIALS)}
cells = {}


def put(x, y, z, name):
    if 0 <= x < NX and 0 <= y < NY and 0 <= z < NZ:
        cells[x, y, z] = NUMBERS[name]


def clear(x, y, z):
    cells.pop((x, y, z), None)


def noise(*place):
    """A number in [0, 1) of integers, the same everywhere."""
    value = 2166136261
    for each in place:
        value = ((value ^ (each & 0xFFFF)) * 16777619) & 0xFFFFFFFF
        value ^= value >> 13
    return (value * 2654435761 & 0xFFFFFFFF) / 2**32


def smooth_noise(x, z, pace):
    """Between the corners of squares of side `pace`, bilinear."""
    i, k = floor(x / pace), floor(z / pace)
    u, v = x / pace - i, z / pace - k
    near = noise(i, k) * (1 - u) + noise(i + 1, k) * u
    far = noise(i, k + 1) * (1 - u) + noise(i + 1, k + 1) * u
    return near * (1 - v) + far * v


def height(x, z):
    """Of the rock: a flat top with cliffs around it that are rough towards the sea."""
    out = hypot((x - 36) / 33, (z - 27) / 24)
    rough = 7 * smooth_noise(x, z, 7) + 3 * smooth_noise(x + 90, z, 3)
    return floor(min(GROUND, 42 * (1 - out) ** 0.75 + rough - 7)) if out < 1 else 0


def rock():
    for x in range(NX):
        for z in range(NZ):
            top = height(x, z)
            for y in range(top):
                layer = floor((y + 3 * smooth_noise(x, z, 9)) / 3) % 2
                put(x, y, z, "rock" if layer else "pale rock")
            if top >= GROUND - 1:
                put(x, top - 1, z, "grass" if smooth_noise(x + 7, z, 5) < 0.5 else "light grass")


def disc(y, radius, name, hole=-1.0, x=TOWER_X, z=TOWER_Z):
    for i in range(x - 9, x + 10):
        for k in range(z - 9, z + 10):
            if hole < hypot(i - x, k - z) <= radius:
                put(i, y, k, name)


def tower():
    for y in range(GROUND, TOP):
        radius = 6.4 - 2.2 * (y - GROUND) / (TOP - GROUND)
        for i in range(TOWER_X - 9, TOWER_X + 10):
            for k in range(TOWER_Z - 9, TOWER_Z + 10):
                if hypot(i - TOWER_X, k - TOWER_Z) <= radius:
                    turn = atan2(k - TOWER_Z, i - TOWER_X) / (2 * pi)
                    stripe = floor(2 * (turn + (y - GROUND) / 25)) % 2
                    put(i, y, k, "red" if stripe else "white")
    for y in (GROUND, GROUND + 1):
        disc(y, 7.2, "pale rock")
    for y in (22, 31, 40):  # windows towards the camera
        front = max(k for i, j, k in cells if i == TOWER_X and j == y and k < TOWER_Z + 9)
        for j in range(3):
            put(TOWER_X, y + j, front, "dark")
    disc(TOP, 6.4, "dark")
    disc(TOP + 1, 6.4, "dark", 5.6)
    for i in range(TOWER_X - 7, TOWER_X + 8):  # every other post of the rail stays
        for k in range(TOWER_Z - 7, TOWER_Z + 8):
            if cells.get((i, TOP + 1, k)) == NUMBERS["dark"] and (i + k) % 2:
                clear(i, TOP + 1, k)
    disc(TOP + 2, 6.4, "dark", 5.6)
    for y in range(TOP + 1, TOP + 8):
        disc(y, 2.9, "lamp")
        for i, k in ((-3, 0), (3, 0), (0, -3), (0, 3), (-2, -2), (2, 2), (-2, 2), (2, -2)):
            put(TOWER_X + i, y, TOWER_Z + k, "dark")
    for step, radius in enumerate((5.4, 4.9, 4.1, 3.6, 2.9, 2.2, 1.5, 0.5, 0.5, 0.5)):
        disc(TOP + 8 + step, radius, "red" if radius > 1 else "dark")


def house():
    for x in range(HOUSE_X - 6, HOUSE_X + 7):
        for z in range(HOUSE_Z - 4, HOUSE_Z + 5):
            for y in range(GROUND, GROUND + 7):
                put(x, y, z, "white")
    for step in range(6):  # a gabled roof along x
        for x in range(HOUSE_X - 7, HOUSE_X + 8):
            for z in range(HOUSE_Z - 5 + step, HOUSE_Z + 6 - step):
                edge = abs(z - HOUSE_Z) == 5 - step
                inside = HOUSE_X - 6 <= x <= HOUSE_X + 6
                if edge or inside:
                    put(x, GROUND + 7 + step, z, "red" if edge else "white")
    front = HOUSE_Z + 4
    for y in range(GROUND, GROUND + 5):
        for x in (HOUSE_X, HOUSE_X + 1):
            put(x, y, front, "wood")
    for x in (-4, -3, 4, 5):
        for y in (3, 4):
            put(HOUSE_X + x, GROUND + y, front, "window")
    for y in range(GROUND + 8, GROUND + 16):
        for x in (HOUSE_X + 4, HOUSE_X + 5):
            for z in (HOUSE_Z - 1, HOUSE_Z):
                put(x, y, z, "pale rock")


def pine(x, z, tall):
    ground = height(x, z)
    for y in range(ground, ground + 3):
        put(x, y, z, "wood")
    for y in range(tall):
        radius = (1 - y / tall) * 3.2 * (0.72 if y % 3 == 2 else 1)
        disc(ground + 2 + y, radius, "pine", x=x, z=z)


def jetty():
    """From the shore into the water, on posts."""
    for z in range(42, 60):
        for x in range(50, 55):
            if not (x, 4, z) in cells:
                put(x, 4, z, "wood")
        if z % 5 == 4:
            for x in (50, 54):
                for y in range(7):
                    put(x, y, z, "wood")


def runs():
    """[count, material], x first, then y, then z; what is left is empty."""
    order = [cells.get((x, y, z), 0) for z in range(NZ) for y in range(NY) for x in range(NX)]
    while order[-1] == 0:
        order.pop()
    found = []
    for number in order:
        if found and found[-1][1] == number:
            found[-1][0] += 1
        else:
            found.append([1, number])
    return found


def hidden_as_neighbours():
    """What cannot be seen takes the material before it: fewer runs."""
    ways = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
    hidden = [c for c in sorted(cells, key=lambda c: (c[2], c[1], c[0]))
              if all((c[0] + i, c[1] + j, c[2] + k) in cells or c[1] + j < 0 for i, j, k in ways)]
    for x, y, z in hidden:
        cells[x, y, z] = cells.get((x - 1, y, z), cells[x, y, z])


rock()
tower()
house()
for place in ((14, 24, 13), (19, 36, 10), (58, 30, 12), (54, 13, 14), (40, 14, 10)):
    pine(*place)
jetty()
hidden_as_neighbours()

clay = "clay" in sys.argv
if clay:
    cells = dict.fromkeys(cells, 1)
lines, line = [], "       "
for run in runs():
    text = f" [{run[0]},{run[1]}],"
    if len(line) + len(text) > 160:
        lines.append(line)
        line = "       "
    line += text
lines.append(line.rstrip(","))
looks = {"lamp": '{ "color": [1, 0.9, 0.6], "emission": [1.1, 0.85, 0.4] }',
         "window": '{ "color": [1, 0.8, 0.4], "emission": [0.75, 0.5, 0.15] }'}
named = ",\n".join(
    f'    "{name}": ' + looks.get(name, f'{{ "color": {color}, "ambient": 0.32, "diffuse": 0.8 }}')
    for name, color in MATERIALS)
wears = ", ".join(f'"{name}"' for name, _ in MATERIALS)
count = len(cells)
grid = f"""
    {{ "name": "lighthouse", "type": "voxels", "size": [{NX}, {NY}, {NZ}], "origin": [{-NX / 2:g}, 0, {-NZ / 2:g}],
      "materials": [{'"clay"' if clay else wears}],
      "occupied": [
{chr(10).join(lines)}
      ] }}"""
if clay:
    print(f"""{{
  "title": "A lighthouse in clay",
  "description": "Ambient occlusion: each point is as bright as the share of the sky that it sees, by the cosine. Folds and corners are dark, with no lamp at all.",
  "camera": {{ "location": [-46, 30, 96], "look_at": [1, 29.5, 0], "fov_degrees": 41 }},
  "background": [1, 1, 1],
  "materials": {{ "clay": {{ "color": [0.8, 0.75, 0.7] }} }},
  "objects": [
    {{ "name": "table", "type": "plane", "point": [0, 2.6, 0], "normal": [0, 1, 0], "material": "clay" }},{grid}
  ],
  "options": {{ "integrator": "ambient_occlusion", "samples": 64, "ao_radius": 60, "exposure": -0.5 }}
}}""")
    sys.exit()
print(f"""{{
  "title": "A lighthouse of voxels",
  "description": "One object: {count} cells of a grid of {NX} x {NY} x {NZ}, given as runs, in {len(MATERIALS)} materials. Follow a ray from cell to cell: the shadows, the sea's mirror and the lit windows all come from one walk through the grid.",
  "camera": {{ "location": [-46, 30, 96], "look_at": [1, 29.5, 0], "fov_degrees": 41 }},
  "background": [0.42, 0.6, 0.82],
  "materials": {{
{named}
  }},
  "objects": [
    {{ "name": "sea", "type": "plane", "point": [0, 2.6, 0], "normal": [0, 1, 0], "material": {{ "color": [0.02, 0.1, 0.15], "ambient": 0.5, "diffuse": 0.7, "reflection": 0.45 }} }},{grid}
  ],
  "lights": [
    {{ "type": "directional", "direction": [-0.75, -0.62, -0.5], "color": [1, 0.9, 0.72], "intensity": 0.95 }},
    {{ "type": "point", "position": [-120, 60, 120], "color": [0.25, 0.3, 0.4], "intensity": 0.6 }}
  ]
}}""")
