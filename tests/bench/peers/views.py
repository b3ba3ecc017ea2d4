"""The lights and the camera of a Tia scene, in words that other ray tracers share."""

import math
from dataclasses import dataclass

from primitives import CannotExpress, rgb
from vectors import cross, dot, scaled, subtract, unit


@dataclass
class WorldLight:
    """A light that shines from one point; a luminous ball where it has a radius."""
    position: tuple
    color: tuple
    radius: float


def lights(scene):
    """All of a scene's lights. To `path` colours are intensities: what they give a white matt
    surface at the origin, near which all of such a scene is, beside the light's own distance."""
    found = []
    by_path = scene.get("options", {}).get("integrator") == "path"
    for light in scene.get("lights", []):
        if light["type"] not in ("point", "sphere") or set(light) & {"fade_distance", "samples"}:
            raise CannotExpress(f"a light like {light}")
        color = scaled(rgb(light.get("color", 1)), light.get("intensity", 1))
        if by_path:
            color = scaled(color, 1 / (math.pi * dot(light["position"], light["position"])))
        found.append(WorldLight(tuple(light["position"]), color, light.get("radius", 0)))
    return found


@dataclass
class Eye:
    """A camera: unit vectors that make a right-handed basis, and half the picture's height at
    distance 1."""
    location: tuple
    direction: tuple
    right: tuple
    up: tuple
    half_height: float


def eye(scene):
    """The eye of a scene whose camera has location, look_at, up and fov_degrees."""
    camera = scene.get("camera", {})
    strange = set(camera) - {"location", "look_at", "up", "fov_degrees"}
    if strange:
        raise CannotExpress(f"camera: {', '.join(sorted(strange))}")
    location = tuple(camera.get("location", (0, 0, 0)))
    look_at = camera.get("look_at", (location[0], location[1], location[2] - 1))
    direction = unit(subtract(look_at, location))
    right = unit(cross(direction, camera.get("up", (0, 1, 0))))
    half = math.tan(math.radians(camera.get("fov_degrees", 25)) / 2)
    return Eye(location, direction, right, cross(right, direction), half)
