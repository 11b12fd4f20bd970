# Defines the target klu::klu, here and for users of the installed library: SuiteSparse has no CMake file before 7.
if(NOT TARGET klu::klu)
    find_path(KLU_INCLUDE_DIR klu.h PATH_SUFFIXES suitesparse)
    find_library(KLU_LIBRARY klu)
    if(NOT KLU_INCLUDE_DIR OR NOT KLU_LIBRARY)
        message(FATAL_ERROR "KLU not found (Debian: libsuitesparse-dev)")
    endif()
    add_library(klu::klu UNKNOWN IMPORTED)
    set_target_properties(klu::klu PROPERTIES
        IMPORTED_LOCATION "${KLU_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${KLU_INCLUDE_DIR}")
endif()
