"""Writes a Tia scene as Tachyon 0.99 reads it, which is left-handed: z is turned round.

Tachyon's SPECULAR is a mirror, its PHONG a highlight (Phong's own with -shade_phong); with
-trans_vmd what transmits keeps OPACITY of its own light, and transparent things dim shadows.
Its rays go through corners of pixels: in a picture with a row and a column less and pixels of the
same size these are the centres of Tia's, but for those of the first column and the last row.
"""

from primitives import CannotExpress, primitives, rgb
from vectors import scaled, subtract, unit
from views import eye, lights

OPTIONS = ["-fullshade", "-shade_phong", "-trans_vmd", "-shadow_filter_on"]
POINT = 1e-6  # the radius of a light that is not to be seen


def vector(v):
    return f"{v[0]:.9g} {v[1]:.9g} {-v[2]:.9g}"


def color(c):
    return "{:.9g} {:.9g} {:.9g}".format(*c)


def camera(scene, width, height):
    """The resolution and the camera; a mirror ray at the last depth brings the background."""
    e = eye(scene)
    depth = scene.get("options", {}).get("max_depth", 5)
    zoom = height / (height - 1) / (2 * e.half_height)
    return (f"RESOLUTION {width - 1} {height - 1}\nCAMERA\n  ZOOM {zoom:.9g}\n"
            f"  ASPECTRATIO 1\n  ANTIALIASING 0\n  RAYDEPTH {depth + 1}\n"
            f"  CENTER {vector(e.location)}\n  VIEWDIR {vector(e.direction)}\n"
            f"  UPDIR {vector(e.up)}\nEND_CAMERA")


def light(light):
    """A point is a very small ball: Tachyon shows its lights."""
    return (f"LIGHT CENTER {vector(light.position)} RAD {light.radius or POINT:.9g} "
            f"COLOR {color(light.color)}")


def texture(m):
    """A material, without its name."""
    if m["brilliance"] != 1:
        raise CannotExpress("brilliance")
    if m["transmission"] > 0 and m["ior"] != 1:
        raise CannotExpress("refraction")
    shine = ""
    if m["specular"] > 0:
        shine = f"PHONG PLASTIC {m['specular']:.9g} PHONG_SIZE {1 / m['roughness']:.9g} "
    return (f"AMBIENT {m['ambient']:.9g} DIFFUSE {m['diffuse']:.9g} SPECULAR {m['reflection']:.9g} "
            f"OPACITY {1 - m['transmission']:.9g} {shine}COLOR {color(rgb(m['color']))} TEXFUNC 0")


def ring(center, normal, radius):
    return f"RING CENTER {vector(center)} NORMAL {vector(normal)} INNER 0 OUTER {radius:.9g}"


def cylinder(f):
    """Tachyon's is open: two rings close it."""
    axis = subtract(f["cap"], f["base"])
    n = unit(axis)
    return [f"FCYLINDER BASE {vector(f['base'])} APEX {vector(f['cap'])} RAD {f['radius']:.9g}",
            ring(f["base"], scaled(n, -1), f["radius"]), ring(f["cap"], n, f["radius"])]


def triangle(corners, normals=None):
    """Corners go round the other way, as z is turned round: Tachyon faces smooth ones by it."""
    a, b, c = map(vector, corners)
    if normals is None:
        return f"TRI V0 {a} V1 {c} V2 {b}"
    n, m, o = map(vector, normals)
    return f"STRI V0 {a} V1 {c} V2 {b} N0 {n} N1 {o} N2 {m}"


def mesh(f):
    """Each of a mesh's triangles."""
    for t in f["indices"]:
        normals = [f["normals"][i] for i in t] if f["normals"] else None
        yield triangle([f["positions"][i] for i in t], normals)


def box(f):
    """Tachyon's normals are right on cubes only: other boxes are twelve triangles."""
    low, high = f["min"], f["max"]
    edges = subtract(high, low)
    if max(edges) - min(edges) < 1e-6 * max(edges):
        return [f"BOX MIN {vector((low[0], low[1], high[2]))} "
                f"MAX {vector((high[0], high[1], low[2]))}"]
    corners = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1])
               for z in (low[2], high[2])]
    sides = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
    return [triangle([corners[i] for i in t]) for a, b, c, d in sides
            for t in ((a, b, c), (a, c, d))]


def shapes(kind, f):
    """Tachyon's words for a primitive: one object or several."""
    if kind == "sphere":
        return [f"SPHERE CENTER {vector(f['center'])} RAD {f['radius']:.9g}"]
    if kind == "plane":
        return [f"PLANE CENTER {vector(f['point'])} NORMAL {vector(f['normal'])}"]
    if kind == "disc":
        return [ring(f["center"], f["normal"], f["radius"])]
    if kind == "box":
        return box(f)
    if kind == "cylinder":
        return cylinder(f)
    if kind == "triangle":
        return [triangle([f[name] for name in "abc"])]
    if kind == "mesh":
        return mesh(f)
    raise CannotExpress(kind)


def to_tachyon(scene, width, height):
    """A whole scene file; light is linear as it comes."""
    surfaces = primitives(scene)
    lines = ["BEGIN_SCENE", camera(scene, width, height),
             f"BACKGROUND {color(rgb(scene.get('background', 0)))}", *map(light, lights(scene))]
    names = {}
    for p in surfaces:
        look = texture(p.material)
        if look not in names:
            names[look] = f"M{len(names)}"
            lines.append(f"TEXDEF {names[look]} {look}")
        lines += [f"{words} {names[look]}" for words in shapes(p.kind, p.fields)]
    return "\n".join([*lines, "END_SCENE"]) + "\n"
