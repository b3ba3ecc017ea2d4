"""The programs that are compared: each renders a scene and tells how long tracing took, in ms."""

import http.client
import json
import re
import shutil
import subprocess
from pathlib import Path

from pictures import read_pfm, read_ppm, without_edges
from scene_to_pov import to_pov
from scene_to_tachyon import OPTIONS, to_tachyon

THREADS = 2
# Scenes of 100 000 balls are larger than what a server takes from anyone.
LARGE = ["--max-body-bytes", str(64 << 20), "--max-nodes", "10000000",
         "--max-scenes-bytes", str(1 << 30), "--cache-bytes", "0"]


def output_of(command, folder):
    """What a program prints on either stream; its last words where it fails."""
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{command[0]} failed: ...{done.stdout[-600:]}")
    return done.stdout


def ms_after(words, text):
    """What a line of a program's words says in seconds."""
    return 1000 * float(re.search(words + r".*?([0-9.]+) seconds\)?\s*$", text, re.M).group(1))


class Tia:
    """A server that keeps the scene: what it counts as tracing has no reading and no building."""
    name = "Tia"

    def __init__(self, binary):
        self.server = subprocess.Popen(
            [binary, "serve", "--port", "0", "--threads", str(THREADS), *LARGE],
            stdout=subprocess.PIPE, text=True)
        self.port = int(self.server.stdout.readline().rsplit(":", 1)[1])

    def prepare(self, scene, width, height, folder):
        """Sends the scene to the server, which needs no folder."""
        del folder
        answer, body = self.ask("POST", "/scenes", json.dumps(scene))
        if answer.status not in (200, 201):
            raise RuntimeError(body.decode())
        self.path = (f"/render?scene={json.loads(body)['id']}&width={width}&height={height}"
                     f"&threads={THREADS}")

    def render(self):
        """Returns: ms of tracing."""
        answer, body = self.ask("GET", self.path + "&format=pfm")
        if answer.status != 200:
            raise RuntimeError(body.decode())
        self.pixels, self.timing = body, answer.headers["Server-Timing"]
        return float(re.search(r"trace;dur=([0-9.]+)", self.timing).group(1))

    def picture(self):
        return read_pfm(self.pixels)

    def ask(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port)
        connection.request(method, path, body, {"Content-Type": "application/json"})
        answer = connection.getresponse()
        return answer, answer.read()

    def close(self):
        self.server.terminate()
        self.server.wait()


class Peer:
    """A program that reads a scene file and leaves a picture."""

    def __init__(self, name, binary):
        self.name, self.binary = name, shutil.which(binary)

    @property
    def installed(self):
        return self.binary is not None

    def prepare(self, scene, width, height, folder):
        """Writes the scene file. Errors: CannotExpress."""
        self.folder, self.size = folder, (width, height)
        Path(folder, self.scene_file).write_text(self.write(scene, width, height))
        self.command = self.command_for(width, height)

    def render(self):
        """Returns: ms of tracing."""
        return ms_after(self.timing, output_of(self.command, self.folder))

    def picture(self):
        return read_ppm(Path(self.folder, self.picture_file).read_bytes())

    def shown_part(self, picture):
        """The primitive of Tia's picture that this program's shows."""
        return picture


class PovRay(Peer):
    scene_file, picture_file, timing = "scene.pov", "pov-ray.ppm", r"Trace Time:"

    def __init__(self):
        super().__init__("POV-Ray", "povray")

    def write(self, scene, width, height):
        return to_pov(scene, width / height)

    def command_for(self, width, height):
        return [self.binary, f"+I{self.scene_file}", f"+O{self.picture_file}", "+FP",
                "File_Gamma=1", f"+W{width}", f"+H{height}", "-A", "-D", "-V", f"+WT{THREADS}"]


class Tachyon(Peer):
    scene_file, picture_file, timing = "scene.dat", "tachyon.ppm", r"Ray Tracing Time:"

    def __init__(self):
        super().__init__("Tachyon", "tachyon")

    def write(self, scene, width, height):
        return to_tachyon(scene, width, height)

    def command_for(self, width, height):
        return [self.binary, self.scene_file, *OPTIONS, "-numthreads", str(THREADS),
                "-format", "PPM", "-o", self.picture_file]

    def shown_part(self, picture):
        return without_edges(picture, *self.size)
