# Programs of others, where the user has a copy: Pattern Explorer's `offline`, and a kernel that Ready wrote.
"""Each function returns rows of results, or raises RuntimeError saying why there are none."""

import re
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

TISSUE = """define chemical U
define chemical V
use seed 2
use chemical U conc 4 dev 2 diff 0.15
use chemical V conc 4 dev 2 diff 0.01
create hex_circle {radius}
rule always react U V scale 0.01 turing alpha 16 beta 12
stop at {steps}
"""


def _wall(words, folder):
    start = time.perf_counter()
    done = subprocess.run(words, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{words[0]} ended with {done.returncode}: {done.stderr.strip()[-200:]}")
    return time.perf_counter() - start


def pattern_explorer(offline, pelage, radii, steps, runs):
    """Free cells on a disc, the same file for both. Whole runs of two lengths: their difference is free of start and end."""
    rows = []
    for radius in radii:
        with tempfile.TemporaryDirectory() as folder:
            for name, count in (("short", 1), ("long", steps + 1)):
                Path(folder, name + ".pex").write_text(TISSUE.format(radius=radius, steps=count))
            programs = {
                "Pattern Explorer, spatial sorting": [str(offline), "--ss"],
                "Pattern Explorer, k-d tree": [str(offline), "--kd"],
                "pelage opencl": [str(pelage), "run", "--quiet", "--backend", "opencl", "--out", folder + "/out"],
            }
            times = {name: [] for name in programs}
            for _ in range(runs + 1):
                for name, words in programs.items():
                    seconds = [_wall(words + [f"{folder}/{length}.pex"], folder) for length in ("short", "long")]
                    times[name].append(seconds[1] - seconds[0])
        cells = round(3.14159 * radius ** 2 / 3.4641)
        for name, seconds in times.items():
            seconds = [max(1e-9, one) for one in seconds[1:]]  # the first runs compile
            rows.append(dict(system="tissue", peer=name, size=radius, cells=cells, iterations=steps,
                             seconds=statistics.median(seconds), best=min(seconds),
                             updates_per_second=cells * steps / min(seconds)))
    return rows


def ready(kernel_file, sides, target, runs):
    """A kernel saved from Ready ("full kernel") for a 2D system, stepped as Ready steps it: arguments are all inputs, then
    all outputs; a float4 holds four neighbours of a row; sides must be powers of two."""
    try:
        import numpy
        import pyopencl
    except ImportError as error:
        raise RuntimeError(f"python3-pyopencl is needed: {error}") from error
    source = Path(kernel_file).read_text()
    head = re.search(r"__kernel\s+void\s+(\w+)\s*\(([^)]*)\)", source)
    if head is None:
        raise RuntimeError(f"{kernel_file} holds no kernel")
    chemicals = head.group(2).count("__global") // 2
    block = 4 if "float4" in head.group(2) else 1
    device = pyopencl.get_platforms()[0].get_devices()[0]
    context = pyopencl.Context([device])
    queue = pyopencl.CommandQueue(context)
    options = ["-cl-denorms-are-zero", "-cl-fast-relaxed-math"]
    kernel = getattr(pyopencl.Program(context, source).build(options), head.group(1))
    rows = []
    for side in sides:
        if side & (side - 1):
            continue
        field = numpy.full(side * side, 0.5, numpy.float32)
        buffers = [pyopencl.Buffer(context, pyopencl.mem_flags.READ_WRITE | pyopencl.mem_flags.COPY_HOST_PTR,
                                   hostbuf=field) for _ in range(2 * chemicals)]

        def run(steps):
            for step in range(steps):
                half = buffers if step % 2 == 0 else buffers[chemicals:] + buffers[:chemicals]
                kernel(queue, (side // block, side, 1), None, *half)
            queue.finish()

        rows.append(dict(system="ready kernel", peer="Ready's kernel", size=side, cells=side * side,
                         **timed(run, side * side, target, runs)))
    return rows


def timed(run, cells, target, runs):
    """Medians and shortest of `runs` runs that take about `target` seconds each."""
    steps = 1
    run(1)
    while True:
        start = time.perf_counter()
        run(steps)
        seconds = time.perf_counter() - start
        if seconds > target / 4:
            break
        steps *= 4
    steps = max(1, int(steps * target / seconds))
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        run(steps)
        times.append(time.perf_counter() - start)
    return dict(iterations=steps, seconds=statistics.median(times), best=min(times),
                updates_per_second=cells * steps / min(times))
