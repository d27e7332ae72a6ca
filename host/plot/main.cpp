// pelage-plot: draws what `pelage bench --json` wrote, contact sheets of `pelage sweep`, and loss curves of `pelage
// learn`. A program of its own, so that the command needs no cairo.
#include "bench/report_read.hpp"
#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "plot/curve.hpp"
#include "plot/plot.hpp"
#include "plot/sheet.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs(
            "Usage: pelage-plot RESULTS.json PICTURE.png\n"
            "Draws PICTURE.roofline.png and PICTURE.scaling.png of what `pelage bench --json` wrote, or the contact "
            "sheet\n"
            "PICTURE.png, .svg or .pdf of what `pelage sweep` says of its tiles, or the loss curve PICTURE.png of "
            "`pelage "
            "learn`.\n",
            stderr);
        return 2;
    }
    try {
        std::error_code none_there;
        if (std::filesystem::equivalent(argv[1], argv[2], none_there))
            throw pelage::Error(std::string(argv[2]) + " is what is drawn; name another file");
        const nlohmann::json what = nlohmann::json::parse(pelage::read_file(argv[1]));
        if (what.contains("mosaic"))
            pelage::plot::draw_sheet(what, argv[2]);
        else if (what.contains("curve"))
            pelage::bench::draw_curve(what.at("curve"), argv[2]);
        else
            pelage::bench::plot(pelage::bench::read_report(argv[1]), argv[2]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pelage-plot: %s\n", error.what());
        return 2;
    }
}
