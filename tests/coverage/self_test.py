#!/usr/bin/env python3
"""The tool of this folder tells what was run from what was not, and the exceptions name what there is."""

import fnmatch
import pathlib
import re
import subprocess
import tempfile
import unittest

import exceptions
import host
import kernels
import run

ROOT = pathlib.Path(__file__).resolve().parents[2]

KERNEL = """// A kernel.
#ifdef WIDE
#define STEP \\
#4
int wide;
#elif defined(PELAGE_DOUBLE)
int narrow;
#endif
kernel void pelage_one(global int* a) {
    //@ rules
    //@ finish
}
kernel void pelage_two(global int* a) {}
"""

PROGRAM = """#include <cstdlib>
int taken(int argc) {
    if (argc > 1)
        return std::abs(
            argc);
    return 0;
}
int never() { return 3; }
int main(int argc, char**) { return taken(argc); }
"""


class Kernels(unittest.TestCase):
    def used(self, options, launched=()):
        with tempfile.TemporaryDirectory() as folder:
            source, marked, log = (pathlib.Path(folder) / name for name in ("source", "marked", "log"))
            for path in (source, log):
                path.mkdir()
            (source / "one.cl").write_text(KERNEL)
            parts = kernels.mark(source, marked)
            text = (marked / "one.cl").read_text()
            text = text.replace("    //@ rules\n", "a[0] = 1;\n").replace("    //@ finish\n", "// nothing\n")
            (log / "0.cl").write_text(f"// {options}\n{text}")
            for name in launched:
                (log / f"{name}.launched").touch()
            return {(part.kind, part.line, part.text) for part in kernels.used_parts(parts, log) if part.used}

    def test_branches(self):
        self.assertIn(("branch", 2, "#ifdef WIDE"), self.used("-cl-std=CL1.2 -DWIDE"))
        self.assertNotIn(("branch", 6, "#elif defined(PELAGE_DOUBLE) of #ifdef WIDE"), self.used("-DWIDE"))
        self.assertIn(("branch", 6, "#elif defined(PELAGE_DOUBLE) of #ifdef WIDE"), self.used("-DPELAGE_DOUBLE"))
        self.assertIn(("branch", 8, "#else, of #ifdef WIDE"), self.used(""))
        self.assertNotIn(("branch", 8, "#else, of #ifdef WIDE"), self.used("-DWIDE"))

    def test_places(self):
        found = self.used("-DWIDE")
        self.assertIn(("place", 10, "//@ rules"), found)
        self.assertNotIn(("place", 11, "//@ finish"), found)
        self.assertIn(("file", 1, "one.cl"), found)

    def test_launches(self):
        self.assertEqual({("kernel", 9, "pelage_one")},
                         {part for part in self.used("", ["pelage_one"]) if part[0] == "kernel"})

    def test_all_kernels_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            parts = kernels.mark(ROOT / "kernels", pathlib.Path(folder))
        words = sum(len(re.findall(r"^(?:__)?kernel\b", path.read_text(), re.M))
                    for path in (ROOT / "kernels").rglob("*.cl"))
        self.assertEqual(words, sum(part.kind == "kernel" for part in parts))


class Host(unittest.TestCase):
    def test_lines(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            source = root / host.LOOKED_AT / "one.cpp"
            source.parent.mkdir(parents=True)
            source.write_text(PROGRAM)
            subprocess.run(["g++", "--coverage", "-fprofile-abs-path", "-c", source, "-o", "one.o"], cwd=root, check=True)
            subprocess.run(["g++", "--coverage", "one.o", "-o", "one"], cwd=root, check=True)
            self.assertEqual(0, sum(self.file(root).counts.values()))  # nothing was run
            subprocess.run(["./one"], cwd=root, check=True)
            subprocess.run(["./one"], cwd=root, check=True)
            file = self.file(root)
            self.assertEqual((2, 0, 2), (file.counts[3], sum(file.counts.get(line, 0) for line in (4, 5)), file.counts[6]))
            self.assertEqual(0, file.counts[8])
            self.assertEqual(2, host.processes(root))
            self.assertFalse(file.was_run(8))
            self.assertTrue(file.was_run(3))
            self.assertEqual("if (argc > 1) return std::abs( argc);", file.statement(5))
            self.assertEqual(["int taken(int argc) {"], file.heads(5))
            host.forget(root)
            self.assertEqual(0, host.processes(root))
            self.assertEqual(0, sum(self.file(root).counts.values()))

    def file(self, root):
        return host.covered_files(root, root)[host.LOOKED_AT + "one.cpp"]


class Exceptions(unittest.TestCase):
    def test_of_the_host(self):
        sources = [path for path in (ROOT / host.LOOKED_AT).rglob("*.?pp")]
        files = [host.File(path.relative_to(ROOT).as_posix(), path.read_text().splitlines()) for path in sources]
        for row in exceptions.HOST:
            there = any(fnmatch.fnmatch(file.name, row[0])
                        and any(run.line_fits(file, number)(*row[:2]) for number in range(1, len(file.text) + 1))
                        for file in files)
            self.assertTrue(there, f"no file {row[0]} has anything like '{row[1]}'")
            self.assertTrue(row[2].strip())

    def test_of_the_kernels(self):
        with tempfile.TemporaryDirectory() as folder:
            parts = kernels.mark(ROOT / "kernels", pathlib.Path(folder))
        for file, kind, text, reason in exceptions.KERNELS:
            there = any(part.file == file and part.kind == kind and re.search(text, part.text) for part in parts)
            self.assertTrue(there, f"{file} has no {kind} like '{text}'")
            self.assertTrue(reason.strip())


if __name__ == "__main__":
    unittest.main()
