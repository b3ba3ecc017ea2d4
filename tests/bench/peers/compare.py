#!/usr/bin/env python3
"""Traces the same scenes with Tia, POV-Ray and Tachyon and prints one table of times.

Times are those that the programs themselves give for tracing: no reading, no building of an index,
no encoding. The programs take turns, so that what slows the machine down slows all of them.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

from make_scenes import computed_scenes
from pictures import difference
from primitives import CannotExpress
from programs import THREADS, PovRay, Tachyon, Tia

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
EQUAL = 0.005  # share of pixels that may differ: edges, where rounding decides


def thesis():
    """The thesis' scene with key a pressed."""
    scene = json.loads((ROOT / "web/scenes/thesis.json").read_text())
    light = {**scene.pop("key_light"), "position": scene.pop("keys")["a"]["light"]}
    return {**scene, "lights": [light]}


def all_scenes(chosen):
    scenes = {"thesis": thesis(), **computed_scenes()}
    for path in sorted((HERE / "scenes").glob("*.json")):
        scenes[path.stem] = json.loads(path.read_text())
    return {name: scene for name, scene in scenes.items() if not chosen or name in chosen}


class Row:
    """One scene in all programs: their times, and how far the peers' pictures are from Tia's."""

    def __init__(self, name, scene, programs, size):
        self.name, self.scene, self.size = name, scene, size
        self.programs, self.notes = list(programs), []
        self.times = {program.name: [] for program in programs}
        self.differences = {}

    def measure(self, rounds):
        with tempfile.TemporaryDirectory() as folder:
            self.prepare(folder)
            for program in self.programs:
                program.render()  # a round that warms up
            for _ in range(rounds):
                for program in self.programs:
                    self.times[program.name].append(program.render())
            ours, *others = self.programs
            picture = ours.picture()
            for peer in others:
                self.differences[peer.name] = difference(peer.shown_part(picture), peer.picture())
        return self

    def prepare(self, folder):
        for program in list(self.programs):
            try:
                program.prepare(self.scene, *self.size, folder)
            except CannotExpress as missing:
                self.programs.remove(program)
                self.notes.append(f"{self.name}: {program.name} has no {missing}")

    def time(self, name):
        """The least of all rounds: whatever else the machine does only adds."""
        return min(self.times[name]) if self.times.get(name) else None

    def cells(self, peers):
        own = self.time("Tia")
        yield self.name
        yield f"{own:.3g}"
        for peer in peers:
            other = self.time(peer.name)
            if other is None:
                yield from ("", "", "")
                continue
            gap = self.differences[peer.name]
            mark = "" if gap.share < EQUAL else " (!)"
            yield f"{other:.3g}"
            yield f"{other / own:.3g}"
            yield f"{100 * gap.share:.2f} % / {gap.mean:.2f}{mark}"


def print_table(rows, peers):
    heads = ["scene", "Tia, ms"]
    for peer in peers:
        heads += [f"{peer.name}, ms", "ratio", "pixels that differ / mean, of 255"]
    print("| " + " | ".join(heads) + " |")
    print("|---|" + "---:|" * (len(heads) - 1))
    for row in rows:
        print("| " + " | ".join(row.cells(peers)) + " |")
    for note in (note for row in rows for note in row.notes):
        print(note)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tia", default=str(ROOT / "build/release/tia"), help="Tia's binary")
    parser.add_argument("--quick", action="store_true", help="640x480, three rounds")
    parser.add_argument("--rounds", type=int, help="renders of each program (9)")
    parser.add_argument("--size", help="of the pictures, as 1280x960")
    parser.add_argument("scenes", nargs="*", help="names of scenes; none: all of them")
    given = parser.parse_args()
    given.rounds = given.rounds or (3 if given.quick else 9)
    size = given.size or ("640x480" if given.quick else "1280x960")
    given.size = tuple(map(int, size.split("x")))
    return given


def main():
    given = arguments()
    peers = [PovRay(), Tachyon()]
    for peer in peers:
        if not peer.installed:
            print(f"{peer.name} is not installed (apt-get install povray tachyon)", file=sys.stderr)
    peers = [peer for peer in peers if peer.installed]
    if not peers:
        return
    tia = Tia(given.tia)
    try:
        rows = [Row(name, scene, [tia, *peers], given.size).measure(given.rounds)
                for name, scene in all_scenes(given.scenes).items()]
    finally:
        tia.close()
    print("Tracing at {}x{} with {} threads, least of {} rounds".format(
        *given.size, THREADS, given.rounds))
    print_table(rows, peers)


if __name__ == "__main__":
    main()
