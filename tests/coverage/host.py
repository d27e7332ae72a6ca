"""Which lines of the host's OpenCL backend were run, by the counters that a build with --coverage leaves (gcov)."""

import concurrent.futures
import dataclasses
import json
import pathlib
import re
import subprocess

LOOKED_AT = "host/opencl/"
# No statements: what ends one or a block (what is cleared up there is counted where something is thrown), and heads of types.
NO_CODE = re.compile(r"[\s{}()\];,]*|\s*(class|struct) [^;]*\{")


@dataclasses.dataclass
class File:
    name: str
    text: list  # its lines
    counts: dict = dataclasses.field(default_factory=dict)  # by number of a line with code: how often it was run

    def code(self, number):
        return re.sub(r"\s//.*", "", " " + self.text[number - 1]).strip()

    def ends(self, number):
        """Whether a line ends its statement."""
        text = self.code(number)
        return not text or text[0] == "#" or text[-1] in ";{}:" or number == len(self.text)

    def was_run(self, number):
        """A line whose statement goes on to a line that was run was run, too: compilers count its parts one by one."""
        while self.counts.get(number, 0) == 0 and not self.ends(number):
            number += 1
        return self.counts.get(number, 0) > 0

    def first(self, number):
        """The first line of the statement that a line is part of."""
        while number > 1 and not self.ends(number - 1):
            number -= 1
        return number

    def last(self, number):
        while not self.ends(number):
            number += 1
        return number

    def statement(self, number):
        """The whole statement that a line is part of."""
        return " ".join(self.code(line) for line in range(self.first(number), self.last(number) + 1))

    def heads(self, number):
        """The heads of the blocks around a line, inmost first; its own, where it is one. Goes by indentation."""
        indent = lambda line: len(self.text[line - 1]) - len(self.text[line - 1].lstrip())
        level, found = indent(self.first(number)) + 1, []
        for line in range(self.last(number), 0, -1):
            if self.code(line).endswith("{") and indent(self.first(line)) < level:
                found.append(self.statement(line))
                level = indent(self.first(line))
        return found


def forget(build):
    """Removes what earlier runs counted."""
    for path in build.rglob("*.gcda"):
        path.unlink()


def processes(build):
    """How many processes have added to what is counted."""
    found = [re.search(r"OBJECT_SUMMARY runs=(\d+)", subprocess.run(["gcov-dump", path], check=True, capture_output=True,
                                                                    text=True).stdout)
             for path in build.rglob("*.gcda")]
    return min((int(runs.group(1)) for runs in found if runs), default=0)


def counters(note):
    """What gcov says of one compiled file; without counters of a run, that nothing was run."""
    answer = subprocess.run(["gcov", "--json-format", "--stdout", note.name], cwd=note.parent, check=True,
                            capture_output=True, text=True).stdout
    return [json.loads(line) for line in answer.splitlines() if line.startswith("{")]


def add_counters(files, root, found):
    name = pathlib.PurePath(found["file"])
    if not name.is_relative_to(root) or not name.relative_to(root).as_posix().startswith(LOOKED_AT):
        return
    name = name.relative_to(root).as_posix()
    file = files.setdefault(name, File(name, (root / name).read_text().splitlines()))
    for line in found["lines"]:
        number = line["line_number"]
        if NO_CODE.fullmatch(file.text[number - 1]):
            continue
        file.counts[number] = file.counts.get(number, 0) + line["count"]


def covered_files(root, build):
    """The files of the backend, by name, with the counts of all runs since forget()."""
    files = {}
    with concurrent.futures.ThreadPoolExecutor() as pool:
        for answers in pool.map(counters, sorted(build.rglob("*.gcno"))):
            for answer in answers:
                for found in answer["files"]:
                    add_counters(files, root, found)
    return dict(sorted(files.items()))
