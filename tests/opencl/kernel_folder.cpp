// Kernels read from a folder, for who plants faults in them.
#include "opencl/device/kernel_sources.hpp"

#include "core/error.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using Catch::Matchers::Contains;

TEST_CASE("kernels of a folder take the place of the embedded ones, all of them or none") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "pelage-test-kernels";
    std::filesystem::remove_all(folder);
    for (const auto& [name, text] : pelage::embedded_kernels()) {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text << (name == "lattice/step.cl" ? "// a fault\n" : "");
    }

    const auto read = pelage::read_kernels(folder);
    CHECK(read.size() == pelage::embedded_kernels().size());
    CHECK(read.at("lattice/rows.cl") == pelage::embedded_kernels().at("lattice/rows.cl"));
    CHECK(read.at("lattice/step.cl") == pelage::embedded_kernels().at("lattice/step.cl") + "// a fault\n");

    std::filesystem::remove(folder / "models/turing.cl");
    CHECK_THROWS_WITH(pelage::read_kernels(folder), Contains("models/turing.cl") && Contains("cannot be read"));
    std::filesystem::remove_all(folder);
}
