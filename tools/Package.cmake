# cpack: a .deb of what cmake --install installs, with the LAMMPS host in it where SPHTM_INSTALL_HOST is on: a plugin fits one
# LAMMPS, so the two belong together, and the lammps package of Debian 12 is of 2022. ./sphtm package builds it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sphtm)
set(CPACK_PACKAGE_VENDOR "SPH-TM developers")
if(NOT CPACK_PACKAGE_CONTACT)    # who passes a package on gives the own address
  set(CPACK_PACKAGE_CONTACT "SPH-TM developers <sphtm@localhost>")
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "thermo-mechanical SPH for metal cutting, in LAMMPS")
set(CPACK_PACKAGE_DESCRIPTION "Plugin for LAMMPS ${LAMMPS_VERSION}: smoothed particle hydrodynamics of solids with
strength, damage and heat, contact and friction with tools of triangles.
The command sphtm runs LAMMPS with it.")
if(SPHTM_INSTALL_HOST)
  string(APPEND CPACK_PACKAGE_DESCRIPTION " That LAMMPS is in the package.")
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "https://www.lammps.org")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS python3)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "openmpi-bin, python3-numpy, python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-scipy, paraview")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")    # what Debian's packages have there
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CHANGELOG.md)
  execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md OUTPUT_FILE ${PROJECT_BINARY_DIR}/config/changelog.gz)
  install(FILES packaging/debian/copyright ${PROJECT_BINARY_DIR}/config/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
install(FILES packaging/sphtm.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
include(CPack)
