// What is done when a signal or want of memory ends the command: its private folder goes with it.
#pragma once

namespace pelage::app {

// Signals that are ignored by now are blocked too, in every thread to come: a driver may put a handler of its own in
// the place of what the user has chosen (nohup), as LLVM does. To be called before any thread is there.
void keep_ignored();

// For signals that end a process and can be caught, those of crashes among them; the process then ends by them as
// usual, or, where its size is limited and a driver crashes, with a sentence and exit code 2. What is ignored stays
// ignored. Where `new` fails after drivers were loaded, the process ends at once, with a sentence and exit code 2.
void tidy_when_killed();

// What such a signal, but for a crash, makes the process say; null: nothing. The words must live to the end.
void when_killed_say(const char* words);

// The file that such a signal removes; null: none. The name must live as long as it is known here.
void when_killed_remove(const char* file);

// For a child process: it ends in the same way when its parent does.
void end_with_parent();

}  // namespace pelage::app
