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
  file(WRITE ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp "")
  add_library(cps_${name} OBJECT ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp)
  target_link_libraries(cps_${name} PRIVATE ${HEADERS_LINK})
  target_precompile_headers(cps_${name} PRIVATE ${CPS_STANDARD_HEADERS} ${HEADERS_HEADERS})
endfunction()

set(packages Eigen3::Eigen OpenImageIO::OpenImageIO)
cps_headers(room_headers LINK ${packages} HEADERS ${CPS_PACKAGE_HEADERS})
if(CPS_TESTS)
  find_path(CATCH2_INCLUDE_DIR catch2/catch.hpp REQUIRED)
  cps_headers(test_headers LINK ${packages} HEADERS ${CPS_PACKAGE_HEADERS} <catch2/catch.hpp>)
endif()
if(CPS_TRAINER)
  # Two sets of their own, for the few files that see LibTorch: its headers take longer to read than all others together.
  find_package(Torch REQUIRED GLOBAL)
  set(CPS_TORCH_HEADERS <torch/types.h> <torch/nn/module.h>)
  cps_headers(torch_headers LINK ${packages} torch HEADERS ${CPS_PACKAGE_HEADERS} ${CPS_TORCH_HEADERS})
  if(CPS_TESTS)
    cps_headers(torch_test_headers LINK ${packages} torch
      HEADERS ${CPS_PACKAGE_HEADERS} ${CPS_TORCH_HEADERS} <catch2/catch.hpp>)
  endif()
endif()
