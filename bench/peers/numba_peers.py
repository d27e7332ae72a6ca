# numba, float, all threads, in several ways of writing the same step; the best one counts.
"""Each function steps both fields `steps` times and returns them."""

import numba
import numpy

f = numpy.float32


def _constants(system):
    dt = f(system["dt"])
    return (f(system["parameters"][0]), f(system["parameters"][1]), dt,
            f(system["rates"][0] * system["dt"] / 6.0), f(system["rates"][1] * system["dt"] / 6.0),
            f(system["limits"][0]), f(system["limits"][1]), system["name"] == "turing")


@numba.njit(inline="always")
def _react(turing, a, b, u, v):
    if turing:
        uv = u * v
        return a - uv, (uv - v) - b
    uvv = u * v * v
    return a * (f(1) - u) - uvv, uvv - (a + b) * v


@numba.njit(inline="always")
def _bounded(value, limit):
    return min(max(value, f(0)), limit)


def _cells(fastmath):
    """Every cell on its own, neighbours by index; edges by modulo."""
    @numba.njit(parallel=True, fastmath=fastmath, cache=False)
    def run(u, v, u2, v2, steps, a, b, dt, su, sv, lu, lv, turing):
        rows, columns = u.shape
        for _ in range(steps):
            for r in numba.prange(rows):
                up, down = (r + 1) % rows, (r - 1) % rows
                for c in range(columns):
                    left, right = (c - 1) % columns, (c + 1) % columns
                    x, y = u[r, c], v[r, c]
                    lap_x = (f(4) * (u[r, left] + u[r, right] + u[up, c] + u[down, c])
                             + (u[up, left] + u[up, right] + u[down, left] + u[down, right]) - f(20) * x)
                    lap_y = (f(4) * (v[r, left] + v[r, right] + v[up, c] + v[down, c])
                             + (v[up, left] + v[up, right] + v[down, left] + v[down, right]) - f(20) * y)
                    fx, fy = _react(turing, a, b, x, y)
                    u2[r, c] = _bounded(x + dt * fx + su * lap_x, lu)
                    v2[r, c] = _bounded(y + dt * fy + sv * lap_y, lv)
            u, u2 = u2, u
            v, v2 = v2, v
        return u, v
    return run


@numba.njit
def _fill_frame(field):
    rows, columns = field.shape[0] - 2, field.shape[1] - 2
    for c in range(1, columns + 1):
        field[0, c], field[rows + 1, c] = field[rows, c], field[1, c]
    for r in range(rows + 2):
        field[r, 0], field[r, columns + 1] = field[r, columns], field[r, 1]


def _padded(fastmath):
    """A frame of one cell around, filled once a step: the inner loop knows no edges and becomes vectors."""
    @numba.njit(parallel=True, fastmath=fastmath, cache=False)
    def run(u, v, u2, v2, steps, a, b, dt, su, sv, lu, lv, turing):
        rows, columns = u.shape[0] - 2, u.shape[1] - 2
        for _ in range(steps):
            _fill_frame(u)
            _fill_frame(v)
            for r in numba.prange(1, rows + 1):
                for c in range(1, columns + 1):
                    x, y = u[r, c], v[r, c]
                    lap_x = (f(4) * (u[r, c - 1] + u[r, c + 1] + u[r + 1, c] + u[r - 1, c])
                             + (u[r + 1, c - 1] + u[r + 1, c + 1] + u[r - 1, c - 1] + u[r - 1, c + 1]) - f(20) * x)
                    lap_y = (f(4) * (v[r, c - 1] + v[r, c + 1] + v[r + 1, c] + v[r - 1, c])
                             + (v[r + 1, c - 1] + v[r + 1, c + 1] + v[r - 1, c - 1] + v[r - 1, c + 1]) - f(20) * y)
                    fx, fy = _react(turing, a, b, x, y)
                    u2[r, c] = _bounded(x + dt * fx + su * lap_x, lu)
                    v2[r, c] = _bounded(y + dt * fy + sv * lap_y, lv)
            u, u2 = u2, u
            v, v2 = v2, v
        return u, v
    return run


def _driver(kernel, frame):
    def run(system, u, v, steps):
        if frame:
            u, v = numpy.pad(u, 1), numpy.pad(v, 1)
        u, v = kernel(u.copy(), v.copy(), numpy.empty_like(u), numpy.empty_like(v), steps, *_constants(system))
        return (u[1:-1, 1:-1], v[1:-1, 1:-1]) if frame else (u, v)
    return run


VARIANTS = {
    "numba cells": _driver(_cells(False), False),
    "numba framed": _driver(_padded(False), True),
    "numba framed, fastmath": _driver(_padded(True), True),
}
