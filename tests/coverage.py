"""llvm-cov's summary on standard input -> what was run of core/ and server/, and the files of which
too little was."""

import json
import sys

root, least = sys.argv[1], float(sys.argv[2])
sums = {}
few = []
for each in json.load(sys.stdin)["data"][0]["files"]:
    name = each["filename"].removeprefix(root + "/")
    folder = name.split("/")[0]
    if folder not in ("core", "server"):
        continue
    lines, branches = each["summary"]["lines"], each["summary"]["branches"]
    counts = [lines["covered"], lines["count"], branches["covered"], branches["count"]]
    for of in (folder, "both"):
        sums[of] = [a + b for a, b in zip(sums.get(of, [0] * 4), counts)]
    if lines["count"] and lines["percent"] < least:
        few.append((lines["percent"], lines["count"], name))

for of, (run, lines, taken, branches) in sorted(sums.items()):
    print(f"{of}: {100 * run / lines:.1f} % of {lines} lines, "
          f"{100 * taken / branches:.1f} % of {branches} branches")
print(f"below {least:g} %:")
for percent, lines, name in sorted(few):
    print(f"  {percent:5.1f} % of {lines} lines  {name}")
