# `cpack --config BUILD/CPackConfig.cmake -G DEB`: the packages cps and, with the trainer, cps-train.

# Who answers for a package: the authors, at the address from which they last wrote who they are, unless the builder
# names himself.
set(CPS_PACKAGE_CONTACT "" CACHE STRING "Maintainer of the packages: Name <address>; empty: the authors in CITATION.cff")
file(STRINGS CITATION.cff author REGEX "^  - name: ")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" author "${author}")
if(NOT CPS_PACKAGE_CONTACT)
  execute_process(COMMAND git log -1 --format=%aE -- CITATION.cff WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                  OUTPUT_VARIABLE address OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT address)
    set(address root@localhost)  # not a checkout
  endif()
  set(CPS_PACKAGE_CONTACT "${author} <${address}>")
endif()

# What Debian's policy wants of every package: copyright, and a changelog with the date of the last entry.
execute_process(COMMAND git log -1 --format=%aD -- CHANGELOG.md WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT date)
  set(date "Thu, 01 Jan 1970 00:00:00 +0000")
endif()
foreach(package IN ITEMS cps cps-train)
  set(folder ${CMAKE_BINARY_DIR}/debian/${package})
  configure_file(cmake/debian/copyright.in ${folder}/copyright @ONLY)
  configure_file(cmake/debian/changelog.in ${folder}/changelog @ONLY)
  execute_process(COMMAND gzip -9n INPUT_FILE ${folder}/changelog OUTPUT_FILE ${folder}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
endforeach()
install(FILES ${CMAKE_BINARY_DIR}/debian/cps/copyright ${CMAKE_BINARY_DIR}/debian/cps/changelog.gz
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/cps COMPONENT core)
if(CPS_TRAINER)
  install(FILES ${CMAKE_BINARY_DIR}/debian/cps-train/copyright ${CMAKE_BINARY_DIR}/debian/cps-train/changelog.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/cps-train COMPONENT trainer)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "${CPS_PACKAGE_CONTACT}")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL core)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CORE_PACKAGE_NAME cps)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_DEBIAN_CORE_DESCRIPTION "make training data for camera calibration
Path-traces city streets from a camera on a car, shows every render through
many Brown-Conrady lenses that are proved one-to-one, and writes datasets of
images with exact labels.")
set(CPACK_DEBIAN_CORE_PACKAGE_DEPENDS fonts-dejavu-core)  # captions of contact sheets
if(CPS_TRAINER)
  list(APPEND CPACK_COMPONENTS_ALL trainer)
  set(CPACK_DEBIAN_TRAINER_PACKAGE_NAME cps-train)
  set(CPACK_DEBIAN_TRAINER_DESCRIPTION "train networks that calibrate cameras from single images
The trainer of cps: trains networks on its datasets, measures them, and runs
them on pictures.")
  set(CPACK_DEBIAN_TRAINER_PACKAGE_DEPENDS "cps (= ${PROJECT_VERSION})")
endif()
include(CPack)
