set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

# The files of a target are compiled eight at a time, so that the templates of JSON, Eigen and Catch2, most of what compiling
# costs, are made once for all eight. -DCMAKE_UNITY_BUILD=OFF compiles each file on its own.
option(CMAKE_UNITY_BUILD "Compile several files of a target at a time" ON)

# One instruction set for every machine and no contraction of a*b+c into fma: a recipe's bytes
# must not depend on which node of a farm rendered them.
add_compile_options(-march=x86-64-v3 -ffp-contract=off -Wall -Wextra)
# GCC 12 reports overlaps and overflows inside std::string and std::vector that no call can reach.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  add_compile_options(-Wno-restrict -Wno-stringop-overflow)
endif()
# Neither changes a result; both let loops with square roots and conditions become vector instructions.
add_compile_options(-fno-math-errno -fno-trapping-math)

option(CPS_SANITIZE "Address and undefined-behaviour sanitizers" OFF)
if(CPS_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
if(CPS_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
