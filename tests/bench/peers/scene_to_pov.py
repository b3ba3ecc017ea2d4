"""Writes a Tia scene as POV-Ray 3.7 reads it. POV-Ray's space is left-handed only by its camera,
whose vectors are all given here: points stay as they are, and formulas, too."""

from formulas_to_pov import formula
from primitives import FORMULAS, CannotExpress, primitives, rgb
from vectors import dot, scaled, unit
from views import eye, lights


def vector(v):
    return f"<{v[0]:.9g}, {v[1]:.9g}, {v[2]:.9g}>"


def color(c):
    return "<{:.9g}, {:.9g}, {:.9g}>".format(*c)


def camera(scene, aspect):
    """Vectors instead of an angle: the same rays in any aspect."""
    e = eye(scene)
    height = 2 * e.half_height
    return (f"camera {{ perspective location {vector(e.location)} "
            f"direction {vector(e.direction)} up {vector(scaled(e.up, height))} "
            f"right {vector(scaled(e.right, height * aspect))} }}")


def light(light):
    """A point; a luminous ball is seen besides and casts no shadow."""
    text = f"light_source {{ {vector(light.position)}, rgb {color(light.color)} }}"
    if light.radius > 0:
        text += (f"\nsphere {{ {vector(light.position)}, {light.radius:.9g} "
                 f"pigment {{ rgb {color(light.color)} }} "
                 "finish { ambient 0 emission 1 diffuse 0 } no_shadow }")
    return text


def texture(m):
    """What transmits keeps (1 - T) of its own light: POV-Ray does that to scattered light only."""
    keep = 1 - m["transmission"]
    finish = (f"ambient {m['ambient']:.9g} diffuse {m['diffuse']:.9g} "
              f"brilliance {m['brilliance']:.9g}")
    if m["specular"] > 0:
        finish += f" phong {keep * m['specular']:.9g} phong_size {1 / m['roughness']:.9g}"
    if m["reflection"] > 0:
        finish += f" reflection {{ {keep * m['reflection']:.9g} }}"
    pigment = f"rgb {color(rgb(m['color']))} transmit {m['transmission']:.9g}"
    return f"texture {{ pigment {{ {pigment} }} finish {{ {finish} }} }}"


def mesh(fields):
    """POV-Ray's word for meshes, and its lists."""
    def listed(name, items):
        return f"{name} {{ {len(items)}, {', '.join(items)} }}"
    primitives = [listed("vertex_vectors", [vector(p) for p in fields["positions"]])]
    if fields["normals"]:
        primitives.append(listed("normal_vectors", [vector(n) for n in fields["normals"]]))
    primitives.append(listed("face_indices", ["<{}, {}, {}>".format(*t) for t in fields["indices"]]))
    return "mesh2", " ".join(primitives)


def shape(kind, f, share=1):
    """Returns: POV-Ray's word for a primitive, and what stands between the braces; for the share,
    see formula()."""
    if kind == "sphere":
        return kind, f"{vector(f['center'])}, {f['radius']:.9g}"
    if kind == "plane":  # POV-Ray's second argument is a distance
        return kind, f"{vector(f['normal'])}, {dot(unit(f['normal']), f['point']):.9g}"
    if kind == "disc":
        return kind, f"{vector(f['center'])}, {vector(f['normal'])}, {f['radius']:.9g}"
    if kind == "box":
        return kind, f"{vector(f['min'])}, {vector(f['max'])}"
    if kind == "cylinder":
        return kind, f"{vector(f['base'])}, {vector(f['cap'])}, {f['radius']:.9g}"
    if kind == "triangle":
        return kind, ", ".join(vector(f[name]) for name in "abc")
    if kind == "mesh":
        return mesh(f)
    if kind in FORMULAS:
        return formula(kind, f, share)
    raise CannotExpress(kind)


def to_pov(scene, aspect, share=1):
    """A whole scene file, in linear light; for the share, see formula()."""
    surfaces = primitives(scene)
    depth = scene.get("options", {}).get("max_depth", 5)
    lines = ["#version 3.7;",
             f"global_settings {{ assumed_gamma 1 max_trace_level {depth + 1} adc_bailout 0 }}",
             f"background {{ rgb {color(rgb(scene.get('background', 0)))} }}",
             camera(scene, aspect), *map(light, lights(scene))]
    names = {}
    for p in surfaces:
        look = texture(p.material)
        if look not in names:
            names[look] = f"M{len(names)}"
            lines.append(f"#declare {names[look]} = {look}")
        word, body = shape(p.kind, p.fields, share)
        interior = f"interior {{ ior {p.material['ior']:.9g} }}"
        lines.append(f"{word} {{ {body} texture {{ {names[look]} }} "
                     f"{interior if p.material['transmission'] else ''} }}")
    return "\n".join(lines) + "\n"
