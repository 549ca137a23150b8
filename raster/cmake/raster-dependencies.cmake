# raster-dependencies.cmake: finds what the library links to; the installed package includes this same file.
#
# Gives glm::glm and TBB::tbb, and under the namespace raster_dependency what only the library's own sources use.
# RASTER_MISSING lists what was not found.

# Makes the imported targets of this directory visible in the whole build: whoever links to raster::raster from another
# directory must see them too. All of them, because a package whose targets are visible in part cannot be found again.
macro(raster_make_targets_global)
    get_property(raster_targets DIRECTORY PROPERTY IMPORTED_TARGETS)
    foreach(raster_target IN LISTS raster_targets)
        set_target_properties(${raster_target} PROPERTIES IMPORTED_GLOBAL TRUE)
    endforeach()
endmacro()

# What raster's headers include; oneTBB if `threads`.
macro(raster_find_public_dependencies threads)
    find_package(glm QUIET)
    if(NOT TARGET glm::glm)
        find_path(RASTER_GLM_INCLUDE_DIR glm/glm.hpp)
        mark_as_advanced(RASTER_GLM_INCLUDE_DIR)
        if(RASTER_GLM_INCLUDE_DIR)
            add_library(glm::glm INTERFACE IMPORTED)
            set_target_properties(glm::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${RASTER_GLM_INCLUDE_DIR}")
        else()
            list(APPEND RASTER_MISSING glm)
        endif()
    endif()
    if(${threads})
        find_package(TBB QUIET COMPONENTS tbb)
        if(NOT TARGET TBB::tbb)
            list(APPEND RASTER_MISSING oneTBB)
        endif()
    endif()
    raster_make_targets_global()
endmacro()

# raster_find_library(name header library cmake_package cmake_targets...): a library as its CMake package, or else as a
# header and a file, with pkg-config's folders as hints.
function(raster_find_library name header library package)
    if(TARGET raster_dependency::${name})
        return()
    endif()
    add_library(raster_dependency::${name} INTERFACE IMPORTED GLOBAL)
    find_package(${package} CONFIG QUIET)
    foreach(target IN LISTS ARGN)
        if(TARGET ${target})
            set_target_properties(raster_dependency::${name} PROPERTIES INTERFACE_LINK_LIBRARIES ${target})
            raster_make_targets_global()
            return()
        endif()
    endforeach()

    string(TOUPPER ${name} NAME)
    find_package(PkgConfig QUIET)
    if(PkgConfig_FOUND)
        pkg_check_modules(RASTER_PC_${NAME} QUIET ${package})
    endif()
    find_path(RASTER_${NAME}_INCLUDE_DIR ${header} HINTS ${RASTER_PC_${NAME}_INCLUDE_DIRS})
    find_library(RASTER_${NAME}_LIBRARY ${library} HINTS ${RASTER_PC_${NAME}_LIBRARY_DIRS})
    mark_as_advanced(RASTER_${NAME}_INCLUDE_DIR RASTER_${NAME}_LIBRARY)
    if(RASTER_${NAME}_INCLUDE_DIR AND RASTER_${NAME}_LIBRARY)
        set_target_properties(raster_dependency::${name} PROPERTIES
            INTERFACE_INCLUDE_DIRECTORIES "${RASTER_${NAME}_INCLUDE_DIR}"
            INTERFACE_LINK_LIBRARIES "${RASTER_${NAME}_LIBRARY}")
    else()
        list(APPEND RASTER_MISSING ${package})
        set(RASTER_MISSING "${RASTER_MISSING}" PARENT_SCOPE)
    endif()
endfunction()

# What raster's own sources use; a program that links to a static raster links to these too.
macro(raster_find_private_dependencies)
    raster_find_library(tinyobjloader tiny_obj_loader.h tinyobjloader tinyobjloader tinyobjloader::tinyobjloader)
    raster_find_library(deflate libdeflate.h deflate libdeflate
                        libdeflate::libdeflate_shared libdeflate::libdeflate_static)
endmacro()
