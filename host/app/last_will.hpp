// What is done when a signal ends the command: its private folder goes with it.
#pragma once

namespace pelage::app {

// For signals that end a process and can be caught, those of crashes among them; the process then ends by them as
// usual. What is ignored stays ignored.
void tidy_when_killed();

}  // namespace pelage::app
