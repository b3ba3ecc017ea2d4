#!/usr/bin/env python3
"""What a larger first round of an adaptive picture costs and gives: pixels that are off by more than
16 of 255 from 600 rays a pixel. A minute.
"""
import argparse
import array
import re
import subprocess
import sys
import urllib.request
from pathlib import Path

TIA = Path(__file__).resolve().parents[2] / "build" / "release" / "tia"
SCENES = {"thesis": "scene=thesis&key=a", "shapes": "scene=shapes", "whitted": "scene=whitted",
          "mirrors": "scene=mirrors"}
SIZE = (320, 240)


def picture(base, query):
    """Linear floats, and how many rays the eye has sent."""
    url = f"{base}/render?width={SIZE[0]}&height={SIZE[1]}&format=pfm&{query}"
    with urllib.request.urlopen(url) as answer:
        values = array.array("f", answer.read().split(b"\n-1.0\n", 1)[1])
        return values, int(re.search(r"primary=(\d+)", answer.headers["Tia-Rays"])[1])


def code(linear):
    linear = min(max(linear, 0.0), 1.0)
    return 255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055)


def measure(base, counts):
    for name, scene in SCENES.items():
        wanted = [code(value) for value in picture(base, f"{scene}&samples=600")[0]]
        for count in counts:
            values, rays = picture(base, f"{scene}&samples={count}&threshold=0.02")
            off = [abs(code(value) - right) for value, right in zip(values, wanted)]
            beads = sum(max(off[i:i + 3]) > 16 for i in range(0, len(off), 3))
            print(f"| {name} | {count} | {rays / (SIZE[0] * SIZE[1]):.1f} | {beads} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("samples", nargs="*", type=int, default=[4, 8, 16],
                        help="of the first round (4 8 16)")
    samples = parser.parse_args().samples
    if not TIA.exists():
        sys.exit("build it first: server/run.sh, or cmake --build --preset release --target tia")
    # However little of the processors is left for the 600 rays.
    server = subprocess.Popen([TIA, "serve", "--port", "0", "--deadline-ms", "3600000"],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        base = re.search(r"http://\S+", server.stdout.readline())[0]
        measure(base, samples)
    finally:
        server.terminate()


if __name__ == "__main__":
    main()
