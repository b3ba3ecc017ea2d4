"""Plots what a ray costs against the number of primitives: small multiples, by gnuplot."""

import re
import subprocess
from pathlib import Path

SCENES = ("spheres", "triangles")
KINDS = ("primary", "shadow", "mirror", "diffuse")
# Tracer: label and line style. Colours that colour-blind people tell apart (Okabe, Ito).
CURVES = {
    "tia": ("Tia", "lc rgb '#d55e00' lw 3 pt 7 ps 0.6"),
    "embree_packets": ("Embree, packets of 8", "lc rgb '#0072b2' lw 2 pt 5 ps 0.5"),
    "embree_single": ("Embree, single rays", "lc rgb '#56b4e9' lw 2 dt (6,4) pt 9 ps 0.6"),
}
TITLE = "What a ray costs, in ns, against the number of primitives: Tia beside Embree"
INK, GRID = "#333333", "#dddddd"

HEAD = f"""
set terminal svg size 960,600 font 'Helvetica,Arial,sans-serif,13' background '#ffffff' enhanced
set output OUTPUT
set logscale xy
set format x '10^{{%L}}'
set grid xtics ytics lc rgb '{GRID}' lt 1 lw 1
set border 3 lc rgb '{INK}' lw 1
set tics nomirror scale 0.5 textcolor rgb '{INK}'
unset mxtics
unset mytics
unset key
"""


def nice_range(values):
    """Whole steps of 1, 2, 5 around the values."""
    steps = [m * 10 ** e for e in range(7) for m in (1, 2, 5)]
    low = max((s for s in steps if s <= min(values)), default=1)
    return low, min(s for s in steps if s >= max(values))


def points(cases, scene, kind, tracer):
    """(primitives, ns) of one curve."""
    return [(case["primitives"], case["rays"][kind][tracer]["ns"]) for case in cases
            if case["kind"] == scene and tracer in case["rays"][kind]]


def panel(column, row, scene, kind, curves, names):
    """One of the multiples: its place, its data, its curves."""
    left, top, width, height = 0.075 + 0.232 * column, 0.87 - 0.465 * row, 0.205, 0.315
    yield f"set lmargin at screen {left}; set rmargin at screen {left + width}"
    yield f"set tmargin at screen {top}; set bmargin at screen {top - height}"
    yield f"set title '{kind} rays' offset 0,-0.5 textcolor rgb '{INK}'"
    yield f"set ylabel '{'ns a ray' if column == 0 else ''}' offset 1 textcolor rgb '{INK}'"
    yield f"set xlabel '{scene}' offset 0,0.4 textcolor rgb '#777777'"
    yield "set ytics format " + ("'%g'" if column == 0 else "''")
    for tracer, curve in curves.items():
        yield f"${tracer} << END"
        yield from (f"{x} {y}" for x, y in curve)
        yield "END"
    yield "plot " + ", ".join(
        f"${t} with linespoints {style} title '{label}'"
        for t, (label, style) in CURVES.items() if t in names)


def legend(names, left=0.075):
    """Samples of the lines with their names, above all panels."""
    for i, name in enumerate(names):
        text, style = CURVES[name]
        line = style.split(" pt ", maxsplit=1)[0]
        yield (f"set arrow {i + 1} from screen {left:.3f},0.95 to screen {left + 0.035:.3f},0.95 "
               f"nohead front {line}")
        yield f"set label {i + 1} '{text}' at screen {left + 0.042:.3f},0.95 textcolor rgb '{INK}'"
        left += 0.068 + 0.0075 * len(text)


def script(results, path):
    """The whole text for gnuplot."""
    cases = results["cases"]
    scenes = [s for s in SCENES if any(case["kind"] == s for case in cases)]
    names = [t for t in CURVES if t in cases[0]["rays"]["primary"]]
    everything = {(s, k, t): points(cases, s, k, t) for s in scenes for k in KINDS for t in names}
    low, high = nice_range([y for curve in everything.values() for _, y in curve])
    counts = [x for curve in everything.values() for x, _ in curve]
    yield HEAD.replace("OUTPUT", "'" + str(path).replace("'", "''") + "'")
    yield f"set xrange [{0.8 * min(counts)}:{1.25 * max(counts)}]; set yrange [{low}:{high}]"
    yield "set multiplot"
    yield from legend(names)
    yield (f"set label 9 'one thread, {results.get('machine', '')}, {results.get('date', '')}' "
           f"at screen 0.976,0.95 right font ',11' textcolor rgb '#777777'")
    for row, scene in enumerate(scenes):
        for column, kind in enumerate(KINDS):
            curves = {t: everything[scene, kind, t] for t in names}
            yield from panel(column, row, scene, kind, curves, names)
            yield "unset arrow; unset label"
    yield "unset multiplot"


def draw(results, path):
    """Writes the plot as SVG. Errors: CalledProcessError where gnuplot fails."""
    subprocess.run(["gnuplot"], input="\n".join(script(results, path)) + "\n", text=True,
                   check=True)
    text = Path(path).read_text()
    text = re.sub(r"<g [^>]*>\s*</g>\n", "", text)  # gnuplot leaves many that are empty
    text = re.sub(r"<title>.*?</title>\n\n?<desc>.*?</desc>",
                  f"<title>{TITLE}</title>", text, flags=re.S)
    Path(path).write_text(text)
