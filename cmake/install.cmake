# `cmake --install BUILD [--component core]`. Two components: core is what a render node needs; trainer is cps-train, the only
# program that links LibTorch, and the models that come with it.
include(GNUInstallDirs)

set(share ${CMAKE_INSTALL_DATADIR}/cps)
set(doc ${CMAKE_INSTALL_DOCDIR})
install(TARGETS cps RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT core)
install(DIRECTORY sampler/recipes DESTINATION ${share} COMPONENT core)
install(FILES python/cps_dataset.py DESTINATION ${share}/python COMPONENT core)
install(DIRECTORY apps/slurm apps/kubernetes apps/aws-batch DESTINATION ${share} COMPONENT core USE_SOURCE_PERMISSIONS
        PATTERN "*.1" EXCLUDE)
file(CREATE_LINK ../share/cps/slurm/cps-slurm ${CMAKE_BINARY_DIR}/cps-slurm SYMBOLIC)
install(FILES ${CMAKE_BINARY_DIR}/cps-slurm DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT core)
install(DIRECTORY docs/ DESTINATION ${doc} COMPONENT core)
install(FILES README.md CHANGELOG.md DESTINATION ${doc} COMPONENT core)
if(CPS_TRAINER)
  # Beside cps, where cps looks for it.
  install(TARGETS cps-train RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT trainer)
  # Of each model, what predicting takes and its card; nothing else that training may have left in its folder.
  install(DIRECTORY models DESTINATION ${share} COMPONENT trainer
          FILES_MATCHING PATTERN README.md PATTERN card.md PATTERN model.json PATTERN weights.pt)
endif()

# The same place relative to the program in the build tree, so that recipes and models are found there too.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/cps)
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/sampler/recipes ${CMAKE_BINARY_DIR}/share/cps/recipes SYMBOLIC)
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/models ${CMAKE_BINARY_DIR}/share/cps/models SYMBOLIC)

# Takes away what `cmake --install` put there.
add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -DBUILD=${CMAKE_BINARY_DIR} -P ${CMAKE_SOURCE_DIR}/cmake/uninstall.cmake)
