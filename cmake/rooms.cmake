# cps_room(NAME SOURCES a.cpp … LINK target …): the library cps_NAME. Its link list is the list of
# rooms and packages it may use; includes are written from the repository's root ("room/file.h").
function(cps_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINK" ${ARGN})
  if(ROOM_SOURCES)
    add_library(cps_${name} STATIC ${ROOM_SOURCES})
    set(scope PUBLIC)
  else()
    add_library(cps_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(cps_${name} ${scope} ${CMAKE_SOURCE_DIR})
  target_link_libraries(cps_${name} ${scope} ${ROOM_LINK})
endfunction()

# cps_test(NAME SOURCES … LINK … [SLOW]): one Catch2 program per room. SLOW adds the cases tagged
# [slow] as a second test, labelled slow, that only `./dev test --all` runs.
function(cps_test name)
  cmake_parse_arguments(TEST "SLOW" "" "SOURCES;LINK" ${ARGN})
  add_executable(test_${name} ${TEST_SOURCES})
  target_link_libraries(test_${name} PRIVATE cps_catch_main ${TEST_LINK})
  add_test(NAME ${name} COMMAND test_${name} "~[slow]" --warn NoTests)
  set_tests_properties(${name} PROPERTIES TIMEOUT 900)
  if(TEST_SLOW)
    add_test(NAME ${name}_slow COMMAND test_${name} "[slow]" --warn NoTests)
    set_tests_properties(${name}_slow PROPERTIES LABELS slow TIMEOUT 7200)
  endif()
endfunction()
