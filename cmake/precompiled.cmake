# Headers parsed once. Parsing Eigen, OpenImageIO, JSON and Catch2 is most of what compiling a file costs, so each kind of
# target has them precompiled. Files still include what they use: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
set(CPS_STANDARD_HEADERS
  <algorithm> <array> <atomic> <cmath> <cstdint> <exception> <filesystem> <fstream> <functional> <iostream>
  <limits> <map> <memory> <mutex> <numbers> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view>
  <utility> <variant> <vector>)
set(CPS_PACKAGE_HEADERS
  <Eigen/Dense> <OpenImageIO/imagebuf.h> <nlohmann/json.hpp>)

# cps_headers(NAME LINK target … HEADERS <h> …): an empty library whose precompiled headers other targets reuse.
function(cps_headers name)
  cmake_parse_arguments(HEADERS "" "" "LINK;HEADERS" ${ARGN})
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp CONTENT "")  # unlike WRITE, leaves an equal file alone
  add_library(cps_${name} OBJECT ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp)
  target_link_libraries(cps_${name} PRIVATE ${HEADERS_LINK})
  target_precompile_headers(cps_${name} PRIVATE ${CPS_STANDARD_HEADERS} ${HEADERS_HEADERS})
endfunction()

set(packages Eigen3::Eigen OpenImageIO::OpenImageIO)
# For rooms in which few files see pictures or JSON: reading a set takes time, too, in proportion to its size.
cps_headers(core_headers LINK Eigen3::Eigen HEADERS <Eigen/Dense>)
cps_headers(room_headers LINK ${packages} HEADERS ${CPS_PACKAGE_HEADERS})
if(CPS_TESTS)
  find_path(CATCH2_INCLUDE_DIR catch2/catch.hpp REQUIRED)
  cps_headers(test_headers LINK ${packages} HEADERS ${CPS_PACKAGE_HEADERS} <catch2/catch.hpp>)
endif()
if(CPS_TRAINER)
  # A set for the few files that see LibTorch, in the room and in its tests: reading LibTorch's headers takes longer
  # than reading all others together. A second set with Catch2 would cost more to build than its few users save.
  find_package(Torch REQUIRED GLOBAL)
  cps_headers(torch_headers LINK ${packages} torch
    HEADERS ${CPS_PACKAGE_HEADERS} <torch/types.h> <torch/nn/module.h>)
endif()
