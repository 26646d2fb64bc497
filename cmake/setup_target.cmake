# lumbricus_setup_target(<target>): flags and libraries of deal.II, and the
# options of this project.
include(${CMAKE_CURRENT_LIST_DIR}/check_linker.cmake)

function(lumbricus_setup_target target)
  lumbricus_check_linker()
  deal_ii_setup_target(${target})
  if(LUMBRICUS_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(NOT LUMBRICUS_DEBUG_INFO)
    # The last -g counts. deal.II's is among the options, which follow the
    # flags of the target: so must this one.
    target_compile_options(${target} PRIVATE -g0)
    # Nobody goes through it step by step then: deal.II's assertions are all that
    # is wanted of Debug, whose -O0 makes the tests take twice as long.
    target_compile_options(${target} PRIVATE $<$<CONFIG:Debug>:-O1>)
  endif()
endfunction()

# lumbricus_reuse_headers(<target>): compile with the precompiled headers of the
# library, which fit nothing that is not compiled for -fPIC too: where deal.II does
# not say so (Debian 13) programs are compiled for -fPIE.
function(lumbricus_reuse_headers target)
  target_compile_options(${target} PRIVATE -fPIC)
  target_precompile_headers(${target} REUSE_FROM lumbricus_library)
endfunction()
