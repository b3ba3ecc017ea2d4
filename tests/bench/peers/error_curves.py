"""What a picture's error costs: errors against a reference, their fall with time, and the plot."""

import math
import re
import subprocess
from array import array
from dataclasses import dataclass
from pathlib import Path

TITLE = "The error of path traced pictures against the time that they took: Tia beside Cycles"
INK, GRID = "#333333", "#dddddd"
# Colours that colour-blind people tell apart (Okabe, Ito).
STYLES = {"Tia": "lc rgb '#d55e00' lw 3 pt 7 ps 0.6", "Cycles": "lc rgb '#0072b2' lw 2 pt 5 ps 0.6"}


def read_floats(path):
    """The linear light of a PFM, from the bottom row upwards."""
    magic, _, scale, floats = Path(path).read_bytes().split(b"\n", 3)
    assert magic == b"PF" and float(scale) < 0, magic  # little-endian
    return array("f", floats)


def shown(light, exposure):
    """What a display shows of it, before its curve: at most 1. exposure: in stops."""
    scale = 2 ** exposure
    return array("f", (min(1.0, scale * x) for x in light))


def mean(light):
    """Of each channel."""
    return [math.fsum(light[c::3]) / (len(light) // 3) for c in range(3)]


def rmse(light, reference):
    """The root of the mean squared difference of all pixels and channels."""
    return math.sqrt(math.fsum((a - b) ** 2 for a, b in zip(light, reference)) / len(reference))


@dataclass
class Curve:
    """Errors by the seconds that they took."""
    seconds: list
    errors: list

    @property
    def cost(self):
        """Seconds times squared error, which is the same all along where the error falls as
        chance has it: the geometric mean of the two longest pictures'."""
        last = list(zip(self.seconds, self.errors))[-2:]
        return math.exp(math.fsum(math.log(t * e * e) for t, e in last) / len(last))

    @property
    def slope(self):
        """By which power of the time the error falls, by least squares; chance: -0.5."""
        x, y = ([math.log(v) for v in each] for each in (self.seconds, self.errors))
        at, to = math.fsum(x) / len(x), math.fsum(y) / len(y)
        return (math.fsum((a - at) * (b - to) for a, b in zip(x, y)) /
                math.fsum((a - at) ** 2 for a in x))


def script(panels, path, note):
    """The text for gnuplot; panels: name -> {program: Curve}."""
    width = 0.9 / len(panels)
    yield f"""
set terminal svg size {40 + 230 * len(panels)},340 font 'Helvetica,Arial,sans-serif,13' \
background '#ffffff' enhanced
set output '{str(path).replace("'", "''")}'
set logscale xy
set format x '%g'
set grid xtics ytics lc rgb '{GRID}' lt 1 lw 1
set border 3 lc rgb '{INK}' lw 1
set tics nomirror scale 0.5 textcolor rgb '{INK}'
unset mxtics; unset mytics; unset key
set multiplot
set label 9 '{note}' at screen 0.98,0.95 right font ',11' textcolor rgb '#777777'"""
    for i, (program, style) in enumerate(STYLES.items()):
        line, left = style.split(" pt ", maxsplit=1)[0], 0.07 + 0.11 * i
        yield (f"set arrow {i + 1} from screen {left},0.95 to screen {left + 0.03},0.95 nohead "
               f"front {line}")
        yield f"set label {i + 1} '{program}' at screen {left + 0.036},0.95 textcolor rgb '{INK}'"
    for i, (name, curves) in enumerate(panels.items()):
        left = 0.07 + width * i
        yield f"set lmargin at screen {left}; set rmargin at screen {left + 0.78 * width}"
        yield "set tmargin at screen 0.8; set bmargin at screen 0.17"
        yield f"set title '{name}' offset 0,-0.5 textcolor rgb '{INK}'"
        yield "set xlabel 'seconds' offset 0,0.4 textcolor rgb '#777777'"
        yield f"set ylabel '{'error' if i == 0 else ''}' offset 1 textcolor rgb '{INK}'"
        for program, curve in curves.items():
            yield f"${program} << END"
            yield from (f"{t} {e}" for t, e in zip(curve.seconds, curve.errors))
            yield "END"
        yield "plot " + ", ".join(f"${program} with linespoints {STYLES[program]}"
                                  for program in curves)
        yield "unset arrow; unset label"
    yield "unset multiplot"


def draw(panels, path, note):
    """Writes the curves as SVG. Errors: CalledProcessError where gnuplot fails."""
    subprocess.run(["gnuplot"], input="\n".join(script(panels, path, note)) + "\n", text=True,
                   check=True)
    text = Path(path).read_text()
    text = re.sub(r"<g [^>]*>\s*</g>\n", "", text)  # gnuplot leaves many that are empty
    text = re.sub(r"<title>.*?</title>\n\n?<desc>.*?</desc>", f"<title>{TITLE}</title>", text,
                  flags=re.S)
    Path(path).write_text(text)
