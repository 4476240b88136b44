# Lets projects outside the tree build models against this build tree:
#     find_package(isphPorousFoam REQUIRED)          with -DisphPorousFoam_DIR=<build folder>
#     add_library(myDrag SHARED MyDrag.cpp)
#     target_link_libraries(myDrag PRIVATE isphPorousFoam::porous)
get_property(libraries GLOBAL PROPERTY ISPH_LIBRARIES)
export(TARGETS ${libraries} NAMESPACE isphPorousFoam::
    FILE ${CMAKE_BINARY_DIR}/isphPorousFoamTargets.cmake)

include(CMakePackageConfigHelpers)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/isphPorousFoamConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/isphPorousFoamConfig.cmake CONTENT [[
# The libraries of isphPorousFoam and what their headers include.
include("@CMAKE_SOURCE_DIR@/etc/cmake/IsphDependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/isphPorousFoamTargets.cmake")
]] @ONLY)

# Programs look for etc/controlDict upward from where they stand; a build folder elsewhere shows it.
cmake_path(IS_PREFIX CMAKE_SOURCE_DIR ${CMAKE_BINARY_DIR} NORMALIZE inTree)
if(NOT inTree)
    file(CREATE_LINK ${CMAKE_SOURCE_DIR}/etc ${CMAKE_BINARY_DIR}/etc SYMBOLIC)
endif()
