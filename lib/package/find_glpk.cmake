# Defines the target glpk::glpk, here and for users of the installed library: GLPK has no CMake or pkg-config file.
if(NOT TARGET glpk::glpk)
    find_path(GLPK_INCLUDE_DIR glpk.h)
    find_library(GLPK_LIBRARY glpk)
    if(NOT GLPK_INCLUDE_DIR OR NOT GLPK_LIBRARY)
        message(FATAL_ERROR "GLPK not found (Debian: libglpk-dev)")
    endif()
    add_library(glpk::glpk UNKNOWN IMPORTED)
    set_target_properties(glpk::glpk PROPERTIES
        IMPORTED_LOCATION "${GLPK_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${GLPK_INCLUDE_DIR}")
endif()
