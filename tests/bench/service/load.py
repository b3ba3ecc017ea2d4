#!/usr/bin/env -S python3 -B
"""Loads a `tia serve` of its own on this machine and prints what it did as one table.

Every run is bounded in time. wrk gives throughput, where it is installed; slowhttptest, where it is
installed, the slow attacks; the rest are plain sockets. Latencies are a client's, over keep-alive.
"""

import argparse
import http.client
import os
import re
import shutil
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SMALL = "/render?key=a&width=64&height=64"
USUAL = "/render?key=a"
HEAVY = "/render?scene=soft-shadows"
POSTER = "/render?scene=soft-shadows&width=4096&height=4096"


class Server:
    """A `tia serve` on a free port, its log in a file."""

    def __init__(self, *options):
        self.log = tempfile.TemporaryFile()
        self.process = subprocess.Popen(
            [ROOT / "build/release/tia", "serve", "--port", "0", *options],
            stdout=subprocess.PIPE, stderr=self.log, text=True)
        self.port = int(self.process.stdout.readline().rsplit(":", 1)[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        self.process.wait(20)

    def memory_mib(self):
        status = Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s+(\d+)", status)[1]) / 1024

    def connect(self):
        return http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)


def timed(connection, target, headers={}):
    """Milliseconds and status of one request."""
    start = time.perf_counter()
    connection.request("GET", target, headers=headers)
    answer = connection.getresponse()
    answer.read()
    return 1000 * (time.perf_counter() - start), answer.status


def latencies(server, target, seconds, pause=0.0):
    """Milliseconds of requests one after the other, and how many were not answered with 200."""
    connection, times, failed = server.connect(), [], 0
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        ms, status = timed(connection, target)
        times.append(ms)
        failed += status != 200
        time.sleep(pause)
    return times, failed


def p95(times):
    return statistics.quantiles(times + times[:1], n=20)[-1]


def row(what, value, target):
    print(f"| {what} | {value} | {target} |", flush=True)


def throughput(server, seconds):
    """wrk on one thread: the other processor is the server's."""
    if not shutil.which("wrk"):
        return
    for target, aim in (("/healthz", ">= 20 000"), ("/scenes", ""), (SMALL, "")):
        out = subprocess.run(
            ["wrk", "-t1", "-c32", f"-d{seconds}s", f"http://127.0.0.1:{server.port}{target}"],
            capture_output=True, text=True, check=True).stdout
        per_second = float(re.search(r"Requests/sec:\s+([\d.]+)", out)[1])
        bad = re.search(r"Non-2xx or 3xx responses: (\d+)", out)
        row(f"`{target}`, 32 connections, keep-alive", f"{per_second:,.0f} /s", aim)
        if bad:
            row("of these not 2xx", bad[1], "0")


def beside_posters(server, seconds):
    """A small picture alone, then while others render posters."""
    alone, _ = latencies(server, SMALL, seconds, 0.01)
    for posters in (1, 8):
        stop = threading.Event()

        def render():
            while not stop.is_set():
                timed(server.connect(), POSTER)

        threads = [threading.Thread(target=render, daemon=True) for _ in range(posters)]
        for thread in threads:
            thread.start()
        time.sleep(0.5)
        beside, failed = latencies(server, SMALL, 2 * seconds, 0.01)
        stop.set()
        for thread in threads:
            thread.join()
        ratio = statistics.median(beside) / statistics.median(alone)
        row(f"64x64 beside {posters} of 4096x4096, median",
            f"{statistics.median(beside):.2f} ms = {ratio:.2f} x alone", "3 x" if posters == 1 else "")
        row("the same, 95 %", f"{p95(beside):.2f} ms = {p95(beside) / p95(alone):.2f} x alone", "")
        if failed:
            row("of these failed", failed, "0")


def slow_clients(server, heads, readers, idle):
    """Half-sent heads, clients that do not read, idle ones; all held open."""
    def opened(bytes_sent, buffer=None):
        client = socket.socket()
        if buffer:
            client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, buffer)
        client.connect(("127.0.0.1", server.port))
        client.sendall(bytes_sent)
        return client

    picture = b"GET /render?width=640&height=480&format=pfm HTTP/1.1\r\nHost: x\r\n\r\n"
    return ([opened(b"GET /healthz HTTP/1.1\r\nHost: x\r\nX-A: ") for _ in range(heads // 2)]
            + [opened(b"POST /render HTTP/1.1\r\nHost: x\r\nContent-Length: 999\r\n\r\n{")
               for _ in range(heads // 2)]
            + [opened(picture, 4096) for _ in range(readers)]
            + [opened(b"GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n") for _ in range(idle)])


def cached(seconds):
    """What is asked for again: a picture, 304, and ten who ask for the same at once."""
    with Server() as server:
        connection = server.connect()
        connection.request("GET", USUAL)
        answer = connection.getresponse()
        known = {"If-None-Match": answer.headers["ETag"]}
        answer.read()
        for what, headers, status, aim in (("again", {}, 200, "1 ms"),
                                           ("If-None-Match, 304", known, 304, "0.5 ms")):
            answers = [timed(connection, USUAL, headers) for _ in range(1000 * seconds)]
            times = [ms for ms, _ in answers]
            failed = sum(code != status for _, code in answers)
            row(f"`{USUAL}` {what}, median; 95 %",
                f"{statistics.median(times):.2f}; {p95(times):.2f} ms, {failed} failed", aim)
        threads = [threading.Thread(target=timed, args=(server.connect(), HEAVY))
                   for _ in range(10)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        connection.request("GET", "/metrics")
        text = connection.getresponse().read().decode()
        drawn = int(re.search(r'tia_cache_lookups_total{result="miss"} (\d+)', text)[1]) - 1
        row("pictures drawn for ten who ask for the same at once", drawn, "1")


def beside_slow_clients(server, seconds):
    """R1-R3: another client's latencies under slow heads, slow bodies, non-readers, idle ones."""
    alone = {target: latencies(server, target, seconds)[0] for target in ("/healthz", SMALL)}
    held = slow_clients(server, 400, 100, 500)
    time.sleep(1)  # until the non-readers' pictures have been drawn
    for target, aim in (("/healthz", "5 ms"), (SMALL, "2 x")):
        times, failed = latencies(server, target, seconds)
        row(f"`{target}` beside 400 slow, 100 that do not read, 500 idle, 95 %",
            f"{p95(times):.2f} ms = {p95(times) / p95(alone[target]):.2f} x alone, {failed} failed",
            aim)
    row("memory with them", f"{server.memory_mib():.1f} MiB", "")
    for client in held:
        client.close()


def beside_attacks(server, seconds):
    """slowhttptest's four attacks, 400 connections each."""
    if not shutil.which("slowhttptest"):
        return
    url = f"http://127.0.0.1:{server.port}"
    for name, options in (("slow heads", ["-H", "-u", url + "/"]),
                          ("slow bodies", ["-B", "-u", url + "/render", "-t", "POST"]),
                          ("slow reading", ["-X", "-w", "1", "-y", "1", "-n", "1", "-z", "1",
                                            "-u", url + "/render?format=pfm"])):
        attack = subprocess.Popen(
            ["slowhttptest", *options, "-c", "400", "-r", "400", "-l", str(2 * seconds), "-i", "2"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(2)
        times, failed = latencies(server, "/healthz", seconds)
        attack.terminate()
        attack.wait()
        row(f"`/healthz` under slowhttptest's {name}, 95 %", f"{p95(times):.2f} ms, {failed} failed",
            "5 ms")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=5, help="of each measurement")
    seconds = parser.parse_args().seconds
    if not (ROOT / "build/release/tia").exists():
        sys.exit("build it first: server/run.sh, or cmake --build --preset release --target tia")
    print(f"| on {os.cpu_count()} processors | measured | aim |\n|---|---:|---:|")
    with Server("--cache-bytes", "0") as server:
        row("memory when idle", f"{server.memory_mib():.1f} MiB", "30 MiB")
        throughput(server, seconds)
        beside_posters(server, seconds)
    cached(seconds)
    with Server("--connections", "2048", "--cache-bytes", "0") as server:
        beside_slow_clients(server, seconds)
        beside_attacks(server, seconds)


if __name__ == "__main__":
    main()
