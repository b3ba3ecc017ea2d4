"""The materials and the world of Tia scenes as shader nodes; for Blender's own Python."""

import math

import bpy

from primitives import CannotExpress, rgb
from vectors import scaled

# What metals reflect straight on, as core/materials/principled.cpp computes it.
METALS = {
    "gold": (0.94423, 0.7761, 0.3734), "copper": (0.92595, 0.72089, 0.50415),
    "silver": (0.962, 0.94947, 0.92212), "aluminium": (0.9123, 0.91385, 0.91968),
    "iron": (0.53123, 0.51236, 0.49583), "titanium": (0.6159, 0.58229, 0.54445),
}
# Of Cycles' metals the whitening towards the rim follows a dielectric's reflection; that of this
# index whitens as much as Schlick's does, by the cosine's mean: 1/21.
RIM_IOR = 1.346


class Nodes:
    """The shader nodes of one material or world."""

    def __init__(self, owner):
        owner.use_nodes = True
        self.tree = owner.node_tree
        self.tree.nodes.clear()

    def node(self, kind, distribution=None, **inputs):
        """A node with these inputs. Returns: its first output."""
        node = self.tree.nodes.new(kind)
        if distribution:
            node.distribution = distribution
        for name, value in inputs.items():
            socket = node.inputs[name.replace("_", " ")]
            if socket.type == "RGBA":
                value = (*rgb(value), 1)
            socket.default_value = value
        return node.outputs[0]

    def sum(self, *shaders):
        """Shaders added up; None where there are none, which is black."""
        whole = shaders[0] if shaders else None
        for each in shaders[1:]:
            node = self.tree.nodes.new("ShaderNodeAddShader")
            self.tree.links.new(whole, node.inputs[0])
            self.tree.links.new(each, node.inputs[1])
            whole = node.outputs[0]
        return whole

    def show(self, shader, kind):
        self.tree.links.new(shader, self.tree.nodes.new(kind).inputs["Surface"])


def principled(nodes, words):
    """A metal, which gets back what is lost between its facets, as Tia's does. Errors:
    CannotExpress: Cycles' other principled materials scatter otherwise."""
    known = {"type", "base_color", "metallic", "roughness"}
    if words.get("metallic", 0) != 1 or set(words) - known:
        raise CannotExpress(f"principled {words}")
    color = words.get("base_color", 1)
    return nodes.node("ShaderNodeBsdfPrincipled", "MULTI_GGX", Metallic=1,
                      Base_Color=METALS[color] if isinstance(color, str) else color,
                      Roughness=words.get("roughness", 0.5), IOR=RIM_IOR)


def finish(nodes, words):
    """Matt, with a rough mirror beside it, and luminous."""
    known = {"type", "color", "diffuse", "specular", "roughness", "emission"}
    if set(words) - known:
        raise CannotExpress(f"finish {words}")
    matt = scaled(rgb(words.get("color", 1)), words.get("diffuse", 1))
    mirror = words.get("specular", 0)
    scale = 1 / max(1, max(matt) + mirror)
    shaders = []
    if max(matt) > 0:
        shaders.append(nodes.node("ShaderNodeBsdfDiffuse", Color=scaled(matt, scale)))
    if mirror > 0:
        alpha = math.sqrt(2 / (1 / words.get("roughness", 0.05) + 2))
        shaders.append(nodes.node("ShaderNodeBsdfGlossy", "GGX", Color=mirror * scale,
                                  Roughness=math.sqrt(alpha)))
    if max(rgb(words.get("emission", 0))) > 0:
        shaders.append(nodes.node("ShaderNodeEmission", Color=words["emission"], Strength=1))
    return nodes.sum(*shaders)


def material_of(words):
    """Errors: CannotExpress."""
    material = bpy.data.materials.new("material")
    nodes = Nodes(material)
    shader = (principled(nodes, words) if words.get("type") == "principled"
              else finish(nodes, words))
    if shader:
        nodes.show(shader, "ShaderNodeOutputMaterial")
    return material


def world_of(radiance):
    """A world that sends this from everywhere."""
    world = bpy.data.worlds.new("world")
    nodes = Nodes(world)
    nodes.show(nodes.node("ShaderNodeBackground", Color=radiance, Strength=1),
               "ShaderNodeOutputWorld")
    return world
