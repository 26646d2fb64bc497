# lumbricus_unity_build(<target>): compile the sources of each folder together,
# those that the target has so far. What they include is read once then.
#
# Files that are compiled together see each other's names in anonymous namespaces:
# none may be there twice. A file that cannot join gets SKIP_UNITY_BUILD_INCLUSION, with the
# reason. (Units of half a folder were no faster: templates of deal.II, of Boost and
# of the standard library, two thirds of the code, are compiled anew in each.)
#
# lumbricus_unity_build(<target> <folders>...): the same, and where one of the
# folders is several, "a b c", the files of all of them.
#
# lumbricus_unity_build(<target> ALL): all of the target together, where it is
# small.
option(LUMBRICUS_UNITY "Compile the files of folders together: less time for all, more for one" ON)

function(lumbricus_unity_build target)
  if(NOT LUMBRICUS_UNITY)
    return()
  endif()
  if("ALL" IN_LIST ARGN)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(together IN LISTS ARGN)
    separate_arguments(folders UNIX_COMMAND "${together}")
    list(GET folders 0 first)
    foreach(folder IN LISTS folders)
      set(unit_of_${folder} ${first})
    endforeach()
  endforeach()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    if(DEFINED unit_of_${folder})
      set(folder ${unit_of_${folder}})
    endif()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
  endforeach()
endfunction()
