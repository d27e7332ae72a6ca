# The two systems that every peer steps: initial states and parameters, those of `pelage bench`.
"""Bounded Turing model of Malheiros, Fensterseifer & Walter (2020) and Gray-Scott, nine-point stencil, torus."""

import numpy

WEIGHTS = numpy.array([[1.0, 4.0, 1.0], [4.0, -20.0, 4.0], [1.0, 4.0, 1.0]]) / 6.0

TURING = dict(name="turing", rates=(10.0, 2.0), dt=0.01, parameters=(16.0, 12.0),
              floors=(0.0, 0.0), limits=(6.0, numpy.inf))
GRAY_SCOTT = dict(name="gray-scott", rates=(0.2, 0.1), dt=1.0, parameters=(0.037, 0.06),
                  floors=(0.0, 0.0), limits=(1.0, 1.0))
SYSTEMS = {system["name"]: system for system in (TURING, GRAY_SCOTT)}


def initial(system, side, dtype):
    """Both fields of the first state, side x side."""
    random = numpy.random.default_rng(7)
    if system["name"] == "turing":
        u = numpy.full((side, side), 4.0)
        v = random.uniform(4.0, 5.0, (side, side))
    else:
        u = random.uniform(0.5, 1.0, (side, side))
        v = random.uniform(0.0, 0.4, (side, side))
    return u.astype(dtype), v.astype(dtype)
