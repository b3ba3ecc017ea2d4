"""Scenes with one surface from a formula each: name -> Tia scene."""

from expressions import terms

# Named polynomials in x, y and z; inside where they are below 0.
POLYNOMIALS = {
    "torus": "(x^2 + y^2 + z^2 + 0.84)^2 - 4*(x^2 + z^2)",
    "superellipsoid": "x^4 + y^4 + z^4 - 1",
    "steiner": "x^2*y^2 + y^2*z^2 + z^2*x^2 - x*y*z",
    "barth-sextic": "4*(phi^2*x^2 - y^2)*(phi^2*y^2 - z^2)*(phi^2*z^2 - x^2)"
                    " - (1 + 2*phi)*(x^2 + y^2 + z^2 - 1)^2",
    "heart": "(x^2 + 9/4*z^2 + y^2 - 1)^3 - x^2*y^3 - 9/80*z^2*y^3",
    "chmutov-8": " + ".join(f"(128*{a}^8 - 256*{a}^6 + 160*{a}^4 - 32*{a}^2 + 1)" for a in "xyz"),
    "cayley": "x^2 + y^2 + z^2 - 2*x*y*z - 1",
    "clebsch": "81*(x^3 + y^3 + z^3) - 189*(x^2*y + x^2*z + y^2*x + y^2*z + z^2*x + z^2*y)"
               " + 54*x*y*z + 126*(x*y + y*z + z*x) - 9*(x^2 + y^2 + z^2) - 9*(x + y + z) + 1",
}
CONSTANTS = {"phi": (1 + 5 ** 0.5) / 2}


def ball(radius):
    return {"center": [0, 0, 0], "radius": radius}


def box(half):
    return {"min": [-half] * 3, "max": [half] * 3}


def shown(item, distance=4.5, light=(4, 6, 5)):
    """A surface around the origin, seen from above, lit by one point that casts shadows."""
    a = distance / 7
    return {
        "camera": {"location": [3 * a, 2.5 * a, 5.8 * a], "look_at": [0, 0, 0],
                   "fov_degrees": 34},
        "background": [0.2, 0.3, 0.5],
        "objects": [{**item, "material": {"color": [0.8, 0.75, 0.6], "diffuse": 0.9}}],
        "lights": [{"type": "point", "position": list(light)}],
    }


def algebraic(name, bounds=None, **view):
    item = {"type": "algebraic", "terms": terms(POLYNOMIALS[name], CONSTANTS)}
    return shown({**item, "bounds": bounds} if bounds else item, **view)


def implicit(f, bounds, **view):
    return shown({"type": "implicit", "f": f, "bounds": bounds}, **view)


def parametric(x, y, z, u, v, **view):
    return shown({"type": "parametric", "x": x, "y": y, "z": z, "u": u, "v": v}, **view)


def polynomials():
    """What POV-Ray calls cubic, quartic and poly."""
    return {
        "torus": algebraic("torus", {"min": [-1.5, -0.5, -1.5], "max": [1.5, 0.5, 1.5]},
                           distance=5),
        "torus-unbounded": algebraic("torus", distance=5),
        "superellipsoid": algebraic("superellipsoid", box(1.1), distance=4.5),
        "steiner": algebraic("steiner", ball(1), distance=2.6),
        "barth-sextic": algebraic("barth-sextic", ball(2), distance=7),
        "heart": algebraic("heart", box(1.5), distance=4.5),
        "chmutov-8": algebraic("chmutov-8", box(1.1), distance=5.7),
        "cayley": algebraic("cayley", ball(2.2), distance=8),
        "clebsch": algebraic("clebsch", ball(1.5), distance=5.5),
    }


def isosurfaces():
    """What POV-Ray calls isosurfaces."""
    gyroid = "sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)"
    blobs = " + ".join(f"exp(-3*((x - {x})*(x - {x}) + (y - {y})*(y - {y}) + (z - {z})*(z - {z})))"
                       for x, y, z in ((-0.6, 0, 0), (0.6, 0.1, 0), (0, 0.8, 0.2), (0, -0.5, 0.6)))
    far = {"light": (14, 20, 16)}
    return {
        "gyroid-ball": implicit(gyroid, ball(6), distance=23, **far),
        "gyroid-box": implicit(gyroid, box(4), distance=23, **far),
        "blobs": implicit(f"0.4 - ({blobs})", box(2), distance=5.5),
        "landscape": shown({"type": "explicit", "z": "0.4*sin(2*x)*cos(2*y) + 0.1*sin(5*x + 3*y)",
                            "bounds": {"min": [-3, -3, -0.6], "max": [3, 3, 0.6]},
                            "transform": [{"rotate_degrees": [-90, 0, 0]}]},
                           distance=10.5, light=(-4, 12, 5)),
    }


def parametrics():
    """What POV-Ray calls parametric."""
    turn, half = [0, 6.283185307179586], [0, 3.141592653589793]
    eight = "(2 + cos(u/2)*sin(v) - sin(u/2)*sin(2*v))"
    strip = "(1 + v/2*cos(u/2))"
    return {
        "param-sphere": parametric("cos(u)*sin(v)", "cos(v)", "sin(u)*sin(v)", turn, half,
                                   distance=4.2),
        "param-torus": parametric("(1 + 0.4*cos(v))*cos(u)", "0.4*sin(v)",
                                  "(1 + 0.4*cos(v))*sin(u)", turn, turn, distance=5),
        "klein-8": parametric(f"{eight}*cos(u)", "sin(u/2)*sin(v) + cos(u/2)*sin(2*v)",
                              f"{eight}*sin(u)", turn, turn, distance=11, light=(8, 12, 10)),
        "moebius": parametric(f"{strip}*cos(u)", "v/2*sin(u/2)", f"{strip}*sin(u)", turn,
                              [-1, 1], distance=5),
    }


def formula_scenes():
    """All of them by name."""
    scenes = {**polynomials(), **isosurfaces(), **parametrics()}
    return {name: {"title": name, **scene} for name, scene in scenes.items()}
