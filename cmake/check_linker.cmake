# deal.II hands on the linker that it was built with, as -fuse-ld=NAME among its
# flags. On Debian 13 that is mold, which deal.II's package does not install:
# everything compiles, and then nothing links. Ask for another linker than the
# compiler's own only where there is one.
include(CheckLinkerFlag)

# lumbricus_check_linker(): leave out of deal.II's flags, as the caller sees
# them, the linkers that are missing.
macro(lumbricus_check_linker)
  foreach(_flags DEAL_II_LINKER_FLAGS DEAL_II_LINKER_FLAGS_DEBUG DEAL_II_LINKER_FLAGS_RELEASE)
    string(REGEX MATCHALL "-fuse-ld=[^ ]+" _linkers "${${_flags}}")
    foreach(_linker IN LISTS _linkers)
      lumbricus_has_linker("${_linker}" _is_there)
      if(NOT _is_there)
        string(REPLACE "${_linker}" "" ${_flags} "${${_flags}}")
      endif()
    endforeach()
  endforeach()
endmacro()

# Whether the compiler links with this flag. Tried once in every configuration,
# since linkers come and go.
function(lumbricus_has_linker flag result)
  string(MAKE_C_IDENTIFIER "LUMBRICUS_HAS${flag}" name)
  get_property(tried GLOBAL PROPERTY ${name}_TRIED)
  if(NOT tried)
    set_property(GLOBAL PROPERTY ${name}_TRIED TRUE)
    unset(${name} CACHE)
    check_linker_flag(CXX "${flag}" ${name})
    if(NOT ${name})
      message(STATUS "deal.II is set to link with a linker that is missing (${flag}): "
        "linking with the compiler's own.")
    endif()
  endif()
  set(${result} "${${name}}" PARENT_SCOPE)
endfunction()
