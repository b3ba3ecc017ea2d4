#!/usr/bin/env python3
"""Writes web/models/chess.glb: a set of chess men in the last position of the Immortal Game.

Anderssen - Kieseritzky, London 1851, 23. Be7 mate. Men and squares are instances
(EXT_mesh_gpu_instancing), their lacquer is a clearcoat, the men's normals are bytes. A square is
5 cm wide; white is at +z.
"""

import sys
from math import cos, pi, sin

from glb import FLOAT, Glb, srgb
from solids import Surface, arc, ball, box, drawn, edges, spline, turned

SQUARE = 0.05
POSITION = "r1bk3r/p2pBpNp/n4n2/1p1NP2P/6P1/3P4/P1P1K3/q5b1"
NAMES = {"k": "king", "q": "queen", "r": "rook", "b": "bishop", "n": "knight", "p": "pawn"}


def foot(radius):
    """What every man stands on, up to where it is 0.4 as wide."""
    r = radius
    return [[(0, 0), (r * 0.92, 0)], arc((r * 0.86, r * 0.14), r * 0.14, -pi / 2, pi / 2, 4),
            [(r * 0.86, r * 0.28), (r * 0.8, r * 0.34)],
            spline([(r * 0.8, r * 0.34), (r * 0.74, r * 0.5), (r * 0.52, r * 0.8)], 3)]


def collar(radius, y, height):
    """A disc with a round rim."""
    inner = radius - height / 2
    return [[(0, y), (inner, y)], arc((inner, y + height / 2), height / 2, -pi / 2, pi / 2, 3),
            [(inner, y + height), (0, y + height)]]


def stem(radius, low, high, top):
    """From the foot to a waist, and out again to the collar."""
    return [spline([(radius * 0.52, low), (radius * 0.4, low + (high - low) * 0.4),
                    (top * 0.94, low + (high - low) * 0.8), (top, high)], 3)]


def pawn():
    r = 0.0155
    head = arc((0, 0.0385), 0.0085, -1.0, pi / 2, 10)
    return turned(*foot(r), *stem(r, r * 0.8, 0.029, 0.0055), *collar(0.0098, 0.029, 0.0024),
                  [*head[:-1], (0, head[-1][1])], around=24)


def rook():
    r = 0.0175
    body = turned(*foot(r), *stem(r, r * 0.8, 0.036, 0.0088), *collar(0.0128, 0.036, 0.0028),
                  *edges((0.0104, 0.0388), (0.0122, 0.043), (0.0122, 0.046), (0.0085, 0.046),
                         (0.0085, 0.0425), (0, 0.0425)), around=24)
    block = box((0.0083, 0.0455, -0.0032), (0.0122, 0.0495, 0.0032), 0.0004)
    for k in range(6):
        body += block.moved(turn=k * pi / 3)
    return body


def bishop():
    r = 0.017
    mitre = spline([(0.0046, 0.0466), (0.0084, 0.052), (0.0072, 0.058), (0.003, 0.0648),
                    (0.0016, 0.0662)], 4)
    return turned(*foot(r), *stem(r, r * 0.8, 0.0425, 0.0054), *collar(0.0104, 0.0425, 0.0022),
                  *collar(0.0078, 0.0447, 0.0019), mitre, around=24) + ball((0, 0.068, 0), 0.0026)


def queen():
    r = 0.019
    crown = [spline([(0.0062, 0.0585), (0.0074, 0.065), (0.0116, 0.0725)], 4),
             *edges((0.0116, 0.0725), (0.0102, 0.0735)),
             spline([(0.0102, 0.0735), (0.006, 0.0755), (0.0014, 0.0768)], 3)]
    body = turned(*foot(r), *stem(r, r * 0.8, 0.053, 0.0062), *collar(0.0122, 0.053, 0.003),
                  *collar(0.0092, 0.056, 0.0025), *crown, around=24)
    for k in range(10):
        angle = 2 * pi * k / 10
        body += ball((0.0109 * cos(angle), 0.0734, 0.0109 * sin(angle)), 0.002, 5, 8)
    return body + ball((0, 0.079, 0), 0.003)


def king():
    r = 0.0195
    crown = [spline([(0.0066, 0.0635), (0.0078, 0.07), (0.0112, 0.0785)], 4),
             *edges((0.0112, 0.0785), (0.0104, 0.0797)),
             spline([(0.0104, 0.0797), (0.0062, 0.0822), (0.002, 0.083)], 3)]
    body = turned(*foot(r), *stem(r, r * 0.8, 0.058, 0.0064), *collar(0.0126, 0.058, 0.003),
                  *collar(0.0096, 0.061, 0.0025), *crown, around=24)
    cross = (box((-0.0015, 0.082, -0.0013), (0.0015, 0.0945, 0.0013), 0.0004) +
             box((-0.0043, 0.0868, -0.0013), (0.0043, 0.0898, 0.0013), 0.0004))
    return body + cross


def sideways(curve, radii, around=12):
    """A tube in the plane x = 0: its radii are those in that plane and across it."""
    frames = []
    for k, _ in enumerate(curve):
        (_, y0, z0), (_, y1, z1) = curve[max(k - 1, 0)], curve[min(k + 1, len(curve) - 1)]
        length = ((y1 - y0) ** 2 + (z1 - z0) ** 2) ** 0.5
        frames.append(((0, (z0 - z1) / length, (y1 - y0) / length), (1, 0, 0)))
    return drawn(curve, radii, around, frames)


def through(rows, steps=4):
    """A tube through rows of y, z, radius and radius across."""
    fine = spline(rows, steps)
    return sideways([(0, y, z) for y, z, _, _ in fine], [(a, b) for _, _, a, b in fine])


def knight():
    """It looks towards -z."""
    r = 0.0175
    plinth = turned(*foot(r), *collar(0.0118, r * 0.8, 0.0028), around=24)
    neck = through([(0.0155, 0.0015, 0.0098, 0.0085), (0.025, 0.0042, 0.0092, 0.0066),
                    (0.036, 0.0048, 0.0078, 0.0054), (0.045, 0.0018, 0.0066, 0.0048),
                    (0.0505, -0.0025, 0.0048, 0.0042), (0.052, -0.0052, 0.0026, 0.0026)])
    head = through([(0.051, 0.0035, 0.0026, 0.003), (0.0495, 0.0002, 0.0058, 0.005),
                    (0.046, -0.0058, 0.0054, 0.0049), (0.0412, -0.0112, 0.0039, 0.0036),
                    (0.0374, -0.0152, 0.0038, 0.0034), (0.0358, -0.017, 0.0026, 0.0024)])
    mane = through([(0.0195, 0.0122, 0.0016, 0.0013), (0.031, 0.0132, 0.0026, 0.0016),
                    (0.0425, 0.0102, 0.003, 0.0018), (0.051, 0.0042, 0.0027, 0.0017),
                    (0.0545, -0.0025, 0.0015, 0.0012)], 4)
    made = plinth + neck + head + mane
    for side in (-1, 1):
        ear = drawn([(side * 0.0024, 0.0505, -0.001), (side * 0.0029, 0.0545, -0.0016),
                     (side * 0.0031, 0.0582, -0.0026)], [0.0021, 0.0017, 0.0002], 8)
        made += ear + ball((side * 0.0042, 0.0472, -0.0062), 0.0011, 6, 8)
    return made


MEN = {"pawn": pawn, "rook": rook, "knight": knight, "bishop": bishop, "queen": queen, "king": king}


def placed(rank, file):
    return ((file - 3.5) * SQUARE, 0.0, (rank - 3.5) * SQUARE)


def men_on_board():
    """Places by colour and man."""
    found = {}
    for rank, row in enumerate(POSITION.split("/")):
        file = 0
        for letter in row:
            if letter.isdigit():
                file += int(letter)
                continue
            color = "black" if letter.islower() else "white"
            found.setdefault((color, NAMES[letter.lower()]), []).append(placed(rank, file))
            file += 1
    return found


def instanced(glb, name, mesh, places, turns):
    rotations = [(0.0, sin(t / 2), 0.0, cos(t / 2)) for t in turns]
    attributes = {"TRANSLATION": glb.accessor(places), "ROTATION": glb.accessor(rotations, FLOAT)}
    key = glb.uses("EXT_mesh_gpu_instancing")
    return glb.node(name, mesh=mesh, extensions={key: {"attributes": attributes}})


def lacquered(glb, name, color, roughness, coat):
    """Wood under a clear lacquer."""
    layer = {"clearcoatFactor": 1.0, "clearcoatRoughnessFactor": coat}
    return glb.material(name, srgb(*color), 0.0, roughness, {"KHR_materials_clearcoat": layer})


def frame():
    half, rim, deep = 4 * SQUARE, 0.024, 0.016
    low, high = -half - rim, half + rim
    sides = Surface()
    for k in range(4):
        side = box((low, -deep, half + 0.0004), (high, 0.0015, high), 0.002)
        sides += side.moved(turn=k * pi / 2)
    return sides


def board(glb):
    """Nodes of the frame and of the squares of either colour."""
    walnut = lacquered(glb, "walnut", (84, 46, 26), 0.45, 0.08)
    maple = lacquered(glb, "maple", (222, 184, 134), 0.4, 0.05)
    rosewood = lacquered(glb, "rosewood", (70, 32, 20), 0.4, 0.05)
    half = SQUARE / 2
    square = box((-half, -0.012, -half), (half, 0, half), 0.0006)
    nodes = [glb.node("frame", mesh=glb.mesh("frame", glb.primitive(frame(), walnut)))]
    for name, wood, parity in (("light squares", maple, 0), ("dark squares", rosewood, 1)):
        places = [placed(i, j) for i in range(8) for j in range(8) if (i + j) % 2 == parity]
        mesh = glb.mesh(name, glb.primitive(square, wood))
        nodes.append(instanced(glb, name, mesh, places, [0.0] * len(places)))
    return nodes


def men(glb):
    """Nodes of the men. Both colours share a man's points."""
    woods = {"white": lacquered(glb, "boxwood", (238, 212, 164), 0.5, 0.06),
             "black": lacquered(glb, "ebony", (38, 26, 22), 0.45, 0.04)}
    shapes, nodes = {}, []
    for (color, man), places in sorted(men_on_board().items()):
        if man not in shapes:
            shapes[man] = glb.primitive(MEN[man](), woods[color], short=True)
        mesh = glb.mesh(f"{color} {man}", shapes[man] | {"material": woods[color]})
        ahead = 0.0 if color == "white" else pi
        turns = [ahead + 0.25 * (k % 3 - 1) for k in range(len(places))]
        nodes.append(instanced(glb, f"{color} {man}", mesh, places, turns))
    return nodes


def eye(glb):
    """Over white's left shoulder."""
    lens = {"yfov": 0.5, "znear": 0.01, "aspectRatio": 4 / 3}
    camera = glb.add("cameras", {"name": "white", "type": "perspective", "perspective": lens})
    left, down = -0.4, -0.5
    (x, w), (y, v) = ((sin(angle / 2), cos(angle / 2)) for angle in (down, left))
    turn = (v * x, y * w, -y * x, v * w)  # about y, after about x
    return glb.node("eye", camera=camera, translation=[-0.33, 0.46, 0.76],
                    rotation=[round(c, 6) for c in turn])


def main():
    glb = Glb("The Immortal Game, London 1851: mate")
    sys.stdout.buffer.write(glb.file(*board(glb), *men(glb), eye(glb)))


if __name__ == "__main__":
    main()
