#!/usr/bin/python3
# Times a step of `pelage learn` beside the same step written for PyTorch, on the same machine, turn by turn.
"""python3 torch_learning.py --pelage build/release/pelage [--size 64] [--chemicals 32] [--hidden 128] ...; see --help."""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PATCH, DIRECTIONS, LEVELS = 7, 32, 3


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pelage", required=True, help="the built command")
    parser.add_argument("--picture", default=str(Path(__file__).parents[2] / "docs/gallery/giraffe.png"))
    parser.add_argument("--size", type=int, default=64)
    parser.add_argument("--chemicals", type=int, default=32)
    parser.add_argument("--hidden", type=int, default=128)
    parser.add_argument("--batch", type=int, default=4)
    parser.add_argument("--iterations", type=int, default=64)
    parser.add_argument("--steps", type=int, default=5, help="of a turn")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--torch-device", default="cpu", help="where PyTorch computes: cpu or cuda")
    parser.add_argument("--device", help="where Pelage computes, as in `pelage learn --device`")
    return parser.parse_args()


class TorchStep:
    """Iterations, loss, way back and Adam, as kernels/learn has them; without rotations of the target."""

    def __init__(self, torch, options):
        self.torch, self.options = torch, options
        chemicals, hidden = options.chemicals, options.hidden
        make = torch.Generator().manual_seed(1)
        width = (6 / (chemicals + hidden)) ** 0.5
        self.first = ((torch.rand(hidden, chemicals, 1, 1, generator=make) * 2 - 1) * width).requires_grad_()
        self.bias = torch.zeros(hidden, requires_grad=True)
        self.second = torch.zeros(chemicals, hidden, 1, 1, requires_grad=True)
        row = torch.tensor([1.0, 2.0, 1.0])
        kernel = (row[:, None] * row[None, :] - 16 * torch.eye(3)[1][:, None] * torch.eye(3)[1][None, :]) / 16
        rates = torch.tensor([0.125, 0.25, 0.5, 1.0]).repeat_interleave(chemicals // 4)
        self.kernel = kernel[None, None] * rates[:, None, None, None]
        self.directions = torch.nn.functional.normalize(
            torch.rand(LEVELS, DIRECTIONS, 3 * PATCH * PATCH, generator=make) * 2 - 1, dim=2)
        sides = [options.size >> level for level in range(LEVELS)]
        self.ranked = [torch.sort(torch.rand(DIRECTIONS, side * side, generator=make) - 0.5)[0] for side in sides]
        self.state = 0.1 * torch.rand(options.batch, chemicals, options.size, options.size, generator=make)
        self.first, self.bias, self.second = (
            weights.detach().to(options.torch_device).requires_grad_() for weights in (self.first, self.bias, self.second))
        self.kernel, self.directions, self.state = (
            values.to(options.torch_device) for values in (self.kernel, self.directions, self.state))
        self.ranked = [values.to(options.torch_device) for values in self.ranked]
        self.optimiser = torch.optim.Adam([self.first, self.bias, self.second], lr=1e-3)

    def around(self, x, width):
        return self.torch.nn.functional.pad(x, (width, width, width, width), mode="circular")

    def loss(self, x):
        functional, total = self.torch.nn.functional, 0
        picture = x[:, :3]
        for level in range(LEVELS):
            if level > 0:
                picture = functional.avg_pool2d(picture, 2)
            weights = self.directions[level].reshape(DIRECTIONS, 3, PATCH, PATCH)
            seen = functional.conv2d(self.around(picture, PATCH // 2), weights).flatten(2)
            total = total + (self.torch.sort(seen, dim=2)[0] - self.ranked[level]).square().mean()
        return total + (x - x.clip(-1, 1)).abs().sum() / (x.shape[0] * x.shape[2] * x.shape[3])

    def step(self):
        functional, x = self.torch.nn.functional, self.state
        for _ in range(self.options.iterations):
            z = functional.conv2d(x, self.first, self.bias)
            flow = functional.conv2d(z * self.torch.sigmoid(5 * z), self.second)
            x = x + functional.conv2d(self.around(x, 1), self.kernel, groups=self.options.chemicals) + flow
        self.optimiser.zero_grad()
        self.loss(x).backward()
        for weights in (self.first, self.bias, self.second):
            weights.grad /= weights.grad.norm() + 1e-8
        self.optimiser.step()

    def wait(self):
        if self.options.torch_device != "cpu":
            self.torch.cuda.synchronize()


def pelage_seconds(options, steps):
    """Of one training of so many steps, its start included."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        subprocess.run([options.pelage, "learn", options.picture, "--out", f"{folder}/x.npz", "--quiet", "--rotations", "1",
                        "--size", str(options.size), "--chemicals", str(options.chemicals), "--hidden", str(options.hidden),
                        "--batch", str(options.batch), "--iterations", f"{options.iterations}:{options.iterations}",
                        "--steps", str(steps), "--pool", str(max(8, options.batch)),
                        *(["--device", options.device] if options.device else [])], check=True, stdout=subprocess.DEVNULL)
        return time.perf_counter() - start


def main():
    options = arguments()
    ours, theirs, peer = [], [], None
    try:
        import torch
        peer = TorchStep(torch, options)
        peer.step()
        peer.wait()
    except ImportError as error:
        print(f"left out: PyTorch: {error}; Debian package python3-torch")
    pelage_seconds(options, 1)  # compiles
    for _ in range(options.turns):
        ours.append((pelage_seconds(options, 1 + options.steps) - pelage_seconds(options, 1)) / options.steps)
        if peer:
            start = time.perf_counter()
            for _ in range(options.steps):
                peer.step()
            peer.wait()
            theirs.append((time.perf_counter() - start) / options.steps)
    print(f"pelage learn: {min(ours):.3f} s a step")
    if theirs:
        where = f"{torch.get_num_threads()} threads" if options.torch_device == "cpu" else options.torch_device
        print(f"PyTorch {torch.__version__}, {where}: {min(theirs):.3f} s a step")
        print(f"pelage is {min(theirs) / min(ours):.2f} times as fast")
    return 0


if __name__ == "__main__":
    sys.exit(main())
