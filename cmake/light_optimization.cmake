# For code that calculates next to nothing: a body's mesh at the start, parameters,
# tables, tests of what is in the library. To optimise it takes longer than it
# ever gains, templates of deal.II and the standard library most of all.
set(LUMBRICUS_LIGHT_OPTIMIZATION
  $<$<CONFIG:Release>:-O1>
  # Among deal.II's flags for GCC are -funroll-loops and -funroll-all-loops.
  $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-fno-unroll-loops>
  $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-fno-unroll-all-loops>)

# lumbricus_optimize_lightly(<target> <units>...): those of the units that
# lumbricus_unity_build() makes which are named for these folders. Files that have
# options of their own would not be compiled together, so the unit gets them, by the
# name that CMake has for it; without LUMBRICUS_UNITY all is optimised alike.
function(lumbricus_optimize_lightly target)
  foreach(unit IN LISTS ARGN)
    set_source_files_properties(
      ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/Unity/unity_${unit}_cxx.cxx
      PROPERTIES COMPILE_OPTIONS "${LUMBRICUS_LIGHT_OPTIMIZATION}")
  endforeach()
endfunction()
