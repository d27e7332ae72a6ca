# The command and what stands behind it: checks, tuning, benchmarks.
find_package(CLI11 REQUIRED)

# The table of cases, their checks on a device, and what is told about them; used by the command, tests and benchmarks.
file(GLOB verify_sources CONFIGURE_DEPENDS host/verify/*.cpp)
add_library(pelage_verify STATIC ${verify_sources})
target_compile_definitions(pelage_verify PRIVATE PELAGE_VERSION="${PROJECT_VERSION}")
target_link_libraries(pelage_verify PUBLIC pelage pelage_inside OpenCL::OpenCL PRIVATE pelage_flags nlohmann_json::nlohmann_json)

# The search for how a device carries out a lattice fastest.
file(GLOB tune_sources CONFIGURE_DEPENDS host/tune/*.cpp)
add_library(pelage_tune STATIC ${tune_sources})
target_link_libraries(pelage_tune
  PUBLIC pelage_verify pelage OpenCL::OpenCL PRIVATE pelage_flags nlohmann_json::nlohmann_json)

# What patterns are like. KissFFT is a header; it goes as a system header past our warnings.
find_path(PELAGE_KISSFFT kissfft/kissfft.hh REQUIRED)
file(GLOB stats_sources CONFIGURE_DEPENDS host/stats/*.cpp)
add_library(pelage_stats STATIC ${stats_sources})
target_include_directories(pelage_stats SYSTEM PRIVATE ${PELAGE_KISSFFT})
target_link_libraries(pelage_stats PUBLIC pelage pelage_inside PRIVATE pelage_flags)

# Several processes that share a task. What speaks MPI is a module that is opened where they are started: nobody else
# needs it.
add_library(pelage_cluster STATIC host/cluster/join.cpp host/cluster/together.cpp)
target_link_libraries(pelage_cluster PUBLIC pelage pelage_inside PRIVATE pelage_flags ${CMAKE_DL_LIBS})
find_package(MPI COMPONENTS CXX)
if(MPI_CXX_FOUND)
  add_library(pelage_mpi MODULE host/cluster/mpi.cpp)
  set_target_properties(pelage_mpi PROPERTIES OUTPUT_NAME pelage-mpi PREFIX "")
  target_compile_definitions(pelage_mpi PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
  target_link_libraries(pelage_mpi PRIVATE pelage_inside pelage_flags MPI::MPI_CXX)
else()
  message(STATUS "Without MPI there is no pelage-mpi.so: `mpirun pelage sweep` will say so")
endif()

# Experiments at many values of their parameters.
file(GLOB sweep_sources CONFIGURE_DEPENDS host/sweep/*.cpp)
add_library(pelage_sweep STATIC ${sweep_sources})
target_link_libraries(pelage_sweep PUBLIC pelage_cluster pelage_stats pelage pelage_inside PRIVATE pelage_flags)

# Textures learned from pictures.
file(GLOB learn_sources CONFIGURE_DEPENDS host/learn/*.cpp)
add_library(pelage_learn STATIC ${learn_sources})
target_link_libraries(pelage_learn PUBLIC pelage pelage_inside PRIVATE pelage_flags nlohmann_json::nlohmann_json)
pelage_unite(pelage_learn)

# Experiments made of other programs' files.
find_package(EXPAT REQUIRED)
find_package(ZLIB REQUIRED)
file(GLOB import_sources CONFIGURE_DEPENDS host/import/*.cpp)
add_library(pelage_import STATIC ${import_sources})
target_link_libraries(pelage_import
  PUBLIC pelage pelage_inside PRIVATE pelage_flags nlohmann_json::nlohmann_json EXPAT::EXPAT ZLIB::ZLIB)

include(cmake/Bench.cmake)

# The command: all but main() in a library, so that tests can call its parts.
file(GLOB app_sources CONFIGURE_DEPENDS host/app/*.cpp)
list(REMOVE_ITEM app_sources ${PROJECT_SOURCE_DIR}/host/app/main.cpp)
add_library(pelage_app STATIC ${app_sources})
target_compile_definitions(pelage_app PRIVATE PELAGE_VERSION="${PROJECT_VERSION}")
target_link_libraries(pelage_app PUBLIC pelage_import pelage_learn pelage_tune pelage_verify pelage_bench pelage_sweep pelage_stats pelage CLI11::CLI11 PRIVATE pelage_flags nlohmann_json::nlohmann_json)
add_executable(pelage_command host/app/main.cpp)
set_target_properties(pelage_command PROPERTIES OUTPUT_NAME pelage)
target_compile_definitions(pelage_command PRIVATE PELAGE_VERSION="${PROJECT_VERSION}")
target_link_libraries(pelage_command PRIVATE pelage_app pelage_flags)

# Every file that knows the parser of the command line takes seconds to read it: they are compiled in one go.
if(NOT CMAKE_UNITY_BUILD)
  set_target_properties(pelage_app PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(name bench_command check_command command_line completion completion_command devices_command help_command import_command learn_command manual
      measure_command options_of run_command sweep_command tune_command validators verify_command)
    set_source_files_properties(host/app/${name}.cpp PROPERTIES UNITY_GROUP command_line)
  endforeach()
endif()

# What takes time at run time is in the library and in the benchmarks' baselines; here it is compiling.
foreach(target pelage_import pelage_verify pelage_tune pelage_stats pelage_cluster pelage_sweep pelage_app pelage_command)
  pelage_unite(${target})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endforeach()
