# Finds out about the LAMMPS the plugin is for, from LAMMPS_SOURCE_DIR and LAMMPS_BUILD_DIR.
# Sets LAMMPS_SOURCE_DIR (the src folder), LAMMPS_TOP_DIR, LAMMPS_VERSION, and the target lammps_host with the
# include folders and definitions that decide how LAMMPS's classes are laid out.

foreach(name LAMMPS_SOURCE_DIR LAMMPS_BUILD_DIR)
  if(${name})
    get_filename_component(${name} "${${name}}" ABSOLUTE BASE_DIR ${CMAKE_BINARY_DIR})
  endif()
endforeach()

# The build or install folder: which settings LAMMPS was built with
set(host_sizes SMALLBIG)
set(host_mpi "")
if(LAMMPS_BUILD_DIR)
  file(GLOB host_targets ${LAMMPS_BUILD_DIR}/lib*/cmake/LAMMPS/LAMMPS_Targets.cmake
       ${LAMMPS_BUILD_DIR}/lib/*/cmake/LAMMPS/LAMMPS_Targets.cmake)
  if(EXISTS ${LAMMPS_BUILD_DIR}/CMakeCache.txt)
    load_cache(${LAMMPS_BUILD_DIR} READ_WITH_PREFIX HOST_ LAMMPS_SIZES BUILD_MPI BUILD_SHARED_LIBS PKG_PLUGIN
               PKG_KOKKOS MPI_CXX_COMPILER CMAKE_HOME_DIRECTORY)
    if(NOT HOST_LAMMPS_SIZES)
      message(FATAL_ERROR "LAMMPS_BUILD_DIR=${LAMMPS_BUILD_DIR} is a CMake build folder, but not of LAMMPS")
    endif()
    string(TOUPPER ${HOST_LAMMPS_SIZES} host_sizes)
    set(host_mpi ${HOST_BUILD_MPI})
    if(NOT HOST_PKG_PLUGIN)
      message(FATAL_ERROR "The LAMMPS in ${LAMMPS_BUILD_DIR} cannot load plugins: build it with -D PKG_PLUGIN=ON")
    endif()
    if(NOT HOST_BUILD_SHARED_LIBS)
      message(WARNING "The LAMMPS in ${LAMMPS_BUILD_DIR} was not built with -D BUILD_SHARED_LIBS=ON. "
        "Parts of LAMMPS that it does not use itself can be missing when the plugin is loaded.")
    endif()
    if(NOT LAMMPS_SOURCE_DIR AND EXISTS ${HOST_CMAKE_HOME_DIRECTORY}/../src/version.h)
      get_filename_component(LAMMPS_SOURCE_DIR ${HOST_CMAKE_HOME_DIRECTORY}/../src ABSOLUTE)
    endif()
    if(HOST_MPI_CXX_COMPILER AND NOT MPI_CXX_COMPILER)
      set(MPI_CXX_COMPILER ${HOST_MPI_CXX_COMPILER})
    endif()
  elseif(host_targets)
    list(GET host_targets 0 host_targets)
    file(STRINGS ${host_targets} line REGEX "LAMMPS_(SMALLBIG|BIGBIG|SMALLSMALL)")
    if("${line}" MATCHES "LAMMPS_(SMALLBIG|BIGBIG|SMALLSMALL)")
      set(host_sizes ${CMAKE_MATCH_1})
    endif()
    file(STRINGS ${host_targets} line REGEX "MPI::MPI_CXX|mpi_stubs")
    if("${line}" MATCHES "mpi_stubs")
      set(host_mpi OFF)
    else()
      set(host_mpi ON)
    endif()
  else()
    message(FATAL_ERROR "LAMMPS_BUILD_DIR=${LAMMPS_BUILD_DIR} has neither CMakeCache.txt (a build folder) "
      "nor lib/cmake/LAMMPS/LAMMPS_Targets.cmake (an install folder)")
  endif()
endif()

# The source
if(NOT LAMMPS_SOURCE_DIR)
  message(FATAL_ERROR "Say which LAMMPS the plugin is for: -D LAMMPS_SOURCE_DIR=<its source folder>. "
    "Without a LAMMPS of your own, ./sphtm build gets one and builds the plugin for it.")
endif()
if(EXISTS ${LAMMPS_SOURCE_DIR}/src/version.h)
  set(LAMMPS_SOURCE_DIR ${LAMMPS_SOURCE_DIR}/src)
endif()
get_filename_component(LAMMPS_TOP_DIR ${LAMMPS_SOURCE_DIR} DIRECTORY)
if(NOT EXISTS ${LAMMPS_SOURCE_DIR}/version.h OR NOT EXISTS ${LAMMPS_SOURCE_DIR}/lammpsplugin.h)
  message(FATAL_ERROR "LAMMPS_SOURCE_DIR=${LAMMPS_SOURCE_DIR} is not the source of a LAMMPS with plugins: "
    "it should hold version.h and lammpsplugin.h")
endif()
file(STRINGS ${LAMMPS_SOURCE_DIR}/version.h line REGEX "define LAMMPS_VERSION")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" LAMMPS_VERSION "${line}")

if(host_mpi STREQUAL "")
  find_package(MPI QUIET COMPONENTS CXX)
  set(host_mpi ${MPI_CXX_FOUND})
  message(STATUS "LAMMPS_BUILD_DIR is not given: taking it to be built with ${host_sizes} and MPI '${host_mpi}'")
endif()

# What is compiled for this LAMMPS links to this
add_library(lammps_host INTERFACE)
target_include_directories(lammps_host SYSTEM INTERFACE ${LAMMPS_SOURCE_DIR})
target_compile_definitions(lammps_host INTERFACE LAMMPS_${host_sizes} OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
if(host_mpi)
  set(MPI_CXX_SKIP_MPICXX ON)
  find_package(MPI REQUIRED COMPONENTS CXX)
  target_link_libraries(lammps_host INTERFACE MPI::MPI_CXX)
else()
  target_include_directories(lammps_host SYSTEM INTERFACE ${LAMMPS_SOURCE_DIR}/STUBS)
endif()
message(STATUS "LAMMPS ${LAMMPS_VERSION}, ${host_sizes}, MPI ${host_mpi}: ${LAMMPS_SOURCE_DIR}")
