"""The scenes that Tia and Cycles both have words for: name -> Tia scene.

What differs from the gallery: the metals' board and the candles' floor are no `principled`
plastic, for Cycles has no matt ground under a layer that keeps the energy as glTF's does.
"""

import json
from pathlib import Path

from make_scenes import FLOOR, FLOOR_MATERIAL, knot_mesh

GALLERY = Path(__file__).resolve().parents[3] / "web/scenes"


def from_gallery(name):
    return json.loads((GALLERY / f"{name}.json").read_text())


def metals():
    """Thirty balls of gold, copper, silver, aluminium, iron and titanium, mirrors to matt."""
    scene = from_gallery("metals")
    scene["materials"]["wood"] = {"color": [0.32, 0.2, 0.11]}
    return scene


def candles():
    """Five hundred luminous balls."""
    scene = from_gallery("candles")
    scene["objects"][0]["material"] = {"color": [0.2, 0.16, 0.13], "specular": 0.05,
                                       "roughness": 0.0075}
    return scene


def mesh(along=5000, round_=100):
    """A knotted tube of a million flat triangles on a plane, under a window and the sky."""
    return {
        "camera": {"location": [2, 6, 14], "look_at": [0, 3, 0], "fov_degrees": 32},
        "background": [0.25, 0.3, 0.4],
        "materials": {"floor": FLOOR_MATERIAL, "jade": {"color": [0.3, 0.7, 0.5]}},
        "objects": [FLOOR, knot_mesh(along, round_, False)],
        "lights": [{"type": "quad", "corner": [-8, 11, 6], "u": [4, 0, 4], "v": [-2, 2, 2],
                    "intensity": 8}],
        "options": {"integrator": "path"},
    }


SCENES = {"cornell": lambda: from_gallery("cornell-light"), "metals": metals, "mesh": mesh,
          "candles": candles}
