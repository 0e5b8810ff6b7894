# `cmake --install BUILD [--component core]`, `cpack --config BUILD/CPackConfig.cmake -G DEB`. Two components: core is what a
# render node needs; trainer is cps-train, the only program that links LibTorch.
include(GNUInstallDirs)

set(share ${CMAKE_INSTALL_DATADIR}/cps)
set(doc ${CMAKE_INSTALL_DOCDIR})
install(TARGETS cps RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT core)
install(DIRECTORY sampler/recipes DESTINATION ${share} COMPONENT core)
install(DIRECTORY apps/slurm apps/kubernetes apps/aws-batch DESTINATION ${share} COMPONENT core USE_SOURCE_PERMISSIONS
        PATTERN "*.1" EXCLUDE)
file(CREATE_LINK ../share/cps/slurm/cps-slurm ${CMAKE_BINARY_DIR}/cps-slurm SYMBOLIC)
install(FILES ${CMAKE_BINARY_DIR}/cps-slurm DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT core)
install(DIRECTORY docs/ DESTINATION ${doc} COMPONENT core)
install(FILES README.md CHANGELOG.md DESTINATION ${doc} COMPONENT core)
install(FILES LICENSE DESTINATION ${doc} RENAME copyright COMPONENT core)
if(CPS_TRAINER)
  # Beside cps, where cps looks for it.
  install(TARGETS cps-train RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT trainer)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/cps-train RENAME copyright COMPONENT trainer)
endif()

# The same place relative to the program in the build tree, so that recipes are found by name there too.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/cps)
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/sampler/recipes ${CMAKE_BINARY_DIR}/share/cps/recipes SYMBOLIC)

# Takes away what `cmake --install` put there.
add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -DBUILD=${CMAKE_BINARY_DIR} -P ${CMAKE_SOURCE_DIR}/cmake/uninstall.cmake)

# Who answers for a package: the authors, at the address from which they last wrote who they are, unless the builder
# names himself.
set(CPS_PACKAGE_CONTACT "" CACHE STRING "Maintainer of the packages: Name <address>; empty: the authors in CITATION.cff")
if(NOT CPS_PACKAGE_CONTACT)
  file(STRINGS CITATION.cff author REGEX "^  - name: ")
  string(REGEX REPLACE ".*\"(.*)\".*" "\\1" author "${author}")
  execute_process(COMMAND git log -1 --format=%aE -- CITATION.cff WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                  OUTPUT_VARIABLE address OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT address)
    set(address root@localhost)  # not a checkout
  endif()
  set(CPS_PACKAGE_CONTACT "${author} <${address}>")
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
