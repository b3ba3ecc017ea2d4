#!/usr/bin/env python3
"""Prints web/scenes/knot.json: balls along a torus knot, their colours around the circle of hues.

The (3, 5) torus knot winds 3 times around the axis and 5 times around the tube of a torus:
((R + r cos qt) cos pt, r sin qt, (R + r cos qt) sin pt), p = 3, q = 5, 0 <= t < 2 pi.
"""

from math import cos, pi, sin

BALLS, P, Q, MAJOR, MINOR, RADIUS = 150, 3, 5, 2.2, 0.95, 0.23


def number(x):
    return f"{round(x, 3) + 0.0:.3f}".rstrip("0").rstrip(".")


def triple(values):
    return "[" + ", ".join(number(v) for v in values) + "]"


def center(t):
    out = MAJOR + MINOR * cos(Q * t)
    return out * cos(P * t), MINOR * sin(Q * t), out * sin(P * t)


def hue(share):
    """Linear RGB, a cosine for each channel."""
    return [0.03 + 0.9 * (0.5 + 0.5 * cos(2 * pi * (share - third / 3))) ** 2 for third in range(3)]


def even_places(count):
    """Parameters at even distances along the curve."""
    steps = 20000
    ts = [2 * pi * i / steps for i in range(steps + 1)]
    ps = [center(t) for t in ts]
    length = [0.0]
    for a, b in zip(ps, ps[1:]):
        length.append(length[-1] + sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5)
    places, i = [], 0
    for k in range(count):
        while length[i + 1] < length[-1] * k / count:
            i += 1
        places.append(ts[i])
    return places


balls = ",\n".join(
    f'        {{ "type": "sphere", "center": {triple(center(t))}, "radius": {RADIUS}, '
    f'"material": {{ "color": {triple(hue(k / BALLS))}, "ambient": 0.12, "specular": 0.8, '
    f'"roughness": 0.01, "reflection": 0.2 }} }}'
    for k, t in enumerate(even_places(BALLS)))
print(f"""{{
  "title": "A knot of balls",
  "description": "{BALLS} shiny balls along the (3, 5) torus knot: three times around the axis, five times around the tube. Follow the colours: they run around the circle of hues once, and the thread comes back to where it began.",
  "camera": {{ "location": [0, 7.4, 7.4], "look_at": [0.1, 0.55, 0.1], "fov_degrees": 36 }},
  "background": [0.05, 0.06, 0.09],
  "objects": [
    {{ "name": "floor", "type": "plane", "point": [0, -0.5, 0], "normal": [0, 1, 0], "material": {{ "color": [0.3, 0.31, 0.34], "ambient": 0.15, "reflection": 0.15 }} }},
    {{ "name": "knot", "type": "group", "transform": [{{ "translate": [0, 0.9, 0] }}], "children": [
{balls}
      ] }}
  ],
  "lights": [
    {{ "type": "point", "position": [-6, 12, 7], "intensity": 0.9 }},
    {{ "type": "point", "position": [9, 6, 2], "color": [0.25, 0.3, 0.4] }}
  ],
  "options": {{ "samples": 8, "threshold": 0.03 }}
}}""")
