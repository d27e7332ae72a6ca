#!/usr/bin/python3
# Times iterations of a neural reaction beside the same written for NumPy in single precision, after comparing results.
"""python3 numpy_network.py --pelage build/release/pelage [--side 128] [--hidden 128]; see --help."""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

CHEMICALS = 32  # those of the published models
FEW = 20        # iterations after which the results are compared
ALLOWED = 1e-4  # between them; the values are below 1

EXPERIMENT = """define chemicals x 32 floor none
define stencil 3x3 0.0625 0.125 0.0625 0.125 -0.75 0.125 0.0625 0.125 0.0625
define field spots blobs 82 sigma 3
use chemical x0 conc (0.145 * spots)
use chemical x1 conc (0.145 * spots)
use chemical x2 conc (0.145 * spots)
create matrix {side} {side} wrap
rule always react all neural "model.npz"
stop at {iterations}
snap at 0
"""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pelage", required=True, help="the built command")
    parser.add_argument("--side", type=int, default=128)
    parser.add_argument("--hidden", type=int, default=128)
    parser.add_argument("--iterations", type=int, default=200, help="of a turn of NumPy's; ours has ten times as many")
    parser.add_argument("--turns", type=int, default=5)
    return parser.parse_args()


class PlainPeer:
    """The formula as one writes it down first; state: rows, columns, chemicals."""

    name = "NumPy, plain"

    def __init__(self, numpy, options, weights):
        self.numpy, (self.first, self.bias, self.second) = numpy, weights
        self.rates = numpy.repeat(numpy.array([0.125, 0.25, 0.5, 1], numpy.float32), CHEMICALS // 4)

    def laplacian(self, x):
        roll = self.numpy.roll
        rows = roll(x, 1, 0) + 2 * x + roll(x, -1, 0)
        return (roll(rows, 1, 1) + 2 * rows + roll(rows, -1, 1)) / 16 - x

    def step(self, x):
        z = x @ self.first + self.bias
        x += self.rates * self.laplacian(x) + (z / (1 + self.numpy.exp(-5 * z))) @ self.second


class CarefulPeer:
    """State: rows, columns, chemicals. Every array is made once; all sums and products go to arrays that are there."""

    name = "NumPy, without a new array"

    def __init__(self, numpy, options, weights):
        self.numpy, self.side = numpy, options.side
        self.first, self.bias, self.second = weights
        cells = options.side * options.side
        self.hidden = numpy.empty((cells, options.hidden), numpy.float32)
        self.exponent = numpy.empty_like(self.hidden)
        self.flow = numpy.empty((cells, CHEMICALS), numpy.float32)
        self.padded = numpy.empty((options.side + 2, options.side + 2, CHEMICALS), numpy.float32)
        self.across = numpy.empty((options.side + 2, options.side, CHEMICALS), numpy.float32)
        self.around = numpy.empty((options.side, options.side, CHEMICALS), numpy.float32)
        self.rates = numpy.repeat(numpy.array([0.125, 0.25, 0.5, 1], numpy.float32), CHEMICALS // 4) / 16

    def step(self, state):
        numpy, padded, across, around = self.numpy, self.padded, self.across, self.around
        numpy.matmul(state.reshape(-1, CHEMICALS), self.first, out=self.hidden)
        self.hidden += self.bias
        numpy.multiply(self.hidden, numpy.float32(-5), out=self.exponent)
        numpy.exp(self.exponent, out=self.exponent)
        self.exponent += numpy.float32(1)
        self.hidden /= self.exponent
        numpy.matmul(self.hidden, self.second, out=self.flow)
        padded[1:-1, 1:-1] = state
        padded[0, 1:-1], padded[-1, 1:-1] = state[-1], state[0]
        padded[:, 0], padded[:, -1] = padded[:, -2], padded[:, 1]
        numpy.add(padded[:, :-2], padded[:, 2:], out=across)  # 1 2 1 along the row, then along the column
        across += padded[:, 1:-1]
        across += padded[:, 1:-1]
        numpy.add(across[:-2], across[2:], out=around)
        around += across[1:-1]
        around += across[1:-1]
        around *= self.rates
        around += self.flow.reshape(state.shape)
        state *= 1 - 16 * self.rates
        state += around


def grow(folder, options, iterations):
    """Seconds that `pelage run` takes for so many iterations, its start and its files included."""
    (folder / "x.pex").write_text(EXPERIMENT.format(side=options.side, iterations=iterations))
    start = time.perf_counter()
    subprocess.run([str(Path(options.pelage).resolve()), "run", "x.pex", "--out", "out", "--quiet", "--format", "npy"],
                   cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def read_state(numpy, folder, when):
    names = [folder / "out" / f"{when}.x{i}.npy" for i in range(CHEMICALS)]
    return numpy.ascontiguousarray(numpy.stack([numpy.load(name) for name in names], axis=2).astype(numpy.float32))


def drawn_weights(numpy, folder, hidden):
    """Of a network that goes downhill (W1 is -W0 turned round, and small), so that no run blows up."""
    draw = numpy.random.default_rng(1)
    first = draw.uniform(-0.3, 0.3, (CHEMICALS, hidden)).astype(numpy.float32)
    bias = draw.uniform(-0.1, 0.1, hidden).astype(numpy.float32)
    second = numpy.ascontiguousarray(numpy.float32(-0.02) * first.T)
    numpy.savez(folder / "model.npz", W0=first, b0=bias, W1=second)
    return first, bias, second


def numpy_seconds(peer, state, iterations):
    start = time.perf_counter()
    for _ in range(iterations):
        peer.step(state)
    return time.perf_counter() - start


def compare(numpy, options, folder):
    weights = drawn_weights(numpy, folder, options.hidden)
    peers = [kind(numpy, options, weights) for kind in (PlainPeer, CarefulPeer)]
    grow(folder, options, FEW)
    began, expected = read_state(numpy, folder, 0), read_state(numpy, folder, "final")
    for peer in peers:
        state = began.copy()
        numpy_seconds(peer, state, FEW)
        apart = float(numpy.abs(state - expected).max())
        if not apart < ALLOWED:
            sys.exit(f"{peer.name}: after {FEW} iterations the results are {apart:.1e} apart: they do not compute the same")
    many = 10 * options.iterations
    ours, theirs = [], {peer: [] for peer in peers}
    for _ in range(options.turns):
        ours.append((grow(folder, options, FEW + many) - grow(folder, options, FEW)) / many)
        for peer in peers:
            theirs[peer].append(numpy_seconds(peer, began.copy(), options.iterations) / options.iterations)
    print(f"pelage: {1e3 * min(ours):.3f} ms an iteration, by the best of {options.turns} turns")
    for peer in peers:
        ratio = min(theirs[peer]) / min(ours)
        print(f"{peer.name} ({numpy.__version__}): {1e3 * min(theirs[peer]):.3f} ms; pelage is {ratio:.1f} times as fast")


def main():
    options = arguments()
    try:
        import numpy
    except ImportError as error:
        print(f"left out: NumPy: {error}; Debian package python3-numpy")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        compare(numpy, options, Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
