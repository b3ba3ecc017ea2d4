#!/usr/bin/env -S python3 -B
"""Traces the same scenes with Tia, POV-Ray and Tachyon and prints one table of times.

Times are those that the programs themselves give for tracing: no reading, no building of an index,
no encoding. The programs take turns, so that what slows the machine down slows all of them, and
the least time of each counts, for whatever else the machine does only adds. Exits with 1 where a
picture differs from Tia's by more than its edges.
"""

import argparse
import json
import shutil
import sys
import tempfile
from pathlib import Path

from make_scenes import computed_scenes
from pictures import difference
from primitives import CannotExpress
from programs import THREADS, PovRay, Tachyon, Tia

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
TOLERANCE = 3  # of 255, in any channel
EQUAL = 0.005  # share of pixels that may differ by more: edges, where rounding decides


def thesis():
    """The thesis' scene with key a pressed."""
    scene = json.loads((ROOT / "web/scenes/thesis.json").read_text())
    light = {**scene.pop("key_light"), "position": scene.pop("keys")["a"]["light"]}
    return {**scene, "lights": [light]}


def all_scenes(chosen):
    """The scenes by name: those chosen, else all."""
    scenes = {"thesis": thesis(), **computed_scenes()}
    for path in sorted((HERE / "scenes").glob("*.json")):
        scenes[path.stem] = json.loads(path.read_text())
    unknown = set(chosen) - set(scenes)
    if unknown:
        sys.exit(f"no scene {', '.join(sorted(unknown))}; there are {', '.join(scenes)}")
    return {name: scene for name, scene in scenes.items() if not chosen or name in chosen}


class Row:
    """One scene in all programs: their times, and how far the peers' pictures are from Tia's."""

    def __init__(self, name, scene, programs, size, tolerance=TOLERANCE):
        self.name, self.scene, self.size, self.tolerance = name, scene, size, tolerance
        self.programs, self.notes = list(programs), []
        self.times, self.differences = {}, {}

    def measure(self, rounds):
        """Renders the scene in turns, then compares the pictures."""
        with tempfile.TemporaryDirectory() as folder:
            self.prepare(folder)
            for program in self.programs:
                program.render()  # warms up
                self.times[program.name] = []
            for _ in range(rounds):
                for program in self.programs:
                    self.times[program.name].append(program.render())
            ours, *peers = self.programs
            picture = ours.picture()
            for peer in peers:
                self.differences[peer.name] = difference(peer.shown_part(picture), peer.picture(),
                                                         self.tolerance)
        return self

    def prepare(self, folder):
        """Leaves out the programs that have no words for the scene."""
        for program in list(self.programs):
            try:
                program.prepare(self.scene, *self.size, folder)
            except CannotExpress as what:
                self.programs.remove(program)
                self.notes.append(f"{self.name}: not in {program.name} ({what})")

    @property
    def equal(self):
        """Whether all pictures are the same but for edges."""
        return all(each.share < EQUAL for each in self.differences.values())

    def cells(self, peers):
        """The row's texts: Tia's time, each peer's, its ratio, its picture's difference."""
        own = min(self.times["Tia"])
        yield from (self.name, f"{own:.3g}")
        for peer in peers:
            if peer.name not in self.times:
                yield from ("", "", "")
                continue
            other, gap = min(self.times[peer.name]), self.differences[peer.name]
            mark = "" if gap.share < EQUAL else " (!)"
            yield from (f"{other:.3g}", f"{other / own:.3g} x",
                        f"{100 * gap.share:.2f} %, {gap.mean:.2f}{mark}")


def print_table(rows, peers, given):
    """The table in markdown, and what is to be said about it."""
    heads = ["scene", "Tia, ms"]
    for peer in peers:
        heads += [f"{peer.name}, ms", "ratio", "pixels that differ, mean"]
    print("| " + " | ".join(heads) + " |")
    print("|---|" + "---:|" * (len(heads) - 1))
    for row in rows:
        print("| " + " | ".join(row.cells(peers)) + " |")
    print("\nTracing at {}x{}, {} threads each, the least of {} rounds. Pixels that differ: by "
          "more than {} of 255 in a channel; mean: over all codes.".format(
              *given.size, THREADS, given.rounds, TOLERANCE))
    print(*(note for row in rows for note in row.notes), sep="\n")


def arguments():
    """What the command line says."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tia", default=str(ROOT / "build/release/tia"), help="Tia's binary")
    parser.add_argument("--quick", action="store_true", help="640x480, three rounds")
    parser.add_argument("--rounds", type=int, help="renders of each program (9)")
    parser.add_argument("--size", help="of the pictures (1280x960)")
    parser.add_argument("scenes", nargs="*", help="names of scenes; none: all of them")
    given = parser.parse_args()
    given.rounds = given.rounds or (3 if given.quick else 9)
    size = given.size or ("640x480" if given.quick else "1280x960")
    given.size = tuple(map(int, size.split("x")))
    return given


def installed_peers():
    """The peers that are there; says which are not."""
    peers = [PovRay(), Tachyon()]
    for peer in peers:
        if not peer.installed:
            print(f"{peer.name} is not installed: it takes no primitive.", file=sys.stderr)
    return [peer for peer in peers if peer.installed]


def main():
    given = arguments()
    peers = installed_peers()
    if not peers:
        sys.exit("Nothing to compare with: apt-get install povray tachyon")
    if not shutil.which(given.tia):
        sys.exit(f"No program {given.tia}: build Tia first, or say --tia PATH")
    tia = Tia(given.tia)
    try:
        rows = [Row(name, scene, [tia, *peers], given.size).measure(given.rounds)
                for name, scene in all_scenes(given.scenes).items()]
    finally:
        tia.close()
    print_table(rows, peers, given)
    sys.exit(0 if all(row.equal for row in rows) else 1)


if __name__ == "__main__":
    main()
