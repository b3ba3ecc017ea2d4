#!/usr/bin/env -S python3 -B
"""Traces the same rays with Tia and Embree and prints tables of speed, builds and memory.

The work is that of tia_rays (tests/bench/rays), which measures Embree where it was installed when
Tia was built. Of all rounds the least time counts, for whatever else the machine does only adds.
With --svg also plots what a ray costs against the number of primitives.
"""

import argparse
import json
import math
import os
import shutil
import subprocess
import sys
from datetime import date
from pathlib import Path

from rays_plot import draw

ROOT = Path(__file__).resolve().parents[3]
KINDS = ("primary", "shadow", "mirror", "diffuse")
DISAGREE = 1e-3  # share of rays that may: silhouettes and common edges, where rounding decides
BUILD_TARGET = 1.2  # of Embree's time
BYTES_TARGET = 150  # a triangle


def targets(scene, kind):
    """What Tia's speed should be: times that of Embree's packets, times that of its single rays."""
    return {("spheres", "primary"): (1.3, None), ("spheres", "shadow"): (1.3, None),
            ("spheres", "mirror"): (None, 1.3), ("spheres", "diffuse"): (None, 1.3)}.get(
                (scene, kind), {"primary": (1.3, None), "shadow": (1.0, None),
                                "mirror": (None, 1.0), "diffuse": (None, 1.0)}[kind])


def table(heads, rows):
    """Prints a table in markdown; the first two columns are words."""
    print("| " + " | ".join(heads) + " |")
    print("|---|---|" + "---:|" * (len(heads) - 2))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def number(value):
    """Three digits, thousands set apart."""
    if value is None:
        return ""
    digits = max(0, 2 - math.floor(math.log10(value))) if value > 0 else 0
    return f"{value:,.{digits}f}".replace(",", " ")


def ratio(value, target=None, below=False):
    """A ratio, with its target if it has one and a mark where it fails it."""
    if value is None or target is None:
        return "" if value is None else f"{value:.2f} x"
    met = value <= target if below else value >= target
    return f"{value:.2f} x ({'≤' if below else '≥'} {target}){'' if met else ' (!)'}"


def name_of(case):
    return f"{case['primitives']:,} {case['kind']}".replace(",", " ")


def ray_rows(cases):
    """A row for each scene and kind of ray."""
    for case in cases:
        for kind in KINDS:
            at = case["rays"][kind]
            row = [name_of(case), kind, number(1e3 / at["tia"]["ns"])]
            for peer, target in zip(("embree_packets", "embree_single"),
                                    targets(case["kind"], kind)):
                if peer in at:
                    row += [number(1e3 / at[peer]["ns"]),
                            ratio(at[peer]["ns"] / at["tia"]["ns"], target)]
            yield row


def build_rows(cases):
    """A row for each scene and number of threads."""
    for case in cases:
        for build in case["builds"]:
            row = [name_of(case), str(build["threads"]), number(build["tia"]["ms"])]
            if "embree" in build:
                row += [number(build["embree"]["ms"]),
                        ratio(build["tia"]["ms"] / build["embree"]["ms"], BUILD_TARGET, True)]
            large = case["kind"] != "spheres" and case["primitives"] > 10_000
            over = large and case["bytes"]["tia"] > BYTES_TARGET
            row.append(number(case["bytes"]["tia"]) + (" (!)" if over else ""))
            if "embree" in case["bytes"]:
                row.append(number(case["bytes"]["embree"]))
            yield row


def growth_rows(cases):
    """How many times more a ray costs in the largest scene of a kind than in that of 1000."""
    for scene in dict.fromkeys(case["kind"] for case in cases):
        same = [case for case in cases if case["kind"] == scene and case["primitives"] >= 1000]
        if len(same) < 2:
            continue
        first, last = same[0], same[-1]
        for kind in KINDS:
            yield [f"{name_of(first)} to {last['primitives']:,}".replace(",", " "), kind] + [
                ratio(at["ns"] / first["rays"][kind][tracer]["ns"])
                for tracer, at in last["rays"][kind].items() if tracer != "rays"]


def print_tables(cases):
    """Speed, builds and memory, growth."""
    peers = ["Embree packets", "ratio", "Embree single", "ratio"]
    beside = "embree" in cases[0]["bytes"]
    print("Mray/s of one thread, in its processor's time; ratios are Tia's speed to Embree's:\n")
    table(["scene", "rays", "Tia"] + (peers if beside else []), ray_rows(cases))
    print("Builds and the bytes that stay, positions and indices among them:\n")
    table(["scene", "threads", "Tia, ms"] + (["Embree, ms", "ratio"] if beside else []) +
          ["Tia, bytes a primitive"] + (["Embree, bytes"] if beside else []), build_rows(cases))
    growth = list(growth_rows(cases))
    if growth:
        print("How much more a ray costs in the larger scene:\n")
        table(["scenes", "rays", "Tia"] + (peers[::2] if beside else []), growth)


def worst_disagreement(cases):
    """The largest share of a set of rays on which Embree's answers are not Tia's."""
    return max((at["differ"] for case in cases for kind in KINDS
                for at in case["rays"][kind].values() if isinstance(at, dict)), default=0)


def processor():
    """The machine's, as it calls itself."""
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(": ", 1)[1]
    return "an unknown processor"


def arguments():
    """What the command line says."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/tests/tia_rays"))
    parser.add_argument("--quick", action="store_true", help="smaller scenes, three rounds")
    parser.add_argument("--rounds", type=int, help="(7)")
    parser.add_argument("--kinds", help="of scenes, of spheres,triangles,tubes")
    parser.add_argument("--sizes", help="of the scenes, in primitives, instead of each kind's own")
    parser.add_argument("--svg", help="where to draw the plot")
    parser.add_argument("--json", help="where to keep what was measured")
    parser.add_argument("--read", help="such a file, to be shown again instead of measuring")
    return parser.parse_args()


def measured(given):
    """What tia_rays has written, with the machine and the day."""
    if given.read:
        return json.loads(Path(given.read).read_text())
    if not shutil.which(given.program):
        sys.exit(f"No program {given.program}: build tia_rays first, or say --program PATH")
    threads = "1,2" if (os.cpu_count() or 1) > 1 else "1"
    rounds = given.rounds or (3 if given.quick else 7)
    command = [given.program, "--rounds", str(rounds), "--threads", threads]
    sizes = given.sizes or ("1000,20000" if given.quick else None)
    command += ["--sizes", sizes] if sizes else []
    command += ["--kinds", given.kinds] if given.kinds else []
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return {"machine": processor(), "date": date.today().isoformat(), **json.loads(done.stdout)}


def main():
    given = arguments()
    results = measured(given)
    if given.json:
        Path(given.json).write_text(json.dumps(results, indent=1) + "\n")
    cases = results["cases"]
    print(f"Rays on {results['machine']}, {results['date']}, the least of {results['rounds']} "
          f"rounds; Embree's instruction set: {results['isa'] or 'its own choice'}. "
          "(!): short of its target.\n")
    print_tables(cases)
    if "embree" not in cases[0]["bytes"]:
        print("Embree was not there when tia_rays was built: apt-get install libembree-dev")
    if given.svg and not shutil.which("gnuplot"):
        print("No plot without gnuplot: apt-get install gnuplot-nox")
    elif given.svg:
        draw(results, given.svg)
    worst = worst_disagreement(cases)
    print(f"At most {100 * worst:.2g} % of the rays of a kind have another answer than Tia's.")
    sys.exit(0 if worst < DISAGREE else 1)


if __name__ == "__main__":
    main()
