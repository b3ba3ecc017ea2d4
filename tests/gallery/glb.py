"""Writes binary glTF 2.0: what the scripts beside this one that end in a .glb are made with.

Source: Khronos, glTF 2.0 Specification (2021), chapter 3 (buffers, accessors) and 4 (GLB).
"""

import json
import struct

FLOAT, SIGNED, BYTE, SHORT, INT = 5126, 5120, 5121, 5123, 5125
ARRAY, ELEMENTS = 34962, 34963
PACKED = {FLOAT: "f", SIGNED: "b", BYTE: "B", SHORT: "H", INT: "I"}
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


def single(x):
    """The number as 32 bits hold it, none of them a negative zero."""
    return struct.unpack("<f", struct.pack("<f", round(x, 6)))[0] + 0.0


def srgb(red, green, blue):
    """Linear light of three codes from 0 to 255."""
    return [round(((c / 255 + 0.055) / 1.055) ** 2.4 if c > 10 else c / 3294.6, 4)
            for c in (red, green, blue)]


class Glb:
    """A document and its bytes. What is added is known by its number from then on."""

    def __init__(self, about):
        self.document = {"asset": {"version": "2.0", "generator": "tests/gallery of Tia",
                                   "extras": {"about": about}}}
        self.bytes = bytearray()

    def add(self, list_name, value):
        members = self.document.setdefault(list_name, [])
        members.append(value)
        return len(members) - 1

    def uses(self, extension):
        used = self.document.setdefault("extensionsUsed", [])
        if extension not in used:
            used.append(extension)
        return extension

    def view(self, data, target=None, **more):
        """A piece of the buffer, which begins at a multiple of four bytes."""
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        view = {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)} | more
        self.bytes += data
        return self.add("bufferViews", view | ({"target": target} if target else {}))

    def accessor(self, rows, component=FLOAT, target=None, bounds=False, normalized=False):
        rows = [row if isinstance(row, (list, tuple)) else (row,) for row in rows]
        if component == FLOAT:
            rows = [tuple(single(x) for x in row) for row in rows]
        data = b"".join(struct.pack(f"<{len(row)}{PACKED[component]}", *row) for row in rows)
        made = {"bufferView": self.view(data, target), "componentType": component,
                "count": len(rows), "type": KINDS[len(rows[0])]}
        if normalized:
            made["normalized"] = True
        if bounds:
            columns = list(zip(*rows))
            made |= {"min": [min(c) for c in columns], "max": [max(c) for c in columns]}
        return self.add("accessors", made)

    def vertices(self, rows, component=FLOAT, bounds=False, normalized=False):
        return self.accessor(rows, component, ARRAY, bounds, normalized)

    def short_normals(self, rows):
        """Normals of a byte a number, and one more that makes four (KHR_mesh_quantization)."""
        required = self.document.setdefault("extensionsRequired", [])
        if self.uses("KHR_mesh_quantization") not in required:
            required.append("KHR_mesh_quantization")
        data = b"".join(struct.pack("<4b", *(round(127 * x) for x in row), 0) for row in rows)
        return self.add("accessors", {
            "bufferView": self.view(data, ARRAY, byteStride=4), "componentType": SIGNED,
            "normalized": True, "count": len(rows), "type": "VEC3"})

    def indices(self, triangles):
        flat = [i for triangle in triangles for i in triangle]
        return self.accessor(flat, SHORT if max(flat) < 65535 else INT, ELEMENTS)

    def primitive(self, surface, material, short=False, **attributes):
        """Of a surface (solids.py), with further attributes by their names."""
        normals = self.short_normals if short else self.vertices
        named = {"POSITION": self.vertices(surface.points, bounds=True),
                 "NORMAL": normals(surface.normals)}
        for name, (rows, component) in attributes.items():
            named[name] = self.vertices(rows, component)
        return {"attributes": named, "indices": self.indices(surface.triangles),
                "material": material}

    def mesh(self, name, *primitives, **more):
        return self.add("meshes", {"name": name, "primitives": list(primitives)} | more)

    def node(self, name, **more):
        return self.add("nodes", {"name": name} | more)

    def material(self, name, color, metallic=0.0, roughness=0.5, extensions=(), **more):
        made = {"name": name,
                "pbrMetallicRoughness": {"baseColorFactor": [*color, 1][:4],
                                         "metallicFactor": metallic, "roughnessFactor": roughness}}
        if extensions:
            made["extensions"] = {self.uses(key): value for key, value in extensions.items()}
        return self.add("materials", made | more)

    def light(self, **light):
        """A light of KHR_lights_punctual, as what a node says of it."""
        punctual = self.uses("KHR_lights_punctual")
        lights = self.document.setdefault("extensions", {}).setdefault(punctual, {"lights": []})
        lights["lights"].append(light)
        return {punctual: {"light": len(lights["lights"]) - 1}}

    def file(self, *roots):
        """The bytes of the file, whose one scene has these nodes at its root."""
        self.add("scenes", {"nodes": list(roots)})
        self.document |= {"scene": 0, "buffers": [{"byteLength": len(self.bytes)}]}
        text = json.dumps(self.document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self.bytes) + b"\0" * (-len(self.bytes) % 4)
        whole = 12 + 8 + len(text) + 8 + len(data)
        return (struct.pack("<4sII", b"glTF", 2, whole) + struct.pack("<I4s", len(text), b"JSON") +
                text + struct.pack("<I4s", len(data), b"BIN\0") + data)
