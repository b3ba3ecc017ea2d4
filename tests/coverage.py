"""llvm-cov's summary on standard input -> what was run of core/ and server/, and the files of which
too little was. Fails where a folder has less than its share of lines."""

import json
import sys

LEAST = {"core": 98, "server": 95}  # percent of lines
FEW = 85  # of a file: it is named

root = sys.argv[1]
sums = {}
few = []
for each in json.load(sys.stdin)["data"][0]["files"]:
    name = each["filename"].removeprefix(root + "/")
    folder = name.split("/")[0]
    if folder not in LEAST:
        continue
    lines, branches = each["summary"]["lines"], each["summary"]["branches"]
    counts = [lines["covered"], lines["count"], branches["covered"], branches["count"]]
    sums[folder] = [a + b for a, b in zip(sums.get(folder, [0] * 4), counts)]
    if lines["count"] and lines["percent"] < FEW:
        few.append((lines["percent"], lines["count"], name))

for folder, (run, lines, taken, branches) in sorted(sums.items()):
    print(f"{folder}: {100 * run / lines:.1f} % of {lines} lines, "
          f"{100 * taken / branches:.1f} % of {branches} branches")
for percent, lines, name in sorted(few):
    print(f"  {percent:5.1f} % of {lines} lines  {name}")
sys.exit(any(100 * sums[each][0] < least * sums[each][1] for each, least in LEAST.items()))
