#!/usr/bin/env -S python3 -B
"""Renders the same scenes with Tia's path tracer and Blender's Cycles: time to equal error.

Both draw each scene with more and more samples a pixel, by turns, with two threads, the same
bounces, pixels that are boxes, without denoiser, clamping or adaptive sampling. An error is the
root of the mean squared difference to the program's own picture of many samples, of linear light.
The time of n samples is n times that of one, from the difference of the longest and the shortest
picture, so that reading, building and starting have no part; of all rounds the least counts.
Exits with 1 where the means of the two programs' references differ by more than 1 %.
"""

import argparse
import json
import re
import shutil
import sys
import tempfile
from datetime import date
from pathlib import Path

from cycles_programs import Cycles, Tia
from cycles_scenes import SCENES
from error_curves import Curve, draw, mean, read_floats, rmse, shown

ROOT = Path(__file__).resolve().parents[3]
THREADS = 2
EQUAL = 0.01  # of the mean, in any channel
TARGET = 1.0  # of Cycles' time
DEPTH = 16  # scatterings; Cycles counts those after the first


class Case:
    """One scene: the times and the errors of both programs."""

    def __init__(self, name, given, folder):
        self.name, self.given, self.folder = name, given, folder
        scene = SCENES[name]()
        self.exposure = scene.get("options", {}).get("exposure", 0)
        path = Path(folder, f"{name}.json")
        path.write_text(json.dumps(scene))
        self.job = {"scene": str(path), "width": given.size, "height": given.size,
                    "threads": THREADS, "bounces": DEPTH - 1, "balls": given.balls}

    def file(self, program, samples):
        return str(Path(self.folder, f"{self.name}-{program.name}-{samples}.pfm"))

    def draw(self, program, samples, seed):
        pictures = [{"samples": n, "seed": seed, "file": self.file(program, n)} for n in samples]
        return program.render({**self.job, "pictures": pictures}, self.folder)

    def reference(self, program):
        """The light of the picture of many samples, which is kept with the folder."""
        file = Path(self.file(program, self.given.reference))
        if not file.exists():
            self.draw(program, [self.given.reference], seed=2)
        return read_floats(file)

    def measure(self, programs):
        """Returns: what was measured, as it is kept in the file of results."""
        rounds = {program.name: [] for program in programs}
        samples = [1, *self.given.samples]
        for _ in range(self.given.rounds):
            for program in programs:
                rounds[program.name].append(self.draw(program, samples, seed=1))
        result = {"scene": self.name}
        for program in programs:
            reference = self.reference(program)
            least = {clock: [min(one[i][clock] for one in rounds[program.name])
                             for i in range(len(samples))] for clock in ("wall", "cpu")}
            pictures = [read_floats(self.file(program, n)) for n in self.given.samples]
            cut = shown(reference, self.exposure)
            result[program.name] = {
                **least, "samples": samples, "mean": mean(reference),
                "errors": [rmse(each, reference) for each in pictures],
                "shown": [rmse(shown(each, self.exposure), cut) for each in pictures]}
        return result


def a_sample(measured, clock):
    """Seconds. Errors: where the longest picture took no longer than the shortest."""
    times, samples = measured[clock], measured["samples"]
    if times[-1] <= times[0]:
        sys.exit(f"{samples[-1]} samples are too few to be timed: {times[-1]:.3f} s, "
                 f"{times[0]:.3f} s for 1")
    return (times[-1] - times[0]) / (samples[-1] - samples[0])


def curve(measured, clock, errors):
    each = a_sample(measured, clock)
    return Curve([each * n for n in measured["samples"][1:]], measured[errors])


def gap(result):
    """How far the means are apart, of the channel that is worst."""
    return max(abs(b / a - 1) for a, b in zip(result["Tia"]["mean"], result["Cycles"]["mean"]))


def cells(result):
    """A row of the table."""
    tia, cycles = result["Tia"], result["Cycles"]
    def ratio(clock, errors):
        return curve(tia, clock, errors).cost / curve(cycles, clock, errors).cost
    main = ratio("wall", "errors")
    yield result["scene"]
    yield f"{1e3 * a_sample(tia, 'wall'):.1f}; {1e3 * a_sample(cycles, 'wall'):.1f}"
    yield f"{tia['errors'][-1]:.3g}; {cycles['errors'][-1]:.3g}"
    yield f"{main:.2f} x{'' if main <= TARGET else ' (!)'}"
    yield from (f"{ratio(*each):.2f} x" for each in
                (("cpu", "errors"), ("wall", "shown"), ("cpu", "shown")))
    yield f"{tia['wall'][-1]:.3g}; {cycles['wall'][-1]:.3g}"
    yield f"{curve(tia, 'wall', 'errors').slope:.2f}; {curve(cycles, 'wall', 'errors').slope:.2f}"
    yield f"{100 * gap(result):.2f} %{'' if gap(result) <= EQUAL else ' (!)'}"


def print_table(results):
    heads = ["scene", "ms a sample", "error at the last", "time to equal error", "CPU time",
             "as shown", "CPU time", "the last in all, s", "slope", "means differ"]
    print("| " + " | ".join(heads) + " |")
    print("|---|" + "---:|" * (len(heads) - 1))
    for result in results["cases"]:
        print("| " + " | ".join(cells(result)) + " |")
    print("\n{machine}, {date}, {versions}, {threads} threads each, {size}x{size}, {samples} "
          "samples a pixel, references of {reference}, the least of {rounds} rounds. Pairs: "
          "Tia; Cycles. As shown: exposed and cut at 1.".format(**results))


def arguments():
    """What the command line says."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tia", default=str(ROOT / "build/release/tia"), help="Tia's binary")
    parser.add_argument("--blender", default="blender", help="Blender's binary")
    parser.add_argument("--quick", action="store_true", help="128x128, fewer samples, one round")
    parser.add_argument("--size", type=int, help="of the square pictures (256)")
    parser.add_argument("--samples", help="(4,16,64,256)")
    parser.add_argument("--reference", type=int, help="its samples a pixel (4096)")
    parser.add_argument("--rounds", type=int, help="(2)")
    parser.add_argument("--balls", default="meshes", choices=("meshes", "lights"),
                        help="what luminous balls are to Cycles; lights throw no shadow (meshes)")
    parser.add_argument("--keep", help="a folder for the pictures; references in it are used again")
    parser.add_argument("--svg", help="where to draw the curves")
    parser.add_argument("--json", help="where to keep what was measured")
    parser.add_argument("--read", help="such a file, to be shown again instead of measuring")
    parser.add_argument("scenes", nargs="*", help=f"of {', '.join(SCENES)}; none: all of them")
    given = parser.parse_args()
    unknown = set(given.scenes) - set(SCENES)
    if unknown:
        sys.exit(f"no scene {', '.join(sorted(unknown))}; there are {', '.join(SCENES)}")
    given.size = given.size or (128 if given.quick else 256)
    given.samples = [int(n) for n in
                     (given.samples or ("4,16,64" if given.quick else "4,16,64,256")).split(",")]
    given.reference = given.reference or (1024 if given.quick else 4096)
    given.rounds = given.rounds or (1 if given.quick else 2)
    return given


def measured(given):
    """The results of all scenes."""
    if given.read:
        return json.loads(Path(given.read).read_text())
    if not shutil.which(given.blender):
        sys.exit("Nothing to compare with: apt-get install blender")
    if not shutil.which(given.tia):
        sys.exit(f"No program {given.tia}: build Tia first, or say --tia PATH")
    programs = [Tia(given.tia), Cycles(given.blender)]
    machine = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    results = {"machine": machine.group(1) if machine else "", "date": date.today().isoformat(),
               "versions": ", ".join(program.version for program in programs), "cases": [],
               "threads": THREADS, "size": given.size, "reference": given.reference,
               "rounds": given.rounds, "samples": ", ".join(map(str, given.samples))}
    with tempfile.TemporaryDirectory() as scratch:
        folder = given.keep or scratch
        Path(folder).mkdir(parents=True, exist_ok=True)
        for name in given.scenes or SCENES:
            case = Case(name, given, str(Path(folder).resolve()))
            results["cases"].append(case.measure(programs))
    return results


def main():
    given = arguments()
    results = measured(given)
    if given.json:
        Path(given.json).write_text(json.dumps(results, indent=1) + "\n")
    print_table(results)
    if given.svg and not shutil.which("gnuplot"):
        print("No plot without gnuplot: apt-get install gnuplot-nox")
    elif given.svg:
        panels = {case["scene"]: {name: curve(case[name], "wall", "errors")
                                  for name in ("Tia", "Cycles")} for case in results["cases"]}
        draw(panels, given.svg, f"{results['threads']} threads, {results['machine']}, "
             f"{results['date']}")
    sys.exit(0 if all(gap(case) <= EQUAL for case in results["cases"]) else 1)


if __name__ == "__main__":
    main()
