#!/usr/bin/python3
# Times Pelage beside what people use otherwise: on the same machine, in the same run, turn by turn.
"""python3 peers.py --pelage build/release/pelage [--sizes 100,1024] [--json FILE] ... ; see --help."""

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import foreign
import formulas


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pelage", required=True, help="the built command")
    parser.add_argument("--sizes", default="100,1024", help="sides of the square grids")
    parser.add_argument("--systems", default="turing,gray-scott")
    parser.add_argument("--runs", type=int, default=5, help="turns")
    parser.add_argument("--seconds", type=float, default=0.5, help="of one run of one peer, about")
    parser.add_argument("--quick", action="store_true", help="two short turns: to see that all works")
    parser.add_argument("--json", help="write results to this file too")
    parser.add_argument("--pattern-explorer", metavar="OFFLINE", help="the `offline` program of your own copy")
    parser.add_argument("--ready-kernel", metavar="FILE", help="a full kernel saved from your own copy of Ready")
    return parser.parse_args()


def peers():
    """name -> run(system, u, v, steps), element type, family; and why others are absent."""
    found, absent = {}, []
    try:
        import scipy_peers
        found.update({name: (run, "float64", "SciPy double") for name, run in scipy_peers.VARIANTS.items()})
    except ImportError as error:
        absent.append(f"SciPy: {error}; Debian package python3-scipy")
    try:
        import numba_peers
        found.update({name: (run, "float32", "numba float") for name, run in numba_peers.VARIANTS.items()})
    except ImportError as error:
        absent.append(f"numba: {error}; Debian package python3-numba")
    return found, absent


def wrong_ones(found, system):
    """Peers whose result after 20 steps is not that of the others, within rounding."""
    import numpy
    results = {name: run(system, *formulas.initial(system, 48, kind), 20) for name, (run, kind, _) in found.items()}
    if not results:
        return []
    expected = next(iter(results.values()))
    apart = {name: max(float(numpy.abs(a - b).max()) for a, b in zip(expected, found_one))
             for name, found_one in results.items()}
    return [name for name, distance in apart.items() if not distance < 1e-3]


class Pelage:
    """One turn of `pelage bench`, opencl alone."""

    def __init__(self, command, system, side, quick):
        self.words = [command, "bench", "--suite", "lattice", "--cases", system, "--sizes", str(side),
                      "--against", "opencl", "--runs", "1"] + (["--quick"] if quick else [])

    def turn(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "bench.json")
            subprocess.run(self.words + ["--json", str(file)], stdout=subprocess.DEVNULL)
            report = json.loads(file.read_text())
        if not report["results"]:
            sys.exit("pelage bench has no result: " + "; ".join(note["text"] for note in report["notes"]))
        return report["results"][0]


def calibrated(run, system, u, v, target):
    run(system, u, v, 2)  # compiles
    steps = 1
    while True:
        start = time.perf_counter()
        run(system, u, v, steps)
        seconds = time.perf_counter() - start
        if seconds > target / 4:
            return max(1, int(steps * target / seconds))
        steps *= 4


def measure(options, found, system, side):
    """Rows of one system at one size, the peers and Pelage turn by turn."""
    target, turns = (0.05, 2) if options.quick else (options.seconds, options.runs)
    states = {kind: formulas.initial(system, side, kind) for kind in ("float64", "float32")}
    steps = {name: calibrated(run, system, *states[kind], target) for name, (run, kind, _) in found.items()}
    times = {name: [] for name in found}
    pelage, turned = Pelage(options.pelage, system["name"], side, options.quick), []
    for _ in range(turns):
        for name, (run, kind, _) in found.items():
            start = time.perf_counter()
            run(system, *states[kind], steps[name])
            times[name].append(time.perf_counter() - start)
            time.sleep(0.03)  # threads that still spin
        turned.append(pelage.turn())
    rows = [dict(system=system["name"], peer=name, family=found[name][2], size=side, cells=side * side,
                 iterations=steps[name], seconds=statistics.median(taken), best=min(taken),
                 updates_per_second=side * side * steps[name] / min(taken)) for name, taken in times.items()]
    best = max(turned, key=lambda one: one["updates_per_second"])
    rows.append(dict(system=system["name"], peer="pelage opencl", family="pelage", size=side, cells=side * side,
                     iterations=best["iterations"],
                     seconds=statistics.median([one["seconds"] for one in turned]), best=best["best"],
                     updates_per_second=best["updates_per_second"]))
    return rows


def ratios(rows):
    """Pelage against the best variant of each family, same system and size, by the shortest runs."""
    table = []
    for ours in (row for row in rows if row["peer"] == "pelage opencl"):
        families = {}
        for row in rows:
            if row["system"] == ours["system"] and row["size"] == ours["size"] and row is not ours:
                key = row.get("family", row["peer"])
                if key not in families or row["updates_per_second"] > families[key]["updates_per_second"]:
                    families[key] = row
        for family, row in families.items():
            table.append(dict(system=ours["system"], size=ours["size"], against=family, variant=row["peer"],
                              ratio=ours["updates_per_second"] / row["updates_per_second"]))
    return table


def show(rows, table, notes):
    print(f"{'SYSTEM':<14} {'SIZE':>6}  {'PEER':<34} {'ITERATIONS':>10} {'SECONDS':>9} {'M UPDATES/s':>12}")
    for row in rows:
        print(f"{row['system']:<14} {row['size']:>6}  {row['peer']:<34} {row['iterations']:>10} "
              f"{row['seconds']:>9.4f} {row['updates_per_second'] / 1e6:>12.1f}")
    print(f"\n{'SYSTEM':<14} {'SIZE':>6}  {'PELAGE AGAINST':<34} {'TIMES FASTER':>12}")
    for row in table:
        print(f"{row['system']:<14} {row['size']:>6}  {row['against']:<34} {row['ratio']:>12.1f}")
    for note in notes:
        print("left out:", note)


def keep(file, rows, notes):
    """Replaces the file as a whole, so that a run that is cut keeps what it measured."""
    aside = Path(str(file) + ".part")
    aside.write_text(json.dumps(dict(results=rows, ratios=ratios(rows), notes=notes), indent=2) + "\n")
    aside.replace(file)


def main():
    options = arguments()
    found, notes = peers()
    rows = []
    sides = [int(word) for word in options.sizes.split(",")]
    for name in options.systems.split(","):
        system = formulas.SYSTEMS[name]
        wrong = wrong_ones(found, system)
        notes += [f"{peer}, {name}: WRONG: its result is not that of the other peers" for peer in wrong]
        right = {peer: how for peer, how in found.items() if peer not in wrong}
        for side in sides:
            rows += measure(options, right, system, side)
            if options.json:
                keep(options.json, rows, notes)
    radii, steps = ([20], 50) if options.quick else ([45, 180], 1000)
    others = [(options.pattern_explorer, "Pattern Explorer", "--pattern-explorer",
               lambda: foreign.pattern_explorer(Path(options.pattern_explorer).resolve(),
                                                Path(options.pelage).resolve(), radii, steps, 2)),
              (options.ready_kernel, "Ready", "--ready-kernel",
               lambda: foreign.ready(options.ready_kernel, [128, 256, 1024], 0.3, 3))]
    for path, name, option, run in others:
        if not path:
            notes.append(f"{name}: give {option} to time your own copy")
            continue
        try:
            rows += run()
        except (RuntimeError, OSError) as error:
            notes.append(f"{name}: {error}")
    table = ratios(rows)
    show(rows, table, notes)
    if options.json:
        keep(options.json, rows, notes)
    return 1 if any("WRONG" in note for note in notes) else 0


if __name__ == "__main__":
    sys.exit(main())
