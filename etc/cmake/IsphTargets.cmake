# isph_library(<folder> [SOURCES ...] [USES <folders> ...] [LINKS <external targets> ...])
#   One folder of libsrc is one shared library, libisph_<folder>.so; plug-ins know it as the target
#   isphPorousFoam::<folder>. Its headers are found as "<folder>/X.hpp" by targets that use it and by
#   no other, so that an include of a folder that is not linked does not compile.
# isph_models(<folder> <libName> SOURCES ... [LINKS ...])
#   The models of a family: a library that nothing links and the family loads by name.
# isph_program(<name> SOURCES ... USES ... [LINKS ...])

set(ISPH_INCLUDE_ROOT ${CMAKE_BINARY_DIR}/include)

function(isph_compile_options target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
        -Wno-sign-conversion -Wno-restrict $<$<CONFIG:Release,RelWithDebInfo>:-O3 -fno-math-errno -fno-trapping-math
        -ffp-contract=on>)
    if(ISPH_WARNINGS_AS_ERRORS)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
    if(ISPH_NATIVE)
        target_compile_options(${target} PRIVATE -march=native)
    endif()
endfunction()

function(isph_library folder)
    cmake_parse_arguments(arg "" "" "SOURCES;USES;LINKS" ${ARGN})
    file(MAKE_DIRECTORY ${ISPH_INCLUDE_ROOT}/${folder})
    file(CREATE_LINK ${CMAKE_SOURCE_DIR}/libsrc/${folder}
        ${ISPH_INCLUDE_ROOT}/${folder}/${folder} SYMBOLIC)
    set(target isph_${folder})
    if(arg_SOURCES)
        add_library(${target} SHARED ${arg_SOURCES})
        isph_compile_options(${target})
        set(scope PUBLIC)
    else()
        add_library(${target} INTERFACE)
        set(scope INTERFACE)
    endif()
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${folder})
    target_compile_features(${target} ${scope} cxx_std_20)
    target_include_directories(${target} ${scope}
        $<BUILD_INTERFACE:${ISPH_INCLUDE_ROOT}/${folder}> $<INSTALL_INTERFACE:include/isph>)
    foreach(used ${arg_USES})
        target_link_libraries(${target} ${scope} isph_${used})
    endforeach()
    if(arg_LINKS)
        target_link_libraries(${target} ${scope} ${arg_LINKS})
    endif()
endfunction()

function(isph_models folder libName)
    cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
    if(NOT arg_SOURCES)
        return()
    endif()
    add_library(${libName} SHARED ${arg_SOURCES})
    isph_compile_options(${libName})
    target_link_libraries(${libName} PRIVATE isph_${folder} ${arg_LINKS})
endfunction()

function(isph_program name)
    cmake_parse_arguments(arg "" "" "SOURCES;USES;LINKS" ${ARGN})
    add_executable(${name} ${arg_SOURCES})
    isph_compile_options(${name})
    foreach(used ${arg_USES})
        target_link_libraries(${name} PRIVATE isph_${used})
    endforeach()
    if(arg_LINKS)
        target_link_libraries(${name} PRIVATE ${arg_LINKS})
    endif()
endfunction()
