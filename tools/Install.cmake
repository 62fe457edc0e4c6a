# cmake --install and cpack. Included by CMakeLists.txt; the files that tell where things are know only the way from one to
# the other, so that an installed tree may move, and nothing in it points to the source.
#   <lib>/lammps/plugins   the plugin: a folder for LAMMPS_PLUGIN_PATH
#   <lib>/sphtm            the LAMMPS it is for, for the command alone: component host, only with --component host and in packages
#   <share>/sphtm          materials, examples, pages, tools, studies, in the folders of the source: links and imports hold
#   <bin>/sphtm            the command
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME sphtm)
set(SPHTM_PLUGIN_DIR ${CMAKE_INSTALL_LIBDIR}/lammps/plugins)
set(SPHTM_HOST_DIR ${CMAKE_INSTALL_LIBDIR}/sphtm)
set(SPHTM_DATA_DIR ${CMAKE_INSTALL_DATADIR}/sphtm)

# way(VARIABLE FROM TO) between two of these folders
function(way variable from to)
  foreach(folder from to)
    if(NOT IS_ABSOLUTE ${${folder}})
      set(${folder} ${CMAKE_INSTALL_PREFIX}/${${folder}})
    endif()
  endforeach()
  file(RELATIVE_PATH path ${from} ${to})
  set(${variable} ${path} PARENT_SCOPE)
endfunction()
way(SPHTM_DATA ${SPHTM_PLUGIN_DIR} ${SPHTM_DATA_DIR})
way(SPHTM_BIN_TO_DATA ${CMAKE_INSTALL_BINDIR} ${SPHTM_DATA_DIR})
way(SPHTM_BIN_TO_PLUGIN ${CMAKE_INSTALL_BINDIR} ${SPHTM_PLUGIN_DIR})
way(SPHTM_BIN_TO_HOST ${CMAKE_INSTALL_BINDIR} ${SPHTM_HOST_DIR})

configure_file(${PROJECT_SOURCE_DIR}/tools/sphtm-installed.in ${PROJECT_BINARY_DIR}/config/sphtm @ONLY)

install(TARGETS sphtmplugin sphtm_styles LIBRARY DESTINATION ${SPHTM_PLUGIN_DIR})
install(PROGRAMS ${PROJECT_BINARY_DIR}/config/sphtm DESTINATION ${CMAKE_INSTALL_BINDIR})
set(no_leftovers PATTERN __pycache__ EXCLUDE PATTERN "*.pyc" EXCLUDE PATTERN log.lammps EXCLUDE)
install(FILES packaging/sphtm.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(DIRECTORY materials examples DESTINATION ${SPHTM_DATA_DIR} ${no_leftovers})
install(DIRECTORY doc DESTINATION ${SPHTM_DATA_DIR} PATTERN results EXCLUDE)
# the manual, where ./sphtm manual has made it
install(DIRECTORY out/manual/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/html OPTIONAL PATTERN ".*" EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE DESTINATION ${SPHTM_DATA_DIR})
install(FILES tools/make_tool.py tools/common.sh tools/fit.sh DESTINATION ${SPHTM_DATA_DIR}/tools)
install(PROGRAMS tools/doctor.sh tools/installed.sh tools/packages.sh tools/print-env.sh DESTINATION ${SPHTM_DATA_DIR}/tools)
install(FILES bench/study.py bench/provenance.py bench/many.py bench/shared_gpu.py DESTINATION ${SPHTM_DATA_DIR}/bench)
install(DIRECTORY bench/accuracy bench/stability bench/validate DESTINATION ${SPHTM_DATA_DIR}/bench ${no_leftovers})
# what the studies take from the tests
install(FILES unittest/scenes/sphtm_scene.py unittest/scenes/sph_kernels.py unittest/scenes/test_kernels_forms.py
  unittest/scenes/test_oscillating_plate.py unittest/scenes/test_rings.py unittest/scenes/test_spinning_block.py DESTINATION ${SPHTM_DATA_DIR}/unittest/scenes)

# the commit, asked when it is installed
find_package(Git QUIET)
foreach(variable SPHTM_DATA_DIR SPHTM_HOST_DIR)
  set(at_${variable} "\$ENV{DESTDIR}")
  if(NOT IS_ABSOLUTE ${${variable}})
    string(APPEND at_${variable} "\${CMAKE_INSTALL_PREFIX}/")
  endif()
  string(APPEND at_${variable} "${${variable}}")
endforeach()
install(CODE "set(commit unknown)
  if(EXISTS \"${PROJECT_SOURCE_DIR}/.git\")
    execute_process(COMMAND \"${GIT_EXECUTABLE}\" -C \"${PROJECT_SOURCE_DIR}\" describe --always --dirty=+ --abbrev=7 --exclude=*
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
  file(WRITE \"${at_SPHTM_DATA_DIR}/commit\" \"\${commit}\\n\")")

set(SPHTM_WITH_HOST OFF)
if(EXISTS ${LAMMPS_BUILD_DIR}/lmp AND EXISTS ${LAMMPS_BUILD_DIR}/liblammps.so.0 AND NOT CMAKE_VERSION VERSION_LESS 3.21)
  set(SPHTM_WITH_HOST ON)
  install(PROGRAMS ${LAMMPS_BUILD_DIR}/lmp DESTINATION ${SPHTM_HOST_DIR} COMPONENT host EXCLUDE_FROM_ALL)
  install(FILES ${LAMMPS_BUILD_DIR}/liblammps.so.0 DESTINATION ${SPHTM_HOST_DIR} COMPONENT host EXCLUDE_FROM_ALL)
  # A build folder's run paths may have an empty one, which is the current folder. On a system with multiarch folders the
  # loader finds MPI by itself.
  set(host_rpath $ORIGIN)
  if(NOT CMAKE_LIBRARY_ARCHITECTURE)
    foreach(library ${MPI_CXX_LIBRARIES})
      get_filename_component(folder ${library} DIRECTORY)
      list(APPEND host_rpath ${folder})
    endforeach()
    list(REMOVE_DUPLICATES host_rpath)
  endif()
  string(REPLACE ";" ":" host_rpath "${host_rpath}")
  string(REPLACE "$" "\\$" host_rpath "${host_rpath}")
  install(CODE "foreach(file lmp liblammps.so.0)
    file(RPATH_SET FILE \"${at_SPHTM_HOST_DIR}/\${file}\" NEW_RPATH \"${host_rpath}\")
  endforeach()" COMPONENT host EXCLUDE_FROM_ALL)
endif()

include(Package)
