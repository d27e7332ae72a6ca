#!/usr/bin/env python3
"""Plants single faults in a copy of the sources and shows which checks of `pelage verify` catch each.

    python3 tests/mutation/mutate.py [--only TEXT] [--first N] [--table FILE.md] [--work FOLDER]

Each fault is built and given to `pelage verify --quick`. A fault is caught when that does not pass, or when the program
does not even build. The table goes to standard output or FILE; the exit code is 1 when a fault was not caught.
Some minutes for each handful of faults: compiled programs are kept between them in FOLDER.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

from faults import FAULTS

ROOT = pathlib.Path(__file__).resolve().parents[2]
PARTS = ["CMakeLists.txt", "cmake", "host", "reference", "kernels"]


def copy_sources(to):
    """What has changed since the last time gets a new date, so that it is compiled; what has gone goes."""
    wanted = set()
    for part in PARTS:
        files = [ROOT / part] if (ROOT / part).is_file() else sorted((ROOT / part).rglob("*"))
        wanted.update(file.relative_to(ROOT) for file in files if file.is_file())
    for name in wanted:
        source, target = ROOT / name, to / name
        if target.exists() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, target)
    for old in to.rglob("*"):
        if old.is_file() and old.relative_to(to) not in wanted:
            old.unlink()


def build(work):
    folder = work / "build"
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "-S", work / "source", "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DPELAGE_TESTS=OFF"], check=True, stdout=subprocess.DEVNULL)
    done = subprocess.run(["ninja", "-C", folder, "pelage_command"], capture_output=True, text=True)
    return done.returncode == 0, done.stdout[-2000:]


def verify(work):
    """Names and messages of the checks that did not pass; None when there was no report."""
    report = work / "report.json"
    report.unlink(missing_ok=True)
    surroundings = dict(os.environ, PELAGE_CACHE=str(work / "cache"), POCL_CACHE_DIR=str(work / "pocl-cache"))
    subprocess.run([work / "build" / "pelage", "verify", "--quick", "--quiet", "--limit", "120", "--json", report,
                    "--evidence", work / "evidence"], env=surroundings, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL, timeout=1800)
    if not report.exists():
        return None
    cases = json.loads(report.read_text())["cases"]
    broken = [case["message"] for case in cases if "BUILD_PROGRAM_FAILURE" in case["message"]]
    if broken:
        raise SystemExit("that is no fault, it does not compile: " + broken[0])
    return [case["name"] for case in cases if case["verdict"] in ("failed", "mistrusted")]


def plant(work, file, old, new):
    path = work / "source" / file
    text = path.read_text()
    if text.count(old) != 1:
        raise SystemExit(f"{file} holds {text.count(old)} times, not once: {old!r}")
    path.write_text(text.replace(old, new))
    return path, text


def catch(work, file, old, new):
    path, text = plant(work, file, old, new)
    try:
        good, log = build(work)
        if not good:
            return ["(does not build)"]
        return verify(work)
    finally:
        path.write_text(text)


def row(number, name, file, caught):
    if caught is None:
        found = "(no report)"
    elif not caught:
        found = "**not caught**"
    else:
        found = ", ".join(f"`{one}`" for one in caught[:3])
        if len(caught) > 3:
            found += f" and {len(caught) - 3} more"
    return f"| {number} | {name} | `{file}` | {found} |"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--only", default="", help="faults with this in their name or file")
    options.add_argument("--first", type=int, default=1, help="number of the fault to begin with")
    options.add_argument("--table", type=pathlib.Path, help="write the table to this file")
    options.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "mutation")
    chosen = options.parse_args()
    work = chosen.work.resolve()
    copy_sources(work / "source")
    good, log = build(work)
    if not good:
        raise SystemExit("the sources do not build:\n" + log)
    before = verify(work)
    if before is None or before:
        raise SystemExit(f"without a fault these fail already: {before}")
    faults = [fault for fault in FAULTS if chosen.only in fault[0] or chosen.only in fault[1]]
    for name, file, old, new in faults:  # all of them must fit before the first is tried
        path, text = plant(work, file, old, new)
        path.write_text(text)
    lines = ["| | Fault | In | Caught by |", "|---|---|---|---|"]
    missed = 0
    tried = len(faults) - min(chosen.first - 1, len(faults))
    for number, (name, file, old, new) in enumerate(faults, 1):
        if number < chosen.first:
            continue
        start = time.time()
        caught = catch(work, file, old, new)
        missed += caught == []
        lines.append(row(number, name, file, caught))
        print(f"{lines[-1]} {time.time() - start:.0f} s", file=sys.stderr, flush=True)
    text = "\n".join(lines) + f"\n\n{tried - missed} of {tried} faults are caught.\n"
    if chosen.table:
        chosen.table.write_text(text)
    else:
        print(text, end="")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
