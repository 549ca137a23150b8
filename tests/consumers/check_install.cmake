# check_install.cmake: installs into a folder, moves it (a package must not know where it was made), looks into it.
# cmake -D BUILD=... -D SOURCE=... -D CONFIG=... -D PREFIX=... -D INCLUDEDIR=... -P check_install.cmake
file(REMOVE_RECURSE ${PREFIX} ${PREFIX}.first)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${PREFIX}.first
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${PREFIX}.first ${PREFIX})

file(GLOB_RECURSE package ${PREFIX}/*.cmake ${PREFIX}/*.pc)
list(LENGTH package count)
if(count LESS 5)
    message(FATAL_ERROR "the package is not complete: ${package}")
endif()
foreach(file IN LISTS package)
    file(READ ${file} text)
    foreach(path IN ITEMS ${BUILD} ${SOURCE} ${PREFIX})
        string(FIND "${text}" "${path}" at)
        if(NOT at EQUAL -1)
            message(FATAL_ERROR "${file} names ${path}")
        endif()
    endforeach()
endforeach()

# Every header, and nothing else.
file(GLOB_RECURSE wanted RELATIVE ${SOURCE} ${SOURCE}/raster/*.h)
list(FILTER wanted EXCLUDE REGEX "^raster/tool/")
file(GLOB_RECURSE found RELATIVE ${PREFIX}/${INCLUDEDIR} ${PREFIX}/${INCLUDEDIR}/*)
list(SORT wanted)
list(SORT found)
if(NOT wanted STREQUAL found)
    message(FATAL_ERROR "installed: ${found}\nin the source: ${wanted}")
endif()
