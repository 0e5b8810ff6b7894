# cps_commit: the library with source_commit (apps/version.h). Each build looks up the commit, but writes and compiles
# the one small file only when it is another one.
set(commit_file ${CMAKE_BINARY_DIR}/generated/commit.cpp)
add_custom_target(cps_find_commit
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${CMAKE_SOURCE_DIR} -DFILE=${commit_file} -P ${CMAKE_SOURCE_DIR}/cmake/find_commit.cmake
  BYPRODUCTS ${commit_file} VERBATIM)
add_library(cps_commit STATIC ${commit_file})
target_include_directories(cps_commit PRIVATE ${CMAKE_SOURCE_DIR})
add_dependencies(cps_commit cps_find_commit)
