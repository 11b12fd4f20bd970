# Embeds the style sheets and the script of the report in the program.
foreach(file report.css animation.css animation.js)
    set(path ${CMAKE_CURRENT_LIST_DIR}/page/${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    string(REPLACE . _ name ${file})
    file(READ ${path} ${name})
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/page.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/page.cpp @ONLY)
target_sources(delabole_plots PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/page.cpp)
