# cps_room(NAME SOURCES a.cpp … LINK target … [HEADERS set]): the library cps_NAME. Its link list is the list of
# rooms and packages it may use; includes are written from the repository's root ("room/file.h"). HEADERS: the set of
# precompiled headers (precompiled.cmake), room_headers unless it is given.
function(cps_room name)
  cmake_parse_arguments(ROOM "OWN_HEADERS" "HEADERS" "SOURCES;LINK" ${ARGN})
  if(NOT ROOM_HEADERS)
    set(ROOM_HEADERS room_headers)
  endif()
  if(ROOM_SOURCES)
    add_library(cps_${name} STATIC ${ROOM_SOURCES})
    set(scope PUBLIC)
  else()
    add_library(cps_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(cps_${name} ${scope} ${CMAKE_SOURCE_DIR})
  target_link_libraries(cps_${name} ${scope} ${ROOM_LINK})
  if(ROOM_SOURCES AND NOT ROOM_OWN_HEADERS)
    target_precompile_headers(cps_${name} REUSE_FROM cps_${ROOM_HEADERS})
  endif()
endfunction()

# Everything that ctest runs; `all` also builds the benchmarks.
add_custom_target(cps_tests)
add_custom_target(cps_benches)

# cps_test(NAME SOURCES … LINK … [SLOW_MINUTES n] [SLOW_ALONE]): one Catch2 program per room. SLOW_MINUTES adds the cases tagged
# [slow] as a second test, labelled slow, which only `./dev test --all` runs; it takes about so many minutes on two cores, and
# those that take longest begin first. Hidden cases ([.name]) run by name only. SLOW_ALONE: the slow cases have time limits, so
# that no other test runs beside them.
function(cps_test name)
  cmake_parse_arguments(TEST "OWN_HEADERS;SLOW_ALONE" "SLOW_MINUTES" "SOURCES;LINK" ${ARGN})
  add_executable(test_${name} ${TEST_SOURCES})
  target_link_libraries(test_${name} PRIVATE cps_catch_main ${TEST_LINK})
  if(NOT TEST_OWN_HEADERS)
    target_precompile_headers(test_${name} REUSE_FROM cps_test_headers)
  endif()
  add_dependencies(cps_tests test_${name})
  add_test(NAME ${name} COMMAND test_${name} "~[slow]~[.]" --warn NoTests)
  set_tests_properties(${name} PROPERTIES TIMEOUT 1800)
  if(TEST_SLOW_MINUTES)
    add_test(NAME ${name}_slow COMMAND test_${name} "[slow]~[.]" --warn NoTests)
    set_tests_properties(${name}_slow PROPERTIES LABELS slow COST ${TEST_SLOW_MINUTES} TIMEOUT 7200
                         RUN_SERIAL ${TEST_SLOW_ALONE})
  endif()
endfunction()

# cps_bench(NAME SOURCES … LINK … [HEADERS set]): one program of the benchmarks. HEADERS: as for cps_room.
function(cps_bench name)
  cmake_parse_arguments(BENCH "" "HEADERS" "SOURCES;LINK" ${ARGN})
  if(NOT BENCH_HEADERS)
    set(BENCH_HEADERS room_headers)
  endif()
  add_executable(${name} ${BENCH_SOURCES})
  target_link_libraries(${name} PRIVATE ${BENCH_LINK})
  target_precompile_headers(${name} REUSE_FROM cps_${BENCH_HEADERS})
  add_dependencies(cps_benches ${name})
endfunction()
