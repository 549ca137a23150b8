# readme.cmake: the programs in README.md and docs/reflectance.md, taken from them as they stand there, become targets
# readme_1, readme_2, ..., reflectance_1, ...
function(raster_add_programs_of page prefix)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${page})
    file(READ ${PROJECT_SOURCE_DIR}/${page} rest)
    set(fence "```cpp\n")
    set(programs 0)
    while(TRUE)
        string(FIND "${rest}" "${fence}" at)
        if(at EQUAL -1)
            break()
        endif()
        string(LENGTH "${fence}" length)
        math(EXPR at "${at} + ${length}")
        string(SUBSTRING "${rest}" ${at} -1 rest)
        string(FIND "${rest}" "```" at)
        string(SUBSTRING "${rest}" 0 ${at} program)
        string(SUBSTRING "${rest}" ${at} -1 rest)

        math(EXPR programs "${programs} + 1")
        set(name ${prefix}_${programs})
        set(source ${CMAKE_CURRENT_BINARY_DIR}/readme/${name}.cpp)
        file(CONFIGURE OUTPUT ${source} CONTENT "${program}" @ONLY)
        add_executable(${name} ${source})
        target_compile_options(${name} PRIVATE -Wall -Wextra)
        target_link_libraries(${name} PRIVATE raster::raster)
    endwhile()
endfunction()
raster_add_programs_of(README.md readme)
raster_add_programs_of(docs/reflectance.md reflectance)

# The triangle, and its picture.
add_test(NAME readme.triangle COMMAND readme_1 WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/readme)
set_tests_properties(readme.triangle PROPERTIES FIXTURES_SETUP readme_triangle)
add_executable(readme_check readme_check.cpp)
target_compile_options(readme_check PRIVATE -Wall -Wextra)
target_link_libraries(readme_check PRIVATE raster::raster)
add_test(NAME readme.triangle_picture COMMAND readme_check triangle.png
         WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/readme)
set_tests_properties(readme.triangle_picture PROPERTIES FIXTURES_REQUIRED readme_triangle)

# The model that is not in the tree.
add_test(NAME readme.reflectance COMMAND reflectance_1 WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/readme)
