"""Carries out checks of `pelage verify` in processes that are given the time to end: `pelage verify` itself gives them a
few seconds, and one that is killed has not written what it counted."""

import json
import queue
import re
import subprocess
import threading
import time

MARK = b"pelage-answer "  # as in host/app/worker.hpp
NOT_FAILED = ("passed", "skipped")


def names(program, form, text):
    """The checks in whose names the regular expression `text` is found: the first of every kernel, then the second of every one, and so on."""
    listed = subprocess.run([program, "verify", "--list", "--" + form], capture_output=True, text=True, check=True)
    turns, known = [], {}
    for line in listed.stdout.splitlines():
        kernel, name = line[:20].strip(), line[20:].strip()
        known[kernel] = known.get(kernel, 0) + 1
        if re.search(text, name):
            turns.append((known[kernel], len(turns), name))
    return [name for _, _, name in sorted(turns)]


def answer(child, name):
    """The verdict on a check; "died" where the process did."""
    try:
        child.stdin.write((name + "\n").encode())
        child.stdin.flush()
    except BrokenPipeError:
        return "died"
    for line in child.stdout:
        if line.startswith(MARK):
            return json.loads(line.removeprefix(MARK))["verdict"]
    return "died"


def carry_out(program, arguments, wanted, surroundings, jobs, tell, end):
    """Returns the names of the checks that did not pass; tell(name, verdict) is called after each. None is begun later than
    `end` (time.monotonic()).
    """
    waiting, failed = queue.SimpleQueue(), []
    for name in wanted:
        waiting.put(name)

    def work():
        with subprocess.Popen([program, "verify", "--worker", *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, env=surroundings) as child:  # waits for its end
            verdict = ""
            while verdict != "died" and time.monotonic() < end:
                try:
                    name = waiting.get_nowait()
                except queue.Empty:
                    return
                verdict = answer(child, name)
                tell(name, verdict)
                if verdict not in NOT_FAILED:
                    failed.append(name)

    threads = [threading.Thread(target=work) for _ in range(min(jobs, len(wanted)))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    while not waiting.empty() and time.monotonic() < end:  # where every process died
        failed.append(waiting.get())
    return failed
