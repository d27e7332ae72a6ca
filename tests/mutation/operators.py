#!/usr/bin/env python3
"""Plants faults that nobody chose, and shows which check of `pelage verify` catches each first.

    python3 tests/mutation/operators.py [--sample N] [--seed N] [--form quick|full] [--results FILE.json]
    python3 tests/mutation/operators.py --named | --replay FILE.json | --summary

A seeded draw takes files of kernels/ and of the backend in host/opencl, in each an operator (off by one, another
comparison, another sign, swapped arguments, another variable, a narrower type, a statement dropped, a clamp removed, a
constant changed) and a place for it. Faults in kernels need no build: the program reads them from a folder
(PELAGE_KERNELS). Faults in the host are built, in a copy of the sources or, with --tree, in a tree that has been built
before. The results are kept in FILE after each fault, so that a run goes on where the last one ended. --named plants
the faults of faults.py, --replay those that another file of results holds, whatever has become of the sources around
them. The exit code is 1 when a fault survived.
"""

import argparse
import difflib
import json
import os
import pathlib
import queue
import random
import re
import select
import shutil
import signal
import subprocess
import sys
import threading
import time

from faults import FAULTS

ROOT = pathlib.Path(__file__).resolve().parents[2]
HOST = ["host/opencl/*/*.cpp", "host/core/evaluate.cpp"]
# They belong to the benchmarks, to programs in another order (PELAGE_SCHEDULE), and to what a run says of itself; what
# lies between them and a device, its cache and its errors, has tests of its own (test_opencl, test_opencl_faults).
NOT_VERIFIED = ["kernels/common/yardstick.cl", "kernels/common/schedule.cl", "host/opencl/lattice/explain.cpp"]
NOT_VERIFIED_IN = ["host/opencl/device/"]
# Where a fault in a file most likely shows: how the names of checks begin that are tried before all others.
LIKELY = [("kernels/functions/", ["functions/"]), ("kernels/models/", ["reaction/", "saturation/"]),
          ("kernels/common/sort", ["sort/", "scan/"]), ("kernels/common/scan", ["scan/", "sort/"]),
          ("kernels/rules/philox", ["random/"]), ("kernels/rules/neural", ["neural/"]),
          ("kernels/rules/", ["reaction/"]), ("kernels/neighbours/gather", ["gather/"]),
          ("kernels/neighbours/", ["sort/", "neighbours/"]), ("kernels/cells/together", ["pairs/cells/.*-shared"]),
          ("kernels/cells/", ["pairs/cells/.*-step"]), ("kernels/lattice/tile", [".*tiled"]),
          ("kernels/lattice/stream", [".*streamed"]), ("kernels/lattice/margins", [".*streamed", ".*tiled"]),
          ("kernels/lattice/together", [".*shared"]), ("kernels/lattice/expand", ["growth/"]),
          ("kernels/lattice/resample", ["growth/"]), ("kernels/volume/", ["pairs/volume"]),
          ("kernels/mesh/", ["pairs/mesh"]), ("kernels/aggregate/", ["pairs/charges"]), ("kernels/lattice/", ["diffusion/", "rates/"]),
          ("host/opencl/cells/", ["pairs/cells/.*-step"]), ("host/opencl/aggregate/", ["pairs/charges"]),
          ("host/opencl/mesh/", ["pairs/mesh"]), ("host/opencl/volume/", ["pairs/volume"]),
          ("host/opencl/neighbours/", ["neighbours/"]), ("host/opencl/learn/", ["learning/"]),
          ("host/opencl/lattice/emit_fused", ["pairs/.*-(tiled|streamed)"]),
          ("host/opencl/lattice/passing", ["pairs/.*-(tiled|streamed)"]),
          ("host/", ["pairs/lattice/.*-step", "pairs/cells/.*-step", "neural/"])]

# ---- the operators: each yields (start, end, text instead) in one line of code

EXCHANGED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
OTHER_NAMES = [("x", "y"), ("row", "x"), ("rows", "columns"), ("dx", "dy"), ("px", "py"), ("u", "v"), ("low", "high"),
               ("first", "n"), ("begin", "end"), ("own", "theirs"), ("above", "below"), ("id", "place"),
               ("level", "step"), ("old", "new"), ("left", "right"), ("i", "k"), ("c", "r"), ("from", "to"),
               ("width", "height"), ("parent", "child"), ("conc", "rate"), ("key0", "key1"), ("steps", "passes"),
               ("a", "b"), ("chunk", "chunks"), ("columns", "pitch"), ("iteration", "first"), ("count", "most")]


def comparisons(line):
    for m in re.finditer(r"(?<![<>=!\-])(<=|>=|==|!=|<|>)(?![<>=])", line):
        if re.match(r"\s*#\s*include|.*\btemplate\b|.*static_cast<|.*std::\w+<", line):
            return
        yield m.start(), m.end(), EXCHANGED[m.group()]


def signs(line):
    for m in re.finditer(r"(?<=[\w)\]]) ([+-]) (?=[\w(])", line):
        yield m.start(1), m.end(1), "-" if m.group(1) == "+" else "+"
    for m in re.finditer(r"(?<=[(,=] )-(?=\w)|(?<=\()-(?=\w)", line):
        yield m.start(), m.end(), ""


def off_by_one(line):
    for m in re.finditer(r"(?<![\w.])(\d+)(?![\w.])", line):
        yield m.start(), m.end(), str(int(m.group()) + 1)
        if int(m.group()) > 0:
            yield m.start(), m.end(), str(int(m.group()) - 1)


def constants(line):
    for m in re.finditer(r"(?<![\w.])\d+\.\d+(?=f?\b)", line):
        yield m.start(), m.end(), m.group() + "1"
    for m in re.finditer(r"\b0x[0-9a-fA-F.]+(?=u|p|ul)", line):
        digits = m.group()
        yield m.start(), m.end(), digits[:-1] + ("1" if digits[-1] != "1" else "2")


def arguments(text, start):
    """The arguments of the call whose bracket opens at start, as (begin, end)."""
    depth, begin, found = 0, start + 1, []
    for i in range(start, len(text)):
        if text[i] in "([{":
            depth += 1
        elif text[i] in ")]}":
            depth -= 1
            if depth == 0:
                return found + [(begin, i)]
        elif text[i] == "," and depth == 1:
            found.append((begin, i))
            begin = i + 1
    return []


def swapped_arguments(line):
    for m in re.finditer(r"\b[A-Za-z_]\w*(?=\()", line):
        found = arguments(line, m.end())
        for (a, b), (c, d) in zip(found, found[1:]):
            one, two = line[a:b].strip(), line[c:d].strip()
            if one and two and one != two and m.group() not in ("fma", "for", "if", "while"):
                yield a, d, f"{two}, {one}" if a == m.end() + 1 else f" {two}, {one}"


def clamps(line):
    for m in re.finditer(r"\b(min|max|clamp|SELECT|HELD)(?=\()", line):
        found = arguments(line, m.end())
        if len(found) < 2:
            continue
        end = found[-1][1] + 1
        if m.group() == "SELECT":
            for a, b in found[1:]:
                yield m.start(), end, f"({line[a:b].strip()})"
        else:
            for a, b in found[:2] if m.group() in ("min", "max") else found[:1]:
                yield m.start(), end, f"({line[a:b].strip()})"


def other_variables(line):
    for one, two in OTHER_NAMES:
        for a, b in ((one, two), (two, one)):
            for m in re.finditer(rf"(?<![\w.>#\\]){a}\b(?!\()", line):
                yield m.start(), m.end(), b


def narrower_types(line):
    for wide, narrow in (("uint", "ushort"), ("int", "short"), ("long", "int"), ("uint32_t", "uint16_t")):
        for m in re.finditer(rf"\((?:const )?({wide})\)|\b({wide})(?= \w+ = )", line):
            group = 1 if m.group(1) else 2
            yield m.start(group), m.end(group), narrow


def dropped_statements(line):
    text = line.strip().rstrip("\\").strip()
    declares = re.match(r"(const |static |local |global |return|real \w|int \w|uint \w|scalar \w|mask \w|long \w|#|using)", text)
    if text.endswith(";") and text.count("(") == text.count(")") and not declares and "for (" not in text:
        at = line.index(text)
        yield at, at + len(text), ";" if not text.startswith("PELAGE_") else ""


def logic(line):
    for m in re.finditer(r" (&&|\|\||&|\|) ", line):
        yield m.start(1), m.end(1), {"&&": "||", "||": "&&", "&": "|", "|": "&"}[m.group(1)]


OPERATORS = {"another comparison": comparisons, "another sign": signs, "off by one": off_by_one,
             "a constant changed": constants, "arguments swapped": swapped_arguments, "a clamp removed": clamps,
             "another variable": other_variables, "a narrower type": narrower_types,
             "a statement dropped": dropped_statements, "another conjunction": logic}


def code_of(line):
    """The line without its remark; nothing for lines of the preprocessor that choose or include."""
    if re.match(r"\s*#\s*(if|el|en|un|include|pragma)", line) or line.lstrip().startswith("//"):
        return ""
    return re.sub(r"/\*.*?\*/", lambda m: " " * len(m.group()), line.split("//")[0])


def sites(text):
    """All faults that could be planted in a file: {operator: [(line number, line with the fault)]}."""
    found = {}
    for number, line in enumerate(text.split("\n")):
        code = code_of(line)
        for name, operator in OPERATORS.items():
            for start, end, instead in operator(code):
                found.setdefault(name, []).append((number, line[:start] + instead + line[end:]))
    return found


def files_to_hurt():
    kernels = [str(f.relative_to(ROOT)) for f in sorted((ROOT / "kernels").rglob("*.cl")) if f.parent.name != "pocl"]
    host = [str(f.relative_to(ROOT)) for pattern in HOST for f in sorted(ROOT.glob(pattern))]
    return [file for file in kernels + host
            if file not in NOT_VERIFIED and not any(file.startswith(folder) for folder in NOT_VERIFIED_IN)]


def draw(seed):
    """Faults without end: each file once, in any order; then files in proportion to their lines."""
    dice = random.Random(seed)
    files = files_to_hurt()
    texts = {file: (ROOT / file).read_text() for file in files}
    all_sites = {file: sites(texts[file]) for file in files}
    files = [file for file in files if all_sites[file]]
    order = dice.sample(files, len(files))
    lines = [texts[file].count("\n") for file in files]
    seen = set()
    while True:
        file = order.pop(0) if order else dice.choices(files, lines)[0]
        operator = dice.choice(sorted(all_sites[file]))
        number, hurt = dice.choice(all_sites[file][operator])
        if (file, number, hurt) in seen:
            continue
        seen.add((file, number, hurt))
        whole = texts[file].split("\n")
        yield {"file": file, "line": number + 1, "operator": operator, "before": whole[number], "after": hurt,
               "nth": whole[:number].count(whole[number])}


def named():
    """The faults that were chosen by hand: (name, file, text, text with the fault)."""
    for name, file, old, new in FAULTS:
        yield {"file": file, "line": 0, "operator": name, "before": old, "after": new, "nth": 0}


def plant(root, fault):
    """The file's text with the fault; None where the line, or the file, is no longer there."""
    if not (root / fault["file"]).exists():
        return None
    if fault["line"] == 0:
        text = (root / fault["file"]).read_text()
        return text.replace(fault["before"], fault["after"]) if text.count(fault["before"]) == 1 else None
    lines = (root / fault["file"]).read_text().split("\n")
    places = [i for i, line in enumerate(lines) if line == fault["before"]]
    if fault["nth"] >= len(places):
        return None
    lines[places[fault["nth"]]] = fault["after"]
    return "\n".join(lines)


# ---- the program under test

class Worker:
    """A child that answers names of checks, as `pelage verify` itself has them."""

    def __init__(self, program, form, surroundings, evidence, limit):
        self.limit = limit
        self.child = subprocess.Popen([program, "verify", "--worker", "--device", "0", "--seed", "1", f"--{form}",
                                       "--evidence", evidence], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                      stderr=subprocess.DEVNULL, env=surroundings, start_new_session=True)
        self.heard = b""

    def ask(self, name):
        """The result; None where the child died, "late" where it took too long."""
        try:
            self.child.stdin.write((name + "\n").encode())
            self.child.stdin.flush()
        except BrokenPipeError:
            return None
        end = time.monotonic() + self.limit
        while True:
            while b"\n" in self.heard:
                line, self.heard = self.heard.split(b"\n", 1)
                if line.startswith(b"pelage-answer "):
                    return json.loads(line[len(b"pelage-answer "):])
            ready, _, _ = select.select([self.child.stdout], [], [], max(0.0, end - time.monotonic()))
            if not ready:
                return "late"
            heard = os.read(self.child.stdout.fileno(), 1 << 16)
            if not heard:
                return None
            self.heard += heard

    def end(self):
        try:
            os.killpg(self.child.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.child.wait()


def in_order(program, form):
    """Names of checks: the first of every kernel, then the second of every one, and so on."""
    listed = subprocess.run([program, "verify", "--list", f"--{form}"], capture_output=True, text=True, check=True)
    turns, known = [], {}
    for line in listed.stdout.splitlines():
        kernel, name = line[:20].strip(), line[20:].strip()
        known[kernel] = known.get(kernel, 0) + 1
        turns.append((known[kernel], len(turns), name))
    return [name for _, _, name in sorted(turns)]


def judge(program, names, form, surroundings, workers, limit):
    """(verdict, name of the check that was first, what it said)"""
    waiting = queue.Queue()
    for name in names:
        waiting.put(name)
    found = []
    over = threading.Event()
    evidence = surroundings["PELAGE_CACHE"] + "/evidence"

    def work():
        worker = Worker(program, form, surroundings, evidence, limit)
        while not over.is_set():
            try:
                name = waiting.get_nowait()
            except queue.Empty:
                break
            result = worker.ask(name)
            if result is None or result == "late":
                found.append(("late", name, f"did not end within {limit} s") if result else ("killed", name, "crashed"))
                over.set()
            elif result["verdict"] in ("failed", "mistrusted"):
                broken = "could not build a program" in result["message"]
                found.append(("stillborn" if broken else "killed", name, (result.get("first") or result.get("first_difference") or result["message"])[:400]))
                over.set()
        worker.end()

    threads = [threading.Thread(target=work) for _ in range(workers)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if any(verdict == "stillborn" for verdict, _, _ in found):
        return next(one for one in found if one[0] == "stillborn")
    return found[0] if found else ("survived", "", "")


class Bench:
    """Where faults are planted and judged."""

    def __init__(self, chosen):
        self.form = chosen.form
        self.workers = chosen.workers
        self.limit = chosen.limit
        self.caught = {}  # by file: names of the checks that caught a fault in it, and how many each
        self.work = chosen.work.resolve()
        self.work.mkdir(parents=True, exist_ok=True)
        self.program = str(chosen.program.resolve())
        self.tree = chosen.tree.resolve() if chosen.tree else None
        self.names = in_order(self.program, self.form)
        self.surroundings = dict(os.environ, PELAGE_CACHE=str(self.work / "cache"),
                                 POCL_CACHE_DIR=str(self.work / "pocl-cache"),
                                 POCL_AFFINITY="0")  # workers beside each other, each on any processor
        self.kernels_of = {}  # by name of a check: the kernel files that its programs are put together of

    def healthy(self):
        return judge(self.program, self.names, self.form, self.surroundings, self.workers, self.limit)

    def find_kernels(self):
        """Each check alone, in a process of its own; the result is kept for the same program."""
        kept, stamp = self.work / "kernels_of.json", [self.program, os.stat(self.program).st_mtime, self.form]
        if kept.exists() and (found := json.loads(kept.read_text()))["stamp"] == stamp:
            self.kernels_of = found["kernels"]
            return
        log = self.work / "kernels.log"
        for name in self.names:
            log.unlink(missing_ok=True)
            judge(self.program, [name], self.form, dict(self.surroundings, PELAGE_KERNELS_LOG=str(log)), 1, self.limit)
            self.kernels_of[name] = sorted(set(log.read_text().split())) if log.exists() else []
        kept.write_text(json.dumps({"stamp": stamp, "kernels": self.kernels_of}))

    def concerned(self, fault):
        """Whether a check can tell: what is compiled without the file is as before."""
        file = fault["file"].removeprefix("kernels/")
        return lambda name: file == fault["file"] or file in self.kernels_of.get(name, [file])

    def learn(self, fault, verdict, name):
        if verdict != "killed":
            return
        counts = self.caught.setdefault(fault["file"], {})
        counts[name] = counts.get(name, 0) + 1

    def likely_first(self, fault):
        """Names of checks: first what caught this fault before, then what caught most in the same file, then LIKELY."""
        counts = self.caught.get(fault["file"], {})
        known = [name for name in [fault.get("by", "")] if name in self.names]
        known += sorted((name for name in counts if name in self.names), key=lambda name: -counts[name])
        beginnings = next((names for path, names in LIKELY if fault["file"].startswith(path)), [])
        likely = [name for beginning in beginnings for name in self.names if re.match(beginning, name)]
        return list(filter(self.concerned(fault), dict.fromkeys(known + likely + self.names)))

    def try_one(self, fault):
        text = plant(ROOT, fault)
        if text is None:
            return "gone", "", ""
        if fault["file"].startswith("kernels/"):
            return self.try_kernel(fault, text)
        return self.try_host(fault, text)

    def try_kernel(self, fault, text):
        folder = self.work / "kernels"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(ROOT / "kernels", folder)
        (self.work / fault["file"]).write_text(text)
        return judge(self.program, self.likely_first(fault), self.form,
                     dict(self.surroundings, PELAGE_KERNELS=str(folder)), self.workers, self.limit)

    def try_host(self, fault, text):
        tree = self.tree or self.copied_tree()
        path = tree / fault["file"]
        healthy = path.read_text()
        try:
            path.write_text(text)
            if not self.build(tree):
                return "stillborn", "", "does not compile"
            return judge(str(self.built(tree) / "pelage"), self.likely_first(fault), self.form, self.surroundings,
                         self.workers, self.limit)
        finally:
            path.write_text(healthy)

    def built(self, tree):
        return tree / "build" / "release"

    def build(self, tree):
        return subprocess.run(["ninja", "-C", self.built(tree), "pelage_command"], capture_output=True).returncode == 0

    def copied_tree(self):
        tree = self.work / "tree"
        for part in ("CMakeLists.txt", "cmake", "host", "reference", "kernels"):
            if (ROOT / part).is_dir():
                shutil.copytree(ROOT / part, tree / part, dirs_exist_ok=True)
            else:
                tree.mkdir(exist_ok=True)
                shutil.copy2(ROOT / part, tree / part)
        if not (self.built(tree) / "build.ninja").exists():
            subprocess.run(["cmake", "-S", tree, "-B", self.built(tree), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                            "-DPELAGE_TESTS=OFF"], check=True, stdout=subprocess.DEVNULL)
        self.tree = tree
        return tree


# ---- the report

def difference(fault):
    lines = difflib.ndiff([fault["before"].strip()], [fault["after"].strip()])
    return "\n".join("        " + line for line in lines if line[0] in "-+")


def summary(results):
    text, files = "", {}
    for one in results:
        counts = files.setdefault(one["file"], {"killed": 0, "survived": 0})
        if one["verdict"] in counts:
            counts[one["verdict"]] += 1
    text += f"{'FILE':<44} {'KILLED':>6} {'SURVIVED':>8}\n"
    for file in sorted(files):
        text += f"{file:<44} {files[file]['killed']:>6} {files[file]['survived']:>8}\n"
    killed = sum(one["verdict"] == "killed" for one in results)
    survived = [one for one in results if one["verdict"] == "survived"]
    text += f"\n{killed} of {killed + len(survived)} killed\n"
    late = sum(one["verdict"] == "late" for one in results)
    if late:
        text += f"{late} not judged: a check did not end; it hangs, or the machine is busy\n"
    for one in survived:
        text += f"\nsurvived: {one['file']}:{one['line']}, {one['operator']}\n{difference(one)}\n"
    return text


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--sample", type=int, default=60, help="faults that can be judged (default 60)")
    options.add_argument("--seed", type=int, default=1, help="of the draw (default 1)")
    options.add_argument("--form", choices=["quick", "full"], default="quick")
    options.add_argument("--only", default="", help="faults in files with this in their name, or one of these between commas")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "pelage")
    options.add_argument("--tree", type=pathlib.Path, help="sources built in build/release, for faults in the host")
    options.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "mutation")
    options.add_argument("--results", type=pathlib.Path, help="default: operators.json in the folder --work")
    options.add_argument("--replay", type=pathlib.Path, help="plant the faults of this file of results again")
    options.add_argument("--workers", type=int, default=2, help="processes at once (default 2)")
    options.add_argument("--limit", type=float, default=90, help="seconds that one check may take (default 90)")
    options.add_argument("--named", action="store_true", help="the faults of faults.py")
    options.add_argument("--summary", action="store_true", help="print what the results say and plant nothing")
    chosen = options.parse_args()
    results_file = chosen.results or chosen.work / "operators.json"
    results = json.loads(results_file.read_text()) if results_file.exists() else []
    if chosen.summary:
        print(summary(results))
        return 0
    bench = Bench(chosen)
    verdict, name, what = bench.healthy()
    if verdict != "survived":
        raise SystemExit(f"without a fault {name} fails already: {what}")
    if not chosen.only.startswith("host/"):  # faults there concern all checks
        bench.find_kernels()
    results = [one for one in results if one["verdict"] != "late"]  # they are tried again
    known = {(one["file"], one["before"], one["after"], one["nth"]): one for one in results}
    faults = named() if chosen.named else json.loads(chosen.replay.read_text()) if chosen.replay else draw(chosen.seed)
    for one in results:
        bench.learn(one, one["verdict"], one["by"])
    judged = 0
    for before in faults:
        if not any(part in before["file"] for part in chosen.only.split(",")):
            continue
        fault = {key: before[key] for key in ("file", "line", "operator", "before", "after", "nth")}
        one = known.get((fault["file"], fault["before"], fault["after"], fault["nth"]))
        if one is None:
            start = time.monotonic()
            verdict, name, what = bench.try_one(dict(fault, by=before.get("by", "")))
            bench.learn(fault, verdict, name)
            one = dict(fault, verdict=verdict, by=name, what=what, seconds=round(time.monotonic() - start, 1))
            results.append(one)
            results_file.write_text(json.dumps(results, indent=1) + "\n")
            print(f"{verdict:<9} {fault['file']}:{fault['line']} ({fault['operator']}) {name} {one['seconds']} s",
                  flush=True)
        judged += one["verdict"] in ("killed", "survived")
        if judged >= chosen.sample and not chosen.replay and not chosen.named:
            break
    print(summary(results))
    return 0 if all(one["verdict"] != "survived" for one in results) else 1


if __name__ == "__main__":
    sys.exit(main())
