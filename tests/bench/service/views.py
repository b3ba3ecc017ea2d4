#!/usr/bin/env -S python3 -B
"""What quilts, panoramas and pictures for a gaze take of a processor, beside plain pictures of as
many rays, and what a live picture for a gaze takes, of a scene of 10^5 triangles.

Times of the server's threads, by turns: what else the machine does hardly matters.
"""

import argparse
import base64
import json
import math
import struct
from pathlib import Path

from load import Server

SIDE = 225  # corners of the sheet along a side: 2 x 224 x 224 triangles


def packed(kind, letter, numbers):
    return {kind: base64.b64encode(struct.pack(f"<{len(numbers)}{letter}", *numbers)).decode()}


def hills():
    """A hilly sheet that shines and throws shadows on itself, and fills the picture."""
    positions, normals, indices = [], [], []
    for j in range(SIDE):
        for i in range(SIDE):
            x, z = 14 * i / (SIDE - 1) - 7, 14 * j / (SIDE - 1) - 7
            positions += [x, 0.35 * math.sin(3 * x) * math.cos(2.5 * z), z]
            slope = [-1.05 * math.cos(3 * x) * math.cos(2.5 * z), 1,
                     0.875 * math.sin(3 * x) * math.sin(2.5 * z)]
            normals += [each / math.hypot(*slope) for each in slope]
    for j in range(SIDE - 1):
        for i in range(SIDE - 1):
            a = j * SIDE + i
            indices += [a, a + SIDE, a + 1, a + 1, a + SIDE, a + SIDE + 1]
    mesh = {"type": "mesh", "positions": packed("float32", "f", positions),
            "normals": packed("float32", "f", normals), "indices": packed("uint32", "I", indices),
            "material": {"color": [0.8, 0.6, 0.4], "specular": 0.5, "roughness": 0.02}}
    return {"objects": [mesh], "background": [0.4, 0.5, 0.7],
            "camera": {"location": [0, 3.5, 1.5], "look_at": [0, 0, 0], "fov_degrees": 60},
            "lights": [{"type": "point", "position": [3, 5, 2]}]}


class Measured(Server):
    def seconds(self):
        """Of a processor that its threads have had so far, to the nanosecond."""
        tasks = Path(f"/proc/{self.process.pid}/task").glob("*/schedstat")
        return sum(int(task.read_text().split()[0]) for task in tasks) / 1e9

    def asked(self, request):
        """Seconds of a processor that its answer takes; the answer."""
        before = self.seconds()
        connection = self.connect()
        connection.request("POST", *request)
        answer = connection.getresponse()
        answer.body = answer.read()
        connection.close()
        if answer.status not in (200, 201):
            raise SystemExit(answer.body.decode())
        return self.seconds() - before, answer

    def drawn(self, **request):
        return self.asked(("/render", json.dumps(request)))[0]


def ratio(name, rounds, target, one, other, times=1):
    """Of what `one` takes to what `other` takes so many times, by turns; both get a seed."""
    one(0), other(0)
    ones = others = 0
    for seed in range(1, rounds + 1):
        ones += one(seed)
        others += sum(other(seed * times + i) for i in range(times))
    print(f"| {name} | {ones / others:.2f} x | {target} x |", flush=True)


class Live:
    """A live picture of a scene, whose eye moves; every picture is waited for."""

    def __init__(self, server, scene):
        self.server, self.connection = server, server.connect()
        self.connection.request("GET", f"/render?scene={scene}&width=1280&height=720"
                                       "&gaze=640,360&threshold=0&samples=1&stream=mjpeg")
        self.answer = self.connection.getresponse()
        self.stream = self.part()["tia-stream"]

    def part(self):
        head = {}
        while "content-length" not in head or self.line:
            self.line = self.answer.readline().strip()
            name, _, value = self.line.decode("latin1").partition(": ")
            head[name.lower()] = value
        self.answer.read(int(head["content-length"]))
        return head

    def moved(self, number):
        gaze = [640 + 500 * math.cos(number), 360 + 300 * math.sin(0.7 * number)]
        _, answer = self.server.asked((f"/streams/{self.stream}", json.dumps({"gaze": gaze})))
        change = json.loads(answer.body)["change"]
        while int(self.part()["tia-change"]) < change:
            pass


def live(server, scene, pictures):
    stream = Live(server, scene)
    for number in range(5):
        stream.moved(number)
    before = server.seconds()
    for number in range(pictures):
        stream.moved(number)
    each = (server.seconds() - before) * 1000 / pictures
    print(f"| live, 1280x720, a gaze that moves: {each:.1f} ms of a processor a picture "
          f"| {each / (2000 / 30):.2f} x the 2 x 33 ms that there are | 1 x |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    rounds = parser.parse_args().rounds
    print("| what | measured | target |\n|---|---:|---:|")
    with Measured("--cache-bytes", "0") as server:
        scene = json.loads(server.asked(("/scenes", json.dumps(hills())))[1].body)["id"]
        plain = {"scene": scene, "threshold": 0, "samples": 1}

        def picture(width, height, **more):
            return lambda seed: server.drawn(width=width, height=height, seed=seed, **plain, **more)

        quilt = {"camera": {"display": {"type": "quilt"}}}
        ratio("a quilt of 48 views of 320x240 to 48 pictures of one", rounds, 1.1,
              picture(320, 240, **quilt), picture(320, 240), 48)
        around = {"camera": {"projection": "equirectangular", "fov_degrees": None,
                             "look_at": None, "direction": [0, -0.5, -1], "location": [0, 1, 0]}}
        flat = {"camera": {"look_at": None, "direction": [0, -0.5, -1], "location": [0, 1, 0]}}
        ratio("equirectangular, 1280x640, to perspective", rounds, 1.5,
              picture(1280, 640, **around), picture(1280, 640, **flat))
        ratio("a gaze, 1920x1080, to the full picture", 3 * rounds, 0.2,
              picture(1920, 1080, gaze=[960, 540]), picture(1920, 1080))
        live(server, scene, 20 * rounds)


if __name__ == "__main__":
    main()
