#!/usr/bin/env -S python3 -B
"""What it costs to stream a picture: the server's user time beside that of the plain one, by turns."""

import argparse
import os
import statistics
from pathlib import Path

from load import Server

PICTURES = {
    "Cornell box": "scene=cornell-light&width=640&height=480&samples=32",
    "room": "scene=room&width=320&height=240&samples=32",
    "small": "scene=cornell-light&width=160&height=120&samples=256",
}


def user_seconds(server):
    fields = Path(f"/proc/{server.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return int(fields[11]) / os.sysconf("SC_CLK_TCK")


def drawn(server, target):
    """User seconds that it takes, and the answer's body."""
    before = user_seconds(server)
    connection = server.connect()
    connection.request("GET", target)
    body = connection.getresponse().read()
    connection.close()
    return user_seconds(server) - before, body


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    rounds = parser.parse_args().rounds
    print("| picture | plain | streamed | ratio | pictures shown |\n|---|---:|---:|---:|---:|")
    for name, picture in PICTURES.items():
        plain, streamed, shown = [], [], []
        with Server("--deadline-ms", "600000") as server:
            drawn(server, f"/render?{picture}&seed=1")
            for seed in range(2, 2 * rounds + 2, 2):
                plain.append(drawn(server, f"/render?{picture}&seed={seed}")[0])
                seconds, body = drawn(server, f"/render?{picture}&seed={seed + 1}&stream=multipart")
                streamed.append(seconds)
                shown.append(body.count(b"Content-Type: image/png"))
        ratio = statistics.median(s / p for s, p in zip(streamed, plain))
        print(f"| {name} | {statistics.median(plain):.2f} s | {statistics.median(streamed):.2f} s "
              f"| {ratio:.3f} | {statistics.median(shown):.0f} |", flush=True)


if __name__ == "__main__":
    main()
