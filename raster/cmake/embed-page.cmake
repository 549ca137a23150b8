# embed-page.cmake: `cmake -DOUTPUT=x.cpp -DFOLDER=dir -P embed-page.cmake`: the stepper page's sources as C++ strings.
# The scripts are joined in the order below; each is a part of one function, so that nothing becomes global.
set(SCRIPTS data state bug question view3d grid panel_geometry panel_raster panel_shade panels scrubber worksheet main)

file(READ ${FOLDER}/page.html HTML)
file(READ ${FOLDER}/style.css STYLE)
set(SCRIPT "(() => {\n\"use strict\";\n")
foreach(name ${SCRIPTS})
    file(READ ${FOLDER}/${name}.js PART)
    string(APPEND SCRIPT "${PART}\n")
endforeach()
string(APPEND SCRIPT "})();\n")

set(CODE "// Made from raster/step/page by raster/cmake/embed-page.cmake.\n#include <raster/step/parts.h>\n\nnamespace raster::step::page_source {\n")
foreach(part HTML STYLE SCRIPT)
    string(TOLOWER ${part} name)
    string(APPEND CODE "const char* const ${name} = R\"page~(${${part}})page~\";\n")
endforeach()
string(APPEND CODE "}  // namespace raster::step::page_source\n")
file(WRITE ${OUTPUT} "${CODE}")
