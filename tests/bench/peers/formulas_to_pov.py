"""Surfaces from formulas as POV-Ray 3.7 has them: isosurface, parametric, quadric, cubic, quartic,
poly."""

import math

from expressions import evaluator, folded, parsed, pov_text
from gradients import steepest
from primitives import CannotExpress
from vectors import IDENTITY

ACCURACY = 0.001  # POV-Ray's own default
PRECOMPUTED = 20  # depth of a parametric surface's table of boxes: the most, the fastest to trace
MOST_POLY_DEGREE = 35
GRID = 200  # points a side at which a parametric surface's extent is looked up


def corner(v):
    return "<{:.9g}, {:.9g}, {:.9g}>".format(*v)


def box_of(bounds):
    """The bounds' smallest box."""
    if "radius" in bounds:
        center, r = bounds["center"], bounds["radius"]
        return [x - r for x in center], [x + r for x in center]
    return bounds["min"], bounds["max"]


def region(bounds):
    """The bounds as an object."""
    if "radius" in bounds:
        return f"sphere {{ {corner(bounds['center'])}, {bounds['radius']:.9g} }}"
    return f"box {{ {corner(bounds['min'])}, {corner(bounds['max'])} }}"


def within(bounds):
    """Whether a point is inside the bounds, which their box holds."""
    if "radius" not in bounds:
        return lambda point: True
    return lambda point: math.dist(point, bounds["center"]) <= bounds["radius"]


def isosurface(tree, bounds, share):
    """What is below 0 is inside; `open` leaves the bounds' own faces out."""
    low, high = box_of(bounds)
    most = steepest(evaluator(tree, "xyz"), low, high, within(bounds))
    return "isosurface", (f"function {{ {pov_text(tree)} }} contained_by {{ {region(bounds)} }} "
                          f"accuracy {ACCURACY} max_gradient {share * most:.6g} open")


def parametric(f, share):
    """In the smallest box that holds the surface; its max_gradient bounds each coordinate's change
    along u and v."""
    names = {name: folded(parsed(f[name], f.get("parameters"))) for name in "xyz"}
    (u0, u1), (v0, v1) = f["u"], f["v"]
    functions = [evaluator(tree, "uv") for tree in names.values()]
    most = max(steepest(function, (u0, v0), (u1, v1)) for function in functions)
    low, high = [], []
    for function in functions:
        values = [function(u0 + (u1 - u0) * i / GRID, v0 + (v1 - v0) * j / GRID)
                  for i in range(GRID + 1) for j in range(GRID + 1)]
        spare = 0.01 + 0.01 * (max(values) - min(values))
        low.append(min(values) - spare)
        high.append(max(values) + spare)
    written = " ".join(f"function {{ {pov_text(tree)} }}" for tree in names.values())
    return "parametric", (f"{written} <{u0:.17g}, {v0:.17g}>, <{u1:.17g}, {v1:.17g}> "
                          f"contained_by {{ box {{ {corner(low)}, {corner(high)} }} }} "
                          f"accuracy {ACCURACY} max_gradient {share * most:.6g} "
                          f"precompute {PRECOMPUTED} x, y, z")


def poly(terms):
    """POV-Ray lists all coefficients of a degree, the highest powers first: x's, then y's, z's.
    Above the fourth degree it isolates roots by Sturm's theorem; up to it in closed form, which is
    faster: `sturm` would be for quartics whose pictures show that this is not enough."""
    sums = {}
    for i, j, k, c in terms:
        sums[i, j, k] = sums.get((i, j, k), 0) + c
    degree = max(map(sum, sums))
    if not 2 <= degree <= MOST_POLY_DEGREE:
        raise CannotExpress(f"a polynomial of degree {degree}")
    listed = ", ".join(f"{sums.get((i, j, k), 0):.17g}" for i in range(degree, -1, -1)
                       for j in range(degree - i, -1, -1) for k in range(degree - i - j, -1, -1))
    word = {3: "cubic", 4: "quartic"}.get(degree)
    return (word, f"<{listed}>") if word else ("poly", f"{degree}, <{listed}>")


def quadric(coefficients):
    groups = [coefficients[at:at + 3] for at in (0, 3, 6)]
    return "quadric", f"{', '.join(map(corner, groups))}, {coefficients[9]:.9g}"


def placed(m):
    """A transform: POV-Ray lists where each axis goes, then the origin."""
    if m == IDENTITY:
        return ""
    return f" matrix <{', '.join(f'{x:.17g}' for column in zip(*m) for x in column)}>"


def formula(kind, f, share):
    """Returns: POV-Ray's word for a formula's surface, and what stands between the braces, where
    max_gradient is that share of how steep the formula is at its steepest."""
    if kind == "parametric":
        word, body = parametric(f, share)
    elif kind in ("implicit", "explicit"):
        text = f["f"] if kind == "implicit" else f"z - ({f['z']})"
        tree = folded(parsed(text, f.get("parameters")))
        word, body = isosurface(tree, f["bounds"], share)
    else:
        word, body = poly(f["terms"]) if kind == "algebraic" else quadric(f["coefficients"])
    if kind in ("algebraic", "quadric") and "bounds" in f:
        body += f" clipped_by {{ {region(f['bounds'])} }} bounded_by {{ clipped_by }}"
    return word, body + placed(f["place"])
