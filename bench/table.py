#!/usr/bin/python3
# The table of docs/performance.md from the JSON files of one run of scripts/bench.
"""python3 table.py FOLDER: reads bench.json, peers.json and the times of whole runs there; prints Markdown."""

import json
import sys
from pathlib import Path

LEOPARD_PAPER = 300  # seconds that the 2020 paper reports, at least


def load(folder, name):
    file = Path(folder, name)
    return json.loads(file.read_text()) if file.exists() else {}


def wall(folder, name):
    """Seconds of a whole run, start and result files included."""
    file = Path(folder, name + ".wall")
    return int(file.read_text().split()[1]) / 1000 if file.exists() else None


class Report:
    def __init__(self, folder):
        self.bench = load(folder, "bench.json")
        self.peers = load(folder, "peers.json")
        self.folder = folder

    def ratio(self, case, size, against):
        for one in self.bench.get("ratios", []):
            if (one["case"], one["size"], one["against"]) == (case, size, against):
                return one["ratio"]
        return None

    def peer(self, size, family):
        for one in self.peers.get("ratios", []):
            if (one["system"], one["size"], one["against"]) == ("turing", size, family):
                return one["ratio"]
        return None

    def result(self, case, size, backend="opencl"):
        for one in self.bench.get("results", []):
            if (one["case"], one["size"], one["backend"]) == (case, size, backend):
                return one
        return None

    def sizes(self, case):
        return sorted({one["size"] for one in self.bench.get("results", []) if one["case"] == case})


def shown(value, unit="x", digits=2):
    if value is None:
        return "not measured"
    return f"{value:.{0 if value >= 20 else digits}f} {unit}".rstrip()


def verdict(value, least=None, most=None):
    if value is None:
        return ""
    good = (least is None or value >= least) and (most is None or value <= most)
    return "yes" if good else "**no**"


def several(values, demands, most=False):
    """Cells of the table for several sizes at once."""
    text = " / ".join(shown(value) for value in values)
    known = [(value, demand) for value, demand in zip(values, demands) if value is not None]
    if not known:
        return text, ""
    good = all(value <= demand if most else value >= demand for value, demand in known)
    return text, "yes" if good else "**no**"


def speed_rows(report):
    yield ("SciPy double", "100² / 1024²", "60 x / 100 x",
           *several([report.peer(100, "SciPy double"), report.peer(1024, "SciPy double")], [60, 100]))
    yield ("numba, best variant", "100² / 1024²", "4 x / 8 x",
           *several([report.peer(100, "numba float"), report.peer(1024, "numba float")], [4, 8]))
    sides = [side for side in report.sizes("turing") if 128 <= side <= 4096]
    yield ("our plain OpenCL kernel", " / ".join(f"{side}²" for side in sides) or "128² to 4096²", "6 x",
           *several([report.ratio("turing", side, "opencl-plain") for side in sides], [6] * len(sides)))
    yield ("C++ OpenMP + simd, all threads", "100² / 256² / 1024² / 4096²", "1.2 / 1.3 / 1.6 / 3 x",
           *several([report.ratio("turing", side, "openmp") for side in (100, 256, 1024, 4096)], [1.2, 1.3, 1.6, 3]))
    yield ("one pass over memory an iteration", "4096²", "2.2 x",
           *several([report.ratio("turing", 4096, "copy")], [2.2]))
    for threads, backend, least in ((1, "nanoflann", 10), ("all", "nanoflann-openmp", 6)):
        yield (f"nanoflann, {threads} thread{'s' if threads != 1 else ''}, hexagonal", "20k / 1M points", f"{least} x",
               *several([report.ratio("hexagonal", size, backend) for size in (20000, 1000000)], [least] * 2))
    sizes = [size for size in report.sizes("tissue") if size >= 20000]
    yield ("our OpenMP cell step, all threads", " / ".join(f"{size // 1000}k" for size in sizes) or "20k to 1M", "0.9 x",
           *several([report.ratio("tissue", size, "openmp") for size in sizes], [0.9] * len(sizes)))
    yield ("the same with bit equality given up (`--fast`)", "1024²", "0.85 x",
           *several([report.ratio("turing", 1024, "opencl-fast")], [0.85]))


def other_rows(report):
    leopard = wall(report.folder, "leopard")
    yield (f"whole leopard (paper: over {LEOPARD_PAPER} s)", "242,000 iterations", "10 s at most",
           shown(leopard, "s"), verdict(leopard, most=10))
    turing = report.result("turing", 1024)
    for case in ("gray-scott", "reinforcement", "three-chemicals", "anisotropic"):
        one = report.result(case, 1024)
        value = None
        if one and turing:
            share = max(one["flops_per_update"] / turing["flops_per_update"],
                        one["bytes_per_update"] / turing["bytes_per_update"])
            value = turing["updates_per_second"] / one["updates_per_second"] / share
        yield (f"{case}: time by what Turing's predicts", "1024²", "1.5 x at most", shown(value), verdict(value, most=1.5))
    ratios = [report.ratio("gray-scott-seed", side, "opencl-twin") for side in (256, 1024)]
    yield ("a spot in an empty field: time by a filled field's", "256² / 1024²", "1.15 x at most",
           *several([1 / value if value else None for value in ratios], [1.15] * 2, most=True))
    large, middle = report.result("turing", 3162), report.result("turing", 1024)
    value = middle["updates_per_second"] / large["updates_per_second"] if large and middle else None
    yield ("time a cell at 10⁷ cells by that at 10⁶", "3162² / 1024²", "1.5 x at most", shown(value), verdict(value, most=1.5))
    lattice = report.result("turing", 4096)
    value = lattice["bytes_per_cell"] / 8 if lattice and lattice.get("bytes_per_cell") else None
    yield ("memory by the fields' own size", "4096²", "2.2 x at most", shown(value), verdict(value, most=2.2))
    cells = report.result("tissue", 1000000)
    value = cells["bytes_per_cell"] if cells and cells.get("bytes_per_cell") else None
    yield ("memory of a free cell", "1M cells", "400 bytes at most", shown(value, "bytes", 0), verdict(value, most=400))


def main(folder):
    report = Report(folder)
    print("| against | at | at least | measured | reached |\n|---|---|---|---|---|")
    for row in speed_rows(report):
        print("| " + " | ".join(row) + " |")
    print("\n| what | at | demanded | measured | reached |\n|---|---|---|---|---|")
    for row in other_rows(report):
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
