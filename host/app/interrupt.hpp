// Ctrl-C: remembers that SIGINT, SIGTERM, SIGHUP (the terminal is gone) or SIGXCPU (a limit on processor time is
// reached) came, so that a run can stop between two batches.
#pragma once

namespace pelage::app {

// While one lives, the first signal only sets a mark; a second one of the same kind ends the process as usual. Where
// the process goes on for seconds after a first Ctrl-C, a line on standard error tells of the second. What was to be
// said before (when_killed_say()) no longer is: work has begun.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    static bool came();
};

}  // namespace pelage::app
