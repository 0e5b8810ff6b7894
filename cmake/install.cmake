# `cmake --install BUILD [--component core]`, `cpack --config BUILD/CPackConfig.cmake -G DEB`. Two components: core is what a
# render node needs; trainer is cps-train, the only program that links LibTorch.
include(GNUInstallDirs)

set(share ${CMAKE_INSTALL_DATADIR}/cps)
set(doc ${CMAKE_INSTALL_DOCDIR})
install(TARGETS cps RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT core)
install(DIRECTORY sampler/recipes DESTINATION ${share} COMPONENT core)
install(FILES python/cps_dataset.py DESTINATION ${share}/python COMPONENT core)
install(DIRECTORY apps/slurm DESTINATION ${share} COMPONENT core USE_SOURCE_PERMISSIONS)
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

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The cps maintainers <cps@localhost>")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL core)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CORE_PACKAGE_NAME cps)
set(CPACK_DEBIAN_CORE_DESCRIPTION "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_CORE_PACKAGE_DEPENDS fonts-dejavu-core)  # captions of contact sheets
if(CPS_TRAINER)
  list(APPEND CPACK_COMPONENTS_ALL trainer)
  set(CPACK_DEBIAN_TRAINER_PACKAGE_NAME cps-train)
  set(CPACK_DEBIAN_TRAINER_DESCRIPTION "${PROJECT_DESCRIPTION}: the trainer")
  set(CPACK_DEBIAN_TRAINER_PACKAGE_DEPENDS "cps (= ${PROJECT_VERSION})")
endif()
include(CPack)
