# Man pages and completion, which the programs write themselves from their options (apps/manual/pages.h), in a folder
# laid out as it is installed.
include(GNUInstallDirs)
add_custom_target(cps_manuals ALL)

# cps_manuals_of(PROGRAM COMPONENT [page.1 …]): those of a program, and pages that were written by hand.
function(cps_manuals_of program component)
  set(folder ${CMAKE_BINARY_DIR}/manuals/${component})
  add_custom_command(OUTPUT ${folder}/written
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${program}> -DPAGES=${ARGN} -DFOLDER=${folder}
            -P ${CMAKE_SOURCE_DIR}/cmake/write_manuals.cmake
    DEPENDS ${program} ${ARGN} ${CMAKE_SOURCE_DIR}/cmake/write_manuals.cmake
    COMMENT "Man pages and completion of ${program}" VERBATIM)
  add_custom_target(cps_manuals_${component} DEPENDS ${folder}/written)
  add_dependencies(cps_manuals cps_manuals_${component})
  install(DIRECTORY ${folder}/share/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT ${component})
endfunction()

cps_manuals_of(cps core ${CMAKE_SOURCE_DIR}/apps/slurm/cps-slurm.1)
if(CPS_TRAINER)
  cps_manuals_of(cps-train trainer)
endif()
