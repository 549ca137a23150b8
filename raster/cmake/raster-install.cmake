# raster-install.cmake: headers, library, command, CMake package and pkg-config file.
include(CMakePackageConfigHelpers)

set(RASTER_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/raster)
install(TARGETS raster EXPORT raster)
install(DIRECTORY raster/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/raster FILES_MATCHING PATTERN "*.h"
        PATTERN cmake EXCLUDE PATTERN tool EXCLUDE)
if(TARGET raster_tool)
    install(TARGETS raster_tool)
endif()

install(EXPORT raster NAMESPACE raster:: FILE raster-targets.cmake DESTINATION ${RASTER_PACKAGE_DIR})
get_target_property(RASTER_TYPE raster TYPE)
set(RASTER_IS_STATIC FALSE)
if(RASTER_TYPE STREQUAL STATIC_LIBRARY)
    set(RASTER_IS_STATIC TRUE)
endif()
configure_package_config_file(raster/cmake/raster-config.cmake.in ${PROJECT_BINARY_DIR}/raster-config.cmake
                              INSTALL_DESTINATION ${RASTER_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/raster-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES raster/cmake/raster-dependencies.cmake ${PROJECT_BINARY_DIR}/raster-config.cmake
        ${PROJECT_BINARY_DIR}/raster-config-version.cmake DESTINATION ${RASTER_PACKAGE_DIR})

# The .pc file names its own place where it can, so that a moved installation still works.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
    set(RASTER_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
    set(RASTER_PC_LIBDIR ${CMAKE_INSTALL_FULL_LIBDIR})
    set(RASTER_PC_INCLUDEDIR ${CMAKE_INSTALL_FULL_INCLUDEDIR})
else()
    file(RELATIVE_PATH RASTER_UP /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
    string(REGEX REPLACE "/$" "" RASTER_UP "${RASTER_UP}")
    set(RASTER_PC_PREFIX "\${pcfiledir}/${RASTER_UP}")
    set(RASTER_PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
    set(RASTER_PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
string(REPLACE ";" " " RASTER_PC_FLAGS "${RASTER_PUBLIC_FLAGS}")
set(RASTER_PC_LIBS "")
if(RASTER_IS_STATIC)
    set(RASTER_PC_LIBS "-ltinyobjloader -ldeflate")
endif()
configure_file(raster/cmake/raster.pc.in ${PROJECT_BINARY_DIR}/raster.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/raster.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
