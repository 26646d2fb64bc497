# lumbricus_setup_target(<target>): flags and libraries of deal.II, and the
# options of this project.
function(lumbricus_setup_target target)
  deal_ii_setup_target(${target})
  if(LUMBRICUS_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(NOT LUMBRICUS_DEBUG_INFO)
    # deal.II's flags have -g; the last one counts.
    set_property(TARGET ${target} APPEND_STRING PROPERTY COMPILE_FLAGS " -g0")
  endif()
endfunction()
