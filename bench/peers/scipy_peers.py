# NumPy and SciPy in double precision, in the style of the 2020 paper's own notebooks.
"""Each function steps both fields `steps` times and returns them."""

import numpy
from scipy import ndimage, signal

from formulas import WEIGHTS


def _flows(system, u, v):
    a, b = system["parameters"]
    if system["name"] == "turing":
        uv = u * v
        return a - uv, uv - v - b
    uvv = u * v * v
    return a * (1.0 - u) - uvv, uvv - (a + b) * v


def _step(system, laplacian, u, v):
    flow_u, flow_v = _flows(system, u, v)
    next_u = u + (flow_u + system["rates"][0] * laplacian(u)) * system["dt"]
    next_v = v + (flow_v + system["rates"][1] * laplacian(v)) * system["dt"]
    return (numpy.clip(next_u, system["floors"][0], system["limits"][0]),
            numpy.clip(next_v, system["floors"][1], system["limits"][1]))


def _run(laplacian):
    def run(system, u, v, steps):
        for _ in range(steps):
            u, v = _step(system, laplacian, u, v)
        return u, v
    return run


def _rolled(field):
    """Shifted copies: plain NumPy."""
    up, down = numpy.roll(field, 1, 0), numpy.roll(field, -1, 0)
    edges = up + down + numpy.roll(field, 1, 1) + numpy.roll(field, -1, 1)
    corners = (numpy.roll(up, 1, 1) + numpy.roll(up, -1, 1) + numpy.roll(down, 1, 1) + numpy.roll(down, -1, 1))
    return (4.0 * edges + corners - 20.0 * field) / 6.0


VARIANTS = {
    "scipy ndimage.convolve": _run(lambda field: ndimage.convolve(field, WEIGHTS, mode="wrap")),
    "scipy signal.convolve2d": _run(lambda field: signal.convolve2d(field, WEIGHTS, mode="same", boundary="wrap")),
    "numpy roll": _run(_rolled),
}
