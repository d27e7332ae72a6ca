#!/usr/bin/env python3
"""Shows what of the OpenCL backend and its kernels `pelage verify` does not run.

    cmake --preset coverage && cmake --build --preset coverage
    python3 tests/coverage/run.py [--form quick|full] [--build DIR] [--report-only]

Runs the command of a build with --coverage, on PoCL, and then lists the lines of host/opencl that were never run, and of
the kernels the branches of `#if`, the places that begin with //@, the files and the kernels that were in no program.
Each must be named in exceptions.py with a reason. The exit code is 1 where one is not. Exceptions that excuse nothing are
told, for a machine with more processors runs more; so is what the quick form leaves out.
"""

import argparse
import dataclasses
import fnmatch
import itertools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import checks
import exceptions
import host
import kernels

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run_verify(chosen, work):
    """Leaves the counters beside the build's objects, and in `work` the programs and the parts of the marked kernels. Says
    whether all checks were run."""
    for folder in ("evidence",) if chosen.add else ("kernels", "programs", "evidence"):
        shutil.rmtree(work / folder, ignore_errors=True)
    (work / "programs").mkdir(parents=True, exist_ok=True)
    parts = kernels.mark(ROOT / "kernels", work / "kernels")
    (work / "parts.json").write_text(json.dumps([dataclasses.asdict(part) for part in parts]))
    surroundings = dict(os.environ, PELAGE_KERNELS=str(work / "kernels"), PELAGE_PROGRAMS_LOG=str(work / "programs"),
                        POCL_EXTRA_BUILD_FLAGS="-cl-opt-disable")
    surroundings.setdefault("PELAGE_CACHE", str(work / "cache"))
    arguments = ["--device", chosen.device, "--seed", "1", "--" + chosen.form, "--evidence", str(work / "evidence")]
    program = chosen.build / "pelage"
    wanted = checks.names(program, chosen.form, chosen.filter)
    if not chosen.add:
        host.forget(chosen.build)  # listing has counted, too
    done = itertools.count(1)
    tell = lambda name, verdict: print(f"[{next(done)}/{len(wanted)}] {name}: {verdict}", file=sys.stderr)
    end = time.monotonic() + 60 * chosen.minutes
    failed = checks.carry_out(program, arguments, wanted, surroundings, chosen.jobs, tell, end)
    if failed or not wanted:
        raise SystemExit("coverage tells nothing where verify fails: " + ", ".join(failed))
    if host.processes(chosen.build) < min(chosen.jobs, len(wanted)):
        raise SystemExit("a process has not written what it counted")
    return next(done) - 1 == len(wanted) and not chosen.filter


class Excuses:
    """The list of exceptions, and which of them excused something."""

    def __init__(self, rows):
        self.rows = rows
        self.used = set()

    def reason(self, fits):
        found = [row for row in self.rows if fits(*row[:-1])]
        self.used.update(found)
        return found[0][-1] if found else ""

    def unused(self):
        return [row for row in self.rows if row not in self.used]


def line_fits(file, number):
    def fits(name, telling):
        if not fnmatch.fnmatch(file.name, name):
            return False
        if telling.startswith("within "):
            return any(re.search(telling.removeprefix("within "), head) for head in file.heads(number))
        return re.search(telling, file.statement(number)) is not None
    return fits


def part_fits(part):
    return lambda file, kind, text: file == part.file and kind == part.kind and re.search(text, part.text) is not None


def ratio(name, total, missing, excused):
    print(f"{name:<24} {total:>6} {total - missing:>6} {missing:>8} {excused:>8} {100 * (total - missing) / max(total, 1):>7.1f} %")


def report_host(chosen, excuses):
    """Prints the lines that nothing excuses; returns their number and a row of the table of figures."""
    total = missing = excused = 0
    for file in host.covered_files(ROOT, chosen.build).values():
        total += len(file.counts)
        for number in sorted(number for number in file.counts if not file.was_run(number)):
            reason = excuses.reason(line_fits(file, number))
            missing, excused = missing + 1, excused + bool(reason)
            if not reason or chosen.all:
                print(f"{file.name}:{number}: {file.text[number - 1].strip()}" + (f"  ({reason})" if reason else ""))
    return missing - excused, ("lines of host/opencl", total, missing, excused)


def report_kernels(chosen, work, excuses):
    parts = [kernels.Part(**part) for part in json.loads((work / "parts.json").read_text())]
    parts = kernels.used_parts(parts, work / "programs")
    rows, left = [], 0
    for kind, name in (("branch", "branches of #if"), ("place", "places to fill in"), ("file", "files"),
                       ("kernel", "kernels")):
        of_kind = [part for part in parts if part.kind == kind]
        missing = [part for part in of_kind if not part.used]
        excused = 0
        for part in missing:
            reason = excuses.reason(part_fits(part))
            excused += bool(reason)
            if not reason or chosen.all:
                print(f"{part.file}:{part.line}: {kind}: {part.text}" + (f"  ({reason})" if reason else ""))
        rows.append((name, len(of_kind), len(missing), excused))
        left += len(missing) - excused
    return left, rows


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--form", choices=["quick", "full"], default="full")
    options.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "coverage")
    options.add_argument("--device", default="0", help="as of `pelage verify` (default 0)")
    options.add_argument("--filter", default="", help="a regular expression that the names of the checks have (default: all)")
    options.add_argument("--jobs", type=int, default=4, help="processes that run checks (default 4)")
    options.add_argument("--minutes", type=float, default=600, help="no check is begun later (default 600)")
    options.add_argument("--add", action="store_true", help="to what the runs before counted")
    options.add_argument("--report-only", action="store_true", help="of what the last run left, without another")
    options.add_argument("--all", action="store_true", help="list what is excused, too, with the reasons")
    chosen = options.parse_args()
    chosen.build = chosen.build.resolve()
    work = chosen.build / "coverage"
    whole = chosen.report_only or run_verify(chosen, work)
    lines, parts = Excuses(exceptions.HOST), Excuses(exceptions.KERNELS)
    left_lines, row = report_host(chosen, lines)
    left_parts, rows = report_kernels(chosen, work, parts)
    print(f"{'':<24} {'ALL':>6} {'RUN':>6} {'NOT RUN':>8} {'EXCUSED':>8}")
    for one in [row, *rows]:
        ratio(*one)
    if not whole:
        print("not all checks were run")
    if chosen.form == "quick" or chosen.filter:
        return 0
    idle = lines.unused() + parts.unused()
    for one in idle:
        print("an exception that excuses nothing:", *one[:-1])
    return 1 if left_lines or left_parts or not whole else 0


if __name__ == "__main__":
    sys.exit(main())
