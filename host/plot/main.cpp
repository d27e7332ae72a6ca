// pelage-plot: draws what `pelage bench --json` wrote. A program of its own, so that the command needs no cairo.
#include "bench/report_read.hpp"
#include "plot/plot.hpp"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs(
            "Usage: pelage-plot RESULTS.json PICTURE.png\n"
            "Draws PICTURE.roofline.png and PICTURE.scaling.png of what `pelage bench --json` wrote.\n",
            stderr);
        return 2;
    }
    try {
        pelage::bench::plot(pelage::bench::read_report(argv[1]), argv[2]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pelage-plot: %s\n", error.what());
        return 2;
    }
}
