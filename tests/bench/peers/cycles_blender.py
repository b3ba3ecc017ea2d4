"""Renders a Tia scene with Cycles; Blender's own Python runs it.

blender -b --factory-startup --python cycles_blender.py -- JOB.json, where JOB has `scene`, `width`,
`height`, `threads`, `bounces`, `balls` (luminous ones: `meshes` or `lights`), `pictures` [{samples,
seed, file}] and `report`. Writes a PFM of linear light for each picture, and into `report` the wall
clock's and the processors' seconds that each took from the scene's data to the picture.
"""

import json
import math
import os
import resource
import sys
import time
from array import array
from pathlib import Path

import bpy
from mathutils import Matrix

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.dont_write_bytecode = True

# pylint: disable=wrong-import-position
from cycles_materials import material_of, world_of  # noqa: E402
from primitives import CannotExpress, moved, placed, rgb  # noqa: E402
from triangles import Triangles, add_mesh, add_shape  # noqa: E402
from vectors import add, cross, dot, length, scaled, subtract, unit  # noqa: E402
from views import eye  # noqa: E402

# ---- things -------------------------------------------------------------------------------------

def put(data):
    """Links data into the scene. Returns: the object."""
    thing = bpy.data.objects.new("thing", data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def put_mesh(triangles, material):
    """All that wears one material is one mesh, which Embree likes best."""
    mesh, count = bpy.data.meshes.new("mesh"), len(triangles.indices) // 3
    mesh.vertices.add(len(triangles.positions) // 3)
    mesh.vertices.foreach_set("co", triangles.positions)
    mesh.loops.add(3 * count)
    mesh.loops.foreach_set("vertex_index", triangles.indices)
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", array("i", range(0, 3 * count, 3)))
    mesh.polygons.foreach_set("loop_total", array("i", [3]) * count)
    mesh.polygons.foreach_set("use_smooth", array("b", triangles.smooth))
    mesh.update(calc_edges=True)
    mesh.materials.append(material)
    put(mesh)


def put_ball(fields, emission):
    """A luminous ball as Cycles has it: a point light with a radius and, in W, its whole power. It
    is in no other light's way."""
    light = bpy.data.lights.new("ball", "POINT")
    most = max(emission)
    light.color = scaled(emission, 1 / most)
    light.shadow_soft_size = fields["radius"]
    light.energy = 4 * math.pi ** 2 * fields["radius"] ** 2 * most
    light.cycles.max_bounces = 1024
    thing = put(light)
    thing.location, thing.visible_camera = fields["center"], True


def put_objects(scene, job):
    """Objects by material, luminous balls apart where the job wants them as lights."""
    meshes = {}
    for item, words, m in placed(scene["objects"], scene.get("materials", {})):
        emission = rgb(words.get("emission", 0))
        ball = item["type"] == "sphere" and max(emission) > 0
        if ball and job["balls"] == "lights":
            put_ball(moved("sphere", item, m), emission)
            continue
        _, triangles = meshes.setdefault(json.dumps(words, sort_keys=True), (words, Triangles()))
        if item["type"] == "mesh":
            add_mesh(triangles, item, m)
        else:
            add_shape(triangles, ("luminous " if ball else "") + item["type"],
                      moved(item["type"], item, m))
    for light in scene.get("lights", []):
        if light["type"] != "quad":
            raise CannotExpress(f"a light like {light}")
        put_area(light, scene["camera"]["look_at"])
    for words, triangles in meshes.values():
        put_mesh(triangles, material_of(words))


def put_area(quad, shown):
    """A luminous rectangle as Cycles has it: an area light, which shines to one side alone, here to
    that of the point that is `shown`. Its triangles would be lights too, but give walls that they
    graze up to 14 % too little. The power is in W, by Blender's factor of 4."""
    radiance = scaled(rgb(quad.get("color", 1)), quad.get("intensity", 1))
    u, v = scaled(quad["u"], 0.5), scaled(quad["v"], 0.5)
    center = add(quad["corner"], add(u, v))
    if dot(cross(u, v), subtract(shown, center)) > 0:
        u, v = v, u
    light = bpy.data.lights.new("area", "AREA")
    light.shape, most = "RECTANGLE", max(radiance)
    light.size, light.size_y = 2 * length(u), 2 * length(v)
    light.color = scaled(radiance, 1 / most)
    light.energy = 4 * light.size * light.size_y * most
    light.cycles.max_bounces = 1024
    thing = put(light)
    behind = unit(cross(u, v))
    thing.matrix_world = matrix((unit(u), unit(v), behind, center))
    thing.visible_camera = True
    # Other light passes through it, but for what stands behind it.
    back = Triangles()
    back.add_square(add(center, scaled(behind, 1e-4 * light.size)), u, v)
    put_mesh(back, material_of({"color": 0}))


def matrix(columns):
    return Matrix([[column[row] for column in columns] for row in range(3)] + [[0, 0, 0, 1]])


def put_camera(scene, job):
    view = eye(scene)
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.angle = "VERTICAL", 2 * math.atan(view.half_height)
    data.clip_start, data.clip_end = 1e-3, 1e6
    camera = put(data)
    columns = (view.right, view.up, scaled(view.direction, -1), view.location)
    camera.matrix_world = matrix(columns)
    bpy.context.scene.camera = camera
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y = job["width"], job["height"]
    render.resolution_percentage = 100


# ---- pictures -----------------------------------------------------------------------------------

def set_up(job):
    """All that decides how Cycles samples; what is not named here is as it comes."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.threads_mode, scene.render.threads = "FIXED", job["threads"]
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.use_compositing = scene.render.use_sequencer = False
    cycles = scene.cycles
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    for kind in ("max", "diffuse", "glossy", "transmission", "transparent_max"):
        setattr(cycles, f"{kind}_bounces", job["bounces"])


def spent():
    """Seconds of the processors."""
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def write_pfm(exr, file):
    """Both have the lowest row first."""
    picture = bpy.data.images.load(exr)
    width, height = picture.size
    floats = array("f", bytes(16 * width * height))
    picture.pixels.foreach_get(floats)
    bpy.data.images.remove(picture)
    light = array("f", bytes(12 * width * height))
    for channel in range(3):
        light[channel::3] = floats[channel::4]
    Path(file).write_bytes(f"PF\n{width} {height}\n-1.0\n".encode() + light.tobytes())


def draw(picture):
    """Returns: what it took."""
    scene = bpy.context.scene
    scene.cycles.samples, scene.cycles.seed = picture["samples"], picture["seed"]
    scene.render.filepath = picture["file"] + ".exr"
    wall, processors = time.perf_counter(), spent()
    bpy.ops.render.render(write_still=True)
    wall, processors = time.perf_counter() - wall, spent() - processors
    write_pfm(scene.render.filepath, picture["file"])
    os.remove(scene.render.filepath)
    return {"samples": picture["samples"], "wall": wall, "cpu": processors}


def main():
    job = json.loads(Path(sys.argv[sys.argv.index("--") + 1]).read_text())
    scene = json.loads(Path(job["scene"]).read_text())
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    set_up(job)
    bpy.context.scene.world = world_of(scene.get("background", 0))
    put_camera(scene, job)
    put_objects(scene, job)
    Path(job["report"]).write_text(json.dumps([draw(each) for each in job["pictures"]]))


main()
