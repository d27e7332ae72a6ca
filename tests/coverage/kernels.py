"""Which parts of the kernels were in programs that ran: branches of `#if`, places that begin with //@, files, kernels.

`mark()` copies kernels/ and puts comments at the begin of every branch, also of the empty one that an `#if` without
`#else` has, and around every place that is filled in. The program reads that copy (PELAGE_KERNELS) and leaves the text
of each program it uses (PELAGE_PROGRAMS_LOG). The preprocessor keeps the comments of the branches that are taken.
"""

import concurrent.futures
import dataclasses
import pathlib
import re
import subprocess

NOT_MARKED = ["pocl/builtins.cl"]  # declarations that stand before a program, not in it


@dataclasses.dataclass(frozen=True)
class Part:
    file: str  # as kernels/...
    line: int
    kind: str  # file, branch, place or kernel
    text: str
    used: bool = False


def directive(line):
    found = re.match(r"\s*#\s*(ifdef|ifndef|if|elif|else|endif)\b", line)
    return found.group(1) if found else ""


class Marker:
    """Marks the text of one file; the parts found are appended to `parts`, whose places are the marks' numbers."""

    def __init__(self, name, parts):
        self.name = name
        self.parts = parts
        self.open = []  # of each #if around a line: its text, and whether an #else came

    def part(self, number, kind, text):
        self.parts.append(Part("kernels/" + self.name, number, kind, text.strip()))
        return len(self.parts) - 1

    def branch(self, number, line):
        return f"/*@{self.part(number, 'branch', line)}*/\n"

    def conditional(self, number, line):
        what = directive(line)
        if what == "endif":
            begun, has_else = self.open.pop()
            return line if has_else else "#else\n" + self.branch(number, "#else, of " + begun.strip()) + line
        if what in ("if", "ifdef", "ifndef"):
            self.open.append((line, False))
        elif what == "else":
            self.open[-1] = (self.open[-1][0], True)
        more = " of " + self.open[-1][0].strip() if what in ("else", "elif") else ""
        return line + self.branch(number, line.strip() + more)

    def marked(self, text):
        done, goes_on = "", False
        for number, line in enumerate(text.splitlines(keepends=True), 1):
            if not goes_on and directive(line):
                done += self.conditional(number, line)
            elif number > 1 and re.match(r"\s*//@ \w+$", line):
                mark = self.part(number, "place", line)
                done += f"/*@{mark}*/\n{line}/*@{mark}.*/\n"
            else:
                done += line
            goes_on = line.endswith("\\\n")
            if number == 1:
                done += f"/*@{self.part(1, 'file', self.name)}*/\n"
        return done


def kernels_in(text):
    for number, line in enumerate(text.splitlines(), 1):
        if found := re.match(r"(?:__)?kernel\b.*?\bvoid (\w+)", line):
            yield number, found.group(1)


def mark(source, target):
    """Writes the marked copy of the folder `source` and returns its parts."""
    parts = []
    for path in sorted(source.rglob("*.cl")):
        name, text = path.relative_to(source).as_posix(), path.read_text()
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        if name not in NOT_MARKED:
            text = Marker(name, parts).marked(text)
            parts += [Part("kernels/" + name, number, "kernel", kernel) for number, kernel in kernels_in(path.read_text())]
        (target / name).write_text(text)
    return parts


def marks_of(program):
    """Numbers of the parts that a program's text has, as its compiler (clang, PoCL's) reads it."""
    options = re.findall(r"-D\S+", program.read_text().split("\n", 1)[0])
    text = subprocess.run(["gcc", "-E", "-P", "-C", "-undef", "-nostdinc", "-x", "c", "-D__clang__=1", *options, program],
                          check=True, capture_output=True, text=True).stdout
    marks = set()
    for found in re.finditer(r"/\*@(\d+)\*/", text):
        number = found.group(1)
        end = text.find(f"/*@{number}.*/", found.end())
        filled = end < 0 or re.sub(r"/\*.*?\*/|//[^\n]*", "", text[found.end():end], flags=re.S).strip()
        if filled:
            marks.add(int(number))
    return marks


def used_parts(parts, log):
    """The same parts, with what the programs in the folder `log` used."""
    programs = sorted(log.glob("*.cl"))
    with concurrent.futures.ThreadPoolExecutor() as pool:
        marks = set().union(*pool.map(marks_of, programs))
    launched = {path.stem for path in log.glob("*.launched")}
    return [dataclasses.replace(part, used=part.text in launched if part.kind == "kernel" else number in marks)
            for number, part in enumerate(parts)]
