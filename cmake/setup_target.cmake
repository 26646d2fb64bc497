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
