// How long another process has had a processor.
#pragma once

#include <sys/types.h>

namespace pelage::app {

double processor_seconds(pid_t process);  // 0 where there is no such process

}  // namespace pelage::app
