"""How steep formulas are: what POV-Ray's `max_gradient` wants, found by sampling."""

import math
import random

SAMPLES = 20_000
CLIMBED = 12  # of the steepest samples, each followed uphill


def steepness(function, point, step):
    """The gradient's length, by central differences; 0 where the formula has no value."""
    square = 0
    for axis in range(len(point)):
        ends = []
        for way in (-step, step):
            moved = list(point)
            moved[axis] += way
            ends.append(function(*moved))
        square += ((ends[1] - ends[0]) / (2 * step)) ** 2
    return math.sqrt(square)


def climbed(measure, point, here, span, within, pick):
    """Goes uphill by random steps that shrink where they lead nowhere."""
    reach = span / 20
    while reach > span * 1e-5:
        for _ in range(8):
            there = [x + pick.uniform(-reach, reach) for x in point]
            value = measure(there) if within(there) else 0
            if value > here:
                point, here = there, value
                break
        else:
            reach /= 2
    return here


def steepest(function, low, high, within=lambda point: True):
    """The greatest steepness over a box, or what of it is `within`: of random points, then uphill
    from the steepest of them. Exact but for peaks thinner than the points lie apart."""
    pick = random.Random(1)
    span = max(h - l for l, h in zip(low, high))

    def measure(point):
        try:
            return steepness(function, point, 1e-6 * span)
        except (ValueError, ZeroDivisionError, OverflowError, TypeError):
            return 0
    points = ([pick.uniform(l, h) for l, h in zip(low, high)] for _ in range(SAMPLES))
    inside = lambda p: within(p) and all(l <= x <= h for l, x, h in zip(low, p, high))
    found = sorted(((measure(p), p) for p in points if inside(p)), reverse=True)
    return max(climbed(measure, point, here, span, inside, pick)
               for here, point in found[:CLIMBED])
