#!/usr/bin/env python3
"""Prints web/scenes/newtons-disc.json: a disc of seven colours whose mean is grey, which spins ever faster.

Its faces are a mesh with a colour at each corner. At 24 turns a second and 24 frames the shutter is open for one turn,
in 28 steps: each point sees each colour in four of them.
"""

from json import dumps
from math import cos, pi, sin

COLORS = [[0.95, 0.04, 0.04], [0.95, 0.4, 0.03], [0.85, 0.85, 0.1], [0.05, 0.8, 0.2], [0.04, 0.55, 0.95],
          [0.1, 0.33, 1], [0.36, 0.33, 0.98]]
RADIUS, PARTS = 2, 9  # of the disc; of a sector's rim

positions, colors, indices = [], [], []
for k, color in enumerate(COLORS):
    first = len(positions) // 3
    angles = [2 * pi * (k + i / PARTS) / len(COLORS) for i in range(PARTS + 1)]
    for x, y in [(0, 0)] + [(RADIUS * sin(a), RADIUS * cos(a)) for a in angles]:
        positions += [round(x, 4) + 0.0, round(y, 4) + 0.0, 0]
        colors += [*color, 1]
    for i in range(PARTS):
        indices += [first, first + i + 2, first + i + 1]
print(f"""{{
  "title": "Newton's disc",
  "description": "Seven colours that spin ever faster, up to 24 turns a second: while the shutter is open they run into each other, and in the end they are grey. Give a time from 0 to 4.",
  "camera": {{ "location": [0, 3.2, 10], "look_at": [0, 2.35, 0], "fov_degrees": 35 }},
  "background": [0.1, 0.1, 0.12],
  "materials": {{
    "wall": {{ "color": [0.66, 0.68, 0.72], "ambient": 0.12, "diffuse": 0.85 }},
    "oak": {{ "ambient": 0.15, "diffuse": 0.8, "texture": {{ "type": "wood", "colors": [[0.5, 0.3, 0.15], [0.36, 0.2, 0.1]], "scale": 0.15, "transform": [{{ "rotate_degrees": [88, 4, 0] }}] }} }},
    "brass": {{ "color": [0.7, 0.5, 0.2], "ambient": 0.15, "diffuse": 0.6, "specular": 0.7, "roughness": 0.02, "reflection": 0.2 }}
  }},
  "objects": [
    {{ "name": "wall", "type": "plane", "point": [0, 0, -2.4], "normal": [0, 0, 1], "material": "wall" }},
    {{ "name": "table", "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": {{ "color": [0.3, 0.27, 0.25], "ambient": 0.15, "diffuse": 0.8, "reflection": 0.1 }} }},
    {{ "name": "disc", "type": "mesh", "positions": {dumps(positions)},
      "colors": {dumps(colors)},
      "indices": {dumps(indices)},
      "material": {{ "ambient": 0.2, "diffuse": 0.9 }},
      "transform": [{{ "rotate_degrees": [0, 0, 0] }}, {{ "rotate_degrees": [0, -24, 0] }}, {{ "translate": [0, 2.6, 0.1] }}] }},
    {{ "name": "stand", "type": "group", "transform": [{{ "rotate_degrees": [0, -24, 0] }}], "children": [
      {{ "type": "cylinder", "base": [0, 2.6, -0.35], "cap": [0, 2.6, 0.3], "radius": 0.13, "material": "brass" }},
      {{ "type": "sphere", "center": [0, 2.6, 0.3], "radius": 0.16, "material": "brass" }},
      {{ "type": "box", "min": [-0.22, 0, -0.6], "max": [0.22, 2.9, -0.25], "material": "oak" }},
      {{ "type": "box", "min": [-1.1, 0, -1], "max": [1.1, 0.22, 0.7], "material": "oak" }}] }}
  ],
  "lights": [{{ "type": "sphere", "position": [-5, 8, 8], "radius": 0.8, "samples": 4 }}],
  "animation": {{ "duration": 4, "fps": 24, "shutter": 1, "tracks": [
    {{ "target": "/objects/disc/transform/0/rotate_degrees", "formula": ["0", "0", "-1440*min(t, 3)^2 - 8640*max(t - 3, 0)"] }}
  ] }},
  "options": {{ "samples": 28, "blur_steps": 28 }}
}}""")
