# The library behind `pelage bench`. OpenMP serves its hand-written baseline alone and may be absent.
find_package(OpenMP COMPONENTS CXX)
find_path(CAIRO_INCLUDE_DIR cairo.h PATH_SUFFIXES cairo REQUIRED)
find_library(CAIRO_LIBRARY cairo REQUIRED)

file(GLOB bench_sources CONFIGURE_DEPENDS host/bench/*.cpp)
add_library(pelage_bench STATIC ${bench_sources})
target_include_directories(pelage_bench SYSTEM PRIVATE ${CAIRO_INCLUDE_DIR})
target_compile_definitions(pelage_bench PRIVATE PELAGE_VERSION="${PROJECT_VERSION}")
target_link_libraries(pelage_bench
  PUBLIC pelage OpenCL::OpenCL nlohmann_json::nlohmann_json
  PRIVATE pelage_flags nanoflann::nanoflann ${CAIRO_LIBRARY})
if(OpenMP_CXX_FOUND)
  target_link_libraries(pelage_bench PRIVATE OpenMP::OpenMP_CXX)
else()
  target_compile_options(pelage_bench PRIVATE -Wno-unknown-pragmas)
endif()
# Neither of the first two changes a value: sqrt sets no errno, and a lane that is masked out may divide by zero. The
# others let gcc gather and use vectors of 512 bits where the processor has them.
set(row_flags -fno-math-errno -fno-trapping-math)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  list(APPEND row_flags -mtune=icelake-server -mprefer-vector-width=512)
elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  list(APPEND row_flags -Wno-pass-failed)
endif()
set_source_files_properties(host/bench/openmp_rows.cpp PROPERTIES COMPILE_OPTIONS "${row_flags}"
  SKIP_PRECOMPILE_HEADERS ON)
pelage_precompile(pelage_bench <algorithm> <cmath> <functional> <map> <memory> <optional> <string> <variant> <vector>
  <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp>)

option(PELAGE_BENCH "Build the micro benchmarks (Google Benchmark)" OFF)
if(PELAGE_BENCH)
  add_subdirectory(bench)
endif()
