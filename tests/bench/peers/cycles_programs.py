"""The two path tracers: each renders pictures of a scene and tells how long each took."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
# A million triangles are more than what Tia takes from anyone, a reference more rays.
LARGE = {"TIA_MAX_NODES": "10000000", "TIA_MAX_BODY_BYTES": str(1 << 28),
         "TIA_MAX_RAYS": str(10 ** 12), "TIA_MAX_WORK": str(10 ** 15)}


class Tia:
    """A process for each picture."""
    name = "Tia"

    def __init__(self, binary):
        self.binary = binary
        version = subprocess.run([binary, "--version"], stdout=subprocess.PIPE, text=True,
                                 check=True)
        self.version = version.stdout.strip().splitlines()[-1]

    def render(self, job, folder):
        """Returns: for each picture its seconds by the wall's clock and the processors'."""
        return [self.picture(job, each, folder) for each in job["pictures"]]

    def picture(self, job, each, folder):
        command = [self.binary, "render", job["scene"], "-o", each["file"],
                   "--width", str(job["width"]), "--height", str(job["height"]),
                   "--samples", str(each["samples"]), "--seed", str(each["seed"]),
                   "--max-depth", str(job["bounces"] + 1), "--integrator", "path",
                   "--threads", str(job["threads"])]
        start = time.perf_counter()
        # pylint: disable=consider-using-with
        process = subprocess.Popen(command, cwd=folder, env={**os.environ, **LARGE})
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{' '.join(command)} failed")
        return {"samples": each["samples"], "wall": time.perf_counter() - start,
                "cpu": used.ru_utime + used.ru_stime}


class Cycles:
    """A process for each round; it times each picture from the scene's data on."""
    name = "Cycles"

    def __init__(self, binary):
        self.binary = binary
        version = subprocess.run([binary, "--version"], stdout=subprocess.PIPE, text=True,
                                 check=True)
        self.version = version.stdout.splitlines()[0]

    def render(self, job, folder):
        report = Path(folder, "report.json")
        Path(folder, "job.json").write_text(json.dumps({**job, "report": str(report)}))
        done = subprocess.run([self.binary, "-b", "--factory-startup", "--python-exit-code", "1",
                               "--python", str(HERE / "cycles_blender.py"), "--",
                               str(Path(folder, "job.json"))], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"Blender failed: ...{done.stdout[-1500:]}")
        return json.loads(report.read_text())
