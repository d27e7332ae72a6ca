# The library behind `pelage bench`. OpenMP serves its hand-written baseline alone and may be absent.
find_package(OpenMP COMPONENTS CXX)

file(GLOB bench_sources CONFIGURE_DEPENDS host/bench/*.cpp)
add_library(pelage_bench STATIC ${bench_sources})
target_compile_definitions(pelage_bench PRIVATE PELAGE_VERSION="${PROJECT_VERSION}")
target_link_libraries(pelage_bench
  PUBLIC pelage pelage_inside OpenCL::OpenCL nlohmann_json::nlohmann_json
  PRIVATE pelage_flags nanoflann::nanoflann)
pelage_unite(pelage_bench)
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
set_source_files_properties(host/bench/openmp_rows.cpp host/bench/openmp_charges.cpp
  host/bench/openmp_network.cpp PROPERTIES COMPILE_OPTIONS "${row_flags}")

# Draws what `pelage bench` measured. A program of its own beside the command: nobody else needs cairo.
find_path(CAIRO_INCLUDE_DIR cairo.h PATH_SUFFIXES cairo)
find_library(CAIRO_LIBRARY cairo)
if(CAIRO_INCLUDE_DIR AND CAIRO_LIBRARY)
  add_executable(pelage_plot host/plot/canvas.cpp host/plot/curve.cpp host/plot/plot.cpp host/plot/sheet.cpp host/plot/text.cpp host/plot/main.cpp)
  set_target_properties(pelage_plot PROPERTIES OUTPUT_NAME pelage-plot)
  target_include_directories(pelage_plot SYSTEM PRIVATE ${CAIRO_INCLUDE_DIR})
  target_link_libraries(pelage_plot PRIVATE pelage_bench pelage_flags ${CAIRO_LIBRARY})
  pelage_unite(pelage_plot)
else()
  message(STATUS "Without cairo there is no pelage-plot: `pelage bench --plot` will say so")
endif()

option(PELAGE_BENCH "Build the micro benchmarks (Google Benchmark)" OFF)
if(PELAGE_BENCH)
  add_subdirectory(bench)
endif()
