"""Reads pictures and tells how much two of them differ."""

from array import array
from dataclasses import dataclass


@dataclass
class Difference:
    """`share` of the pixels differ by more than a tolerance; codes differ by `mean` on average."""
    share: float
    mean: float


def read_ppm(data):
    """The codes of a binary PPM of 8 bits, from the top."""
    fields, at = [], 0
    while len(fields) < 4:
        end = data.index(b"\n", at)
        line = data[at:end].split(b"#")[0]
        fields += line.split()
        at = end + 1
    assert fields[0] == b"P6" and fields[3] == b"255", fields
    return data[at:]


def read_pfm(data):
    """8-bit linear codes of a PFM, whose rows go from the bottom upwards."""
    magic, size, scale, floats = data.split(b"\n", 3)
    assert magic == b"PF" and float(scale) < 0, magic  # little-endian
    width, height = map(int, size.split())
    values = array("f", floats)
    codes = bytes(min(255, max(0, int(255 * v + 0.5))) for v in values)
    row = 3 * width
    return b"".join(codes[y * row:(y + 1) * row] for y in reversed(range(height)))


def without_edges(codes, width, height):
    """A picture without its first column and its last row."""
    row = 3 * width
    return b"".join(codes[y * row + 3:(y + 1) * row] for y in range(height - 1))


def difference(a, b, tolerance):
    """Compares two pictures of the same size, code by code."""
    assert len(a) == len(b), (len(a), len(b))
    gaps = bytes(abs(x - y) for x, y in zip(a, b))
    far = sum(max(gaps[i:i + 3]) > tolerance for i in range(0, len(gaps), 3))
    return Difference(3 * far / len(gaps), sum(gaps) / len(gaps))
