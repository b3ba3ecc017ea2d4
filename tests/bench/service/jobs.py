#!/usr/bin/env -S python3 -B
"""What jobs and a farm cost, as ratios in one run: one table. It needs redis-server for the farm."""

import argparse
import json
import shutil
import socket
import statistics
import subprocess
import tempfile
import time

from load import ROOT, SMALL, Server, latencies, p95, row, timed
from streams import user_seconds

LONG = {"kind": "render", "request": {"scene": "cornell-light", "width": 1920, "height": 1080,
                                      "samples": 4096}}


def ask(server, method, target, body=None, headers={}):
    connection = server.connect()
    connection.request(method, target, None if body is None else json.dumps(body), headers)
    answer = connection.getresponse()
    content = answer.read()
    connection.close()
    return answer, content


def submit(server, job):
    answer, body = ask(server, "POST", "/jobs", job)
    assert answer.status == 202, body
    return answer.headers["Location"]


def status(server, job):
    return json.loads(ask(server, "GET", job)[1])


def wait(server, job):
    while status(server, job)["state"] in ("queued", "running"):
        time.sleep(0.02)
    done = status(server, job)
    assert done["state"] == "done", done
    return done


def light_requests(server, seconds):
    """A small picture that nobody has drawn, alone and beside a job, by turns."""
    alone, beside = [], []
    latencies(server, SMALL + "&seed=0", 0.5)
    seeds = iter(range(1, 10**9))

    def times(many):
        connection = server.connect()
        for _ in range(many):
            yield timed(connection, f"{SMALL}&seed={next(seeds)}")[0]
            time.sleep(0.01)

    end = time.monotonic() + seconds
    while time.monotonic() < end:
        alone += times(50)
        job = submit(server, LONG)
        time.sleep(0.3)
        beside += times(50)
        ask(server, "DELETE", job)
        time.sleep(0.3)
    row("64x64 beside a job, median", f"{statistics.median(beside) / statistics.median(alone):.2f} x"
        f" alone ({statistics.median(alone):.1f} ms)", "")
    row("the same, 95 %", f"{p95(beside) / p95(alone):.2f} x alone ({p95(alone):.1f} ms)", "2 x")


def many_parts(server):
    """The answer to a job of 10 000 pictures, which differ in their seed or in where the light is."""
    seeds = {"/seed": list(range(10_000))}
    lights = {"/light": [[i % 97 / 10, 5 + i / 1000, 2] for i in range(10_000)]}
    for what, grid in (("seeds", seeds), ("lights", lights)):
        job = {"kind": "batch", "request": {"width": 16, "height": 12}, "grid": grid}
        times = []
        for _ in range(5):
            start = time.perf_counter()
            location = submit(server, job)
            times.append(1000 * (time.perf_counter() - start))
            ask(server, "DELETE", location)
        row(f"202 to 10 000 {what}, median", f"{statistics.median(times):.1f} ms", "20 ms")


def beside_render(rounds):
    """Server's user time of a picture as a job and by /render, by turns."""
    ratios = []
    with Server("--cache-bytes", "0", "--deadline-ms", "600000") as server:
        for seed in range(rounds):
            picture = {"scene": "cornell-light", "width": 640, "height": 480, "samples": 64,
                       "seed": seed}
            before = user_seconds(server)
            drawn = ask(server, "POST", "/render", picture)[1]
            between = user_seconds(server)
            job = submit(server, {"kind": "render", "request": picture})
            wait(server, job)
            ratios.append((user_seconds(server) - between) / (between - before))
            assert ask(server, "GET", job + "/result")[1] == drawn
    row("user time of a job's picture to POST /render's", f"{statistics.median(ratios):.3f} x",
        "1.05 x")


def streams(server, many):
    """Open streams of events: memory, and /healthz beside them."""
    job = submit(server, LONG)
    before = server.memory_mib()
    open_streams = []
    for _ in range(many):
        client = socket.create_connection(("127.0.0.1", server.port))
        client.sendall(f"GET {job}/events HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
        open_streams.append(client)
        client.recv(1000)
    more = server.memory_mib() - before
    times = latencies(server, "/healthz", 3)[0]
    row(f"`/healthz` beside {many} streams of events, 95 %", f"{p95(times):.2f} ms", "5 ms")
    row("memory of a stream", f"{1024 * more / many:.1f} KiB", "16 KiB")
    for client in open_streams:
        client.close()
    ask(server, "DELETE", job)


class Redis:
    def __init__(self, fsync):
        self.folder = tempfile.TemporaryDirectory()
        with socket.create_server(("127.0.0.1", 0)) as free:
            self.port = free.getsockname()[1]
        self.process = subprocess.Popen(
            ["redis-server", "--port", str(self.port), "--bind", "127.0.0.1", "--appendonly", "yes",
             "--appendfsync", fsync, "--dir", self.folder.name], stdout=subprocess.DEVNULL)
        while socket.socket().connect_ex(("127.0.0.1", self.port)) != 0:
            time.sleep(0.05)
        self.url = f"redis://127.0.0.1:{self.port}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.folder.cleanup()


class Worker(Server):
    """One thread, as the bare process that it is held to."""

    def __init__(self, redis, name):
        self.process = subprocess.Popen(
            [ROOT / "build/release/tia", "worker", "--port", "0", "--name", name, "--threads", "1",
             "--farm", redis.url], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.port = int(self.process.stdout.readline().rsplit(":", 1)[1])


def rate(server, pictures):
    """Pictures a second of a job, and the milliseconds that its parts say they took."""
    start = time.perf_counter()
    job = submit(server, {"kind": "batch", "request": pictures["request"],
                          "grid": {"/seed": list(range(pictures["from"],
                                                       pictures["from"] + pictures["many"]))}})
    wait(server, job)
    seconds = time.perf_counter() - start
    parts = json.loads(ask(server, "GET", job + "/parts")[1])["parts"]
    ask(server, "DELETE", job)
    return pictures["many"] / seconds, sum(part["ms"] for part in parts)


def bare(count, many):
    """Pictures a second of so many bare processes of one thread at once."""
    start = time.perf_counter()
    processes = [subprocess.Popen(
        [ROOT / "build/release/tia", "render", "cornell-light", "--width", "160", "--height", "120",
         "--samples", str(16 * many), "--threads", "1", "-o", "-"],
        stdout=subprocess.DEVNULL) for _ in range(count)]
    for process in processes:
        assert process.wait() == 0
    return count * many / (time.perf_counter() - start)


def part_cost(server):
    """Milliseconds that a farm takes for a part beside drawing it."""
    tiny = {"width": 8, "height": 8}
    rate(server, {"request": tiny, "from": 0, "many": 20})
    start = time.perf_counter()
    drawing_ms = rate(server, {"request": tiny, "from": 100, "many": 1000})[1]
    return (1000 * (time.perf_counter() - start) - drawing_ms) / 1000


def two_workers(redis, server, rounds, many=10):
    """What two workers are of one, and two bare processes of one, by turns; so many pictures each."""
    drawn = {"scene": "cornell-light", "width": 160, "height": 120, "samples": 16}
    workers, bares = [], []
    for i in range(rounds):
        seeds = {"request": drawn, "from": 1000 * i}
        one = rate(server, {**seeds, "many": many})[0]
        with Worker(redis, "two"):
            time.sleep(1)
            workers.append(rate(server, {**seeds, "from": 1000 * i + 500, "many": 2 * many})[0] / one)
        bares.append(bare(2, many) / bare(1, many))
    shares = [mine / theirs for mine, theirs in zip(workers, bares)]
    row("two workers to one", f"{statistics.median(workers):.2f} x, bare processes "
        f"{statistics.median(bares):.2f} x: {statistics.median(shares):.2f} of theirs",
        "0.95 of theirs")


def farm(rounds):
    if not shutil.which("redis-server"):
        return
    for fsync in ("everysec", "always"):
        with Redis(fsync) as redis, Server("--farm", redis.url) as server, \
                Worker(redis, "one") as one:
            time.sleep(1)
            if fsync == "everysec":
                row("memory of an idle worker", f"{one.memory_mib():.1f} MiB", "20 MiB")
            row(f"a part beyond its drawing, appendfsync {fsync}", f"{part_cost(server):.2f} ms",
                "3 ms" if fsync == "everysec" else "")
            if fsync == "everysec":
                two_workers(redis, server, rounds)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=10)
    seconds = parser.parse_args().seconds
    print("| what | measured | aim |\n|---|---:|---:|")
    with Server() as server:
        light_requests(server, seconds)
        many_parts(server)
        streams(server, 500)
    beside_render(5)
    farm(5)


if __name__ == "__main__":
    main()
