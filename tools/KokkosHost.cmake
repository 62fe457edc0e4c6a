# For a LAMMPS built with the KOKKOS package: finds the Kokkos it was built with. Included by LammpsHost.cmake.
# Target lammps_kokkos_host: what sources that see Kokkos are compiled with. Nothing is linked: the program that loads
# the plugin has Kokkos, and a second one would be a second set of devices.
if(CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper")
  set(CMAKE_CXX_EXTENSIONS OFF)    # as Kokkos for CUDA has it
endif()
set(host_kokkos_dirs ${HOST_Kokkos_DIR} ${LAMMPS_BUILD_DIR}/kokkos ${LAMMPS_BUILD_DIR}/kokkos_build-prefix)
find_package(Kokkos CONFIG QUIET PATHS ${host_kokkos_dirs} NO_DEFAULT_PATH)
if(NOT Kokkos_FOUND)
  message(FATAL_ERROR "The LAMMPS in ${LAMMPS_BUILD_DIR} was built with Kokkos, but its Kokkos is not in "
    "${host_kokkos_dirs}: build LAMMPS against an installed one (EXTERNAL_KOKKOS=ON, Kokkos_ROOT=<its folder>)")
endif()
if(Kokkos_ENABLE_CUDA AND NOT CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper")
  message(FATAL_ERROR "The LAMMPS in ${LAMMPS_BUILD_DIR} is for CUDA: set CMAKE_CXX_COMPILER to its Kokkos's nvcc_wrapper")
endif()

# Particles are taken as LAMMPS has them by default: in double, with three values of a particle side by side
foreach(setting KOKKOS_PREC=double KOKKOS_LAYOUT=legacy)
  string(REGEX MATCH "^(.*)=(.*)$" setting ${setting})
  string(TOLOWER "${HOST_${CMAKE_MATCH_1}}" is)
  if(is AND NOT is STREQUAL CMAKE_MATCH_2)
    message(FATAL_ERROR "The LAMMPS in ${LAMMPS_BUILD_DIR} was built with ${CMAKE_MATCH_1}=${is}: "
      "the plugin needs one with -D ${CMAKE_MATCH_1}=${CMAKE_MATCH_2}")
  endif()
endforeach()
# Kokkos's headers ask for a newer C++ than LAMMPS itself: 20 from Kokkos 5 on
if(Kokkos_CXX_STANDARD GREATER CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD ${Kokkos_CXX_STANDARD})
elseif(Kokkos_VERSION VERSION_GREATER_EQUAL 5 AND CMAKE_CXX_STANDARD LESS 20)
  set(CMAKE_CXX_STANDARD 20)
endif()

add_library(lammps_kokkos_host INTERFACE)
target_include_directories(lammps_kokkos_host SYSTEM INTERFACE ${LAMMPS_SOURCE_DIR}/KOKKOS
  $<TARGET_PROPERTY:Kokkos::kokkos,INTERFACE_INCLUDE_DIRECTORIES>)
target_compile_definitions(lammps_kokkos_host INTERFACE $<TARGET_PROPERTY:Kokkos::kokkos,INTERFACE_COMPILE_DEFINITIONS>)
target_compile_options(lammps_kokkos_host INTERFACE $<TARGET_PROPERTY:Kokkos::kokkos,INTERFACE_COMPILE_OPTIONS>)
target_link_libraries(lammps_kokkos_host INTERFACE lammps_host)
if(Kokkos_ENABLE_OPENMP)
  target_link_libraries(lammps_kokkos_host INTERFACE OpenMP::OpenMP_CXX)
endif()
message(STATUS "Kokkos ${Kokkos_VERSION}, ${Kokkos_DEVICES}, C++${CMAKE_CXX_STANDARD}: ${Kokkos_DIR}")
