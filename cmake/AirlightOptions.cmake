# What a builder may choose, and the compiler flags that follow.

option(AIRLIGHT_TESTS "Build the tests" ON)
option(AIRLIGHT_BENCHMARKS "Build the benchmarks (Google Benchmark)" OFF)
option(AIRLIGHT_FUZZERS "Build the libFuzzer targets (clang only)" OFF)
option(AIRLIGHT_GPU "Build what needs OpenGL; without it everything else still builds and tests" ON)
option(AIRLIGHT_MPI "Let fits run on many machines (mpirun); needs packages/debian-mpi.txt" OFF)
option(AIRLIGHT_WERROR "Treat warnings as errors" OFF)
set(AIRLIGHT_ISA "auto" CACHE STRING "Instruction set: auto (this machine's), x86-64-v3, or plain")
set_property(CACHE AIRLIGHT_ISA PROPERTY STRINGS auto x86-64-v3 plain)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo" FORCE)
endif()

# "auto" asks whether this machine runs AVX2 and FMA; a cross build or an old machine gets the plain set.
if(AIRLIGHT_ISA STREQUAL "auto" AND NOT DEFINED AIRLIGHT_HAS_V3)
  include(CheckCXXSourceRuns)
  check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") ? 0 : 1; }"
                        AIRLIGHT_HAS_V3)
endif()

# One target carries the flags of every translation unit of this project; it is never installed.
add_library(airlight_flags INTERFACE)
# Contraction off: the CPU's float must match the GPU's (docs/decisions/0002-one-text.md).
target_compile_options(airlight_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
  -ffp-contract=off -fno-math-errno -fno-trapping-math)
# Clang 14 warns of an array of structs whose inner braces are left out, which the standard allows and tables of data use.
target_compile_options(airlight_flags INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-missing-braces>)
if(AIRLIGHT_WERROR)
  target_compile_options(airlight_flags INTERFACE -Werror)
endif()
if(AIRLIGHT_ISA STREQUAL "x86-64-v3" OR (AIRLIGHT_ISA STREQUAL "auto" AND AIRLIGHT_HAS_V3))
  target_compile_options(airlight_flags INTERFACE -march=x86-64-v3)
endif()

# For files with inner loops over wavelengths, which are of constant length: no NaN arises in them, and without the first two the
# exponential of spectra is not vectorised. What g++ 12 vectorises beyond such loops is mostly shuffles: airlight's rays took twice
# as long.
set(AIRLIGHT_INNER_LOOPS -O3 -fno-signed-zeros -ffinite-math-only $<$<CXX_COMPILER_ID:GNU>:-fvect-cost-model=very-cheap>)
