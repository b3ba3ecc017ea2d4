#!/usr/bin/env -S python3 -B
"""Traces surfaces from formulas with Tia and POV-Ray 3.7 and prints one table of times and targets.

As compare.py does: times of tracing alone, by turns, the least of each counts. POV-Ray's
isosurfaces and parametric surfaces want a max_gradient: one too great wastes time, one too small
tears holes. Each has the smallest that tears none (max_gradients.json, as a share of how steep the
formula is at its steepest; --settle finds them anew). Exits with 1 where pictures differ or one
program has none, 2 where only a target is missed.
"""

import argparse
import json
import shutil
import sys
import tempfile
from pathlib import Path

from compare import EQUAL, HERE, ROOT, Row
from formulas_to_pov import ACCURACY
from make_formulas import formula_scenes
from pictures import difference
from programs import THREADS, PovRay, Tia
from scene_to_pov import to_pov

SHARES = HERE / "max_gradients.json"
TOLERANCE = 2  # of 255, in any channel
TARGETS = {"algebraic": 8, "implicit": 4, "explicit": 4, "parametric": 20}
# How shares of max_gradient are settled: by which factor they shrink, how accurate the picture for
# comparison is, and which share of the pixels may differ from it by more than TORN. Only outlines
# may: POV-Ray samples parametric surfaces up to their accuracy too wide, the wider the greater
# max_gradient, so that their picture at its steepest would not do.
STEPS = {"implicit": (2 ** -0.125, ACCURACY, 0.00005), "explicit": (2 ** -0.125, ACCURACY, 0.00005),
         "parametric": (0.5, ACCURACY / 100, 0.001)}
LEAST_SHARE, TORN = 0.01, 32


def kind_of(scene):
    """A scene of formulas has one object."""
    return scene["objects"][0]["type"]


class PovRayOfFormulas(PovRay):
    """POV-Ray with the max_gradient that was settled for each scene."""

    def __init__(self):
        super().__init__()
        self.shares = json.loads(SHARES.read_text()) if SHARES.exists() else {}
        self.accuracy = ACCURACY

    def write(self, scene, width, height):
        text = to_pov(scene, width / height, self.shares.get(scene["title"], 1))
        return text.replace(f"accuracy {ACCURACY} ", f"accuracy {self.accuracy} ")


def settled(scene, size):
    """The smallest share of the steepest whose picture has no hole, step by step."""
    pov, share = PovRayOfFormulas(), 1
    step, accuracy, holes = STEPS[kind_of(scene)]
    with tempfile.TemporaryDirectory() as folder:
        def picture(of, accurate=ACCURACY):
            pov.shares[scene["title"]], pov.accuracy = of, accurate
            pov.prepare(scene, *size, folder)
            pov.render()
            return pov.picture()
        whole = picture(1, accuracy)
        while (less := share * step) >= LEAST_SHARE:
            if difference(whole, picture(less), TORN).share > holes:
                break
            share = less
    return float(f"{share:.3g}")


def settle(scenes, size):
    """Finds the shares of scenes and keeps them."""
    shares = PovRayOfFormulas().shares
    for name, scene in scenes.items():
        if kind_of(scene) in STEPS:
            shares[name] = settled(scene, size)
            print(f"{name}: {shares[name]}", file=sys.stderr)
            SHARES.write_text(json.dumps(shares, indent=2, sort_keys=True) + "\n")


class FormulaRow(Row):
    """A row that has a target, and stands without times where a program fails."""
    missing = None

    def measure(self, rounds):
        try:
            return super().measure(rounds)
        except RuntimeError as what:
            self.missing = str(what)
            return self

    @property
    def target(self):
        return TARGETS[kind_of(self.scene)]

    @property
    def reached(self):
        return (min(self.times["POV-Ray"]) >= self.target * min(self.times["Tia"]))

    def cells(self, peers=()):
        if self.missing:
            return self.name, kind_of(self.scene), "", "", "", str(self.target), ""
        own, other = min(self.times["Tia"]), min(self.times["POV-Ray"])
        same = 100 * (1 - self.differences["POV-Ray"].share)
        return (self.name, kind_of(self.scene), f"{own:.3g}", f"{other:.3g}",
                f"{other / own:.3g} x", f"{self.target} x" + ("" if self.reached else " (!)"),
                f"{same:.2f} %" + ("" if self.equal else " (!)"))


def print_table(rows, given):
    heads = ("surface", "type", "Tia, ms", "POV-Ray, ms", "ratio", "target", "equal pixels")
    print("| " + " | ".join(heads) + " |")
    print("|---|---|" + "---:|" * (len(heads) - 2))
    for row in rows:
        print("| " + " | ".join(row.cells()) + " |")
    print("\nTracing at {}x{}, {} threads each, the least of {} rounds. Equal pixels: by no more "
          "than {} of 255 in any channel; at least {:.1f} % are to be.".format(
              *given.size, THREADS, given.rounds, TOLERANCE, 100 * (1 - EQUAL)))
    for row in rows:
        if row.missing:
            print(f"{row.name}: {row.missing.strip()[:200]}")


def arguments():
    """What the command line says."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tia", default=str(ROOT / "build/release/tia"), help="Tia's binary")
    parser.add_argument("--quick", action="store_true", help="two rounds")
    parser.add_argument("--rounds", type=int, help="renders of each program (5)")
    parser.add_argument("--size", default="640x480", help="of the pictures (640x480)")
    parser.add_argument("--settle", action="store_true", help="find POV-Ray's max_gradients")
    parser.add_argument("scenes", nargs="*", help="names of scenes; none: all of them")
    given = parser.parse_args()
    given.rounds = given.rounds or (2 if given.quick else 5)
    given.size = tuple(map(int, given.size.split("x")))
    return given


def chosen_scenes(names):
    """The scenes by name: those chosen, else all."""
    scenes = formula_scenes()
    unknown = set(names) - set(scenes)
    if unknown:
        sys.exit(f"no scene {', '.join(sorted(unknown))}; there are {', '.join(scenes)}")
    return {name: scene for name, scene in scenes.items() if not names or name in names}


def measured(scenes, given):
    tia, pov = Tia(given.tia), PovRayOfFormulas()
    try:
        return [FormulaRow(name, scene, [tia, pov], given.size, TOLERANCE).measure(given.rounds)
                for name, scene in scenes.items()]
    finally:
        tia.close()


def main():
    given = arguments()
    scenes = chosen_scenes(given.scenes)
    if not PovRayOfFormulas().installed:
        sys.exit("Nothing to compare with: apt-get install povray")
    if given.settle:
        return settle(scenes, given.size)
    if not shutil.which(given.tia):
        sys.exit(f"No program {given.tia}: build Tia first, or say --tia PATH")
    rows = measured(scenes, given)
    print_table(rows, given)
    if any(row.missing or not row.equal for row in rows):
        sys.exit(1)
    sys.exit(0 if all(row.reached for row in rows) else 2)


if __name__ == "__main__":
    main()
