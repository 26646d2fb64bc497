# lumbricus_add_plugin(<name> <sources>...): a library lib<name>.so of laws, shapes, loads and
# whatever else registers itself, for the parameter 'Additional shared libraries'. It says itself
# what it was built for.
function(lumbricus_add_plugin name)
  add_library(${name} MODULE ${ARGN} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin_version.cc)
  lumbricus_setup_target(${name})
  set_property(TARGET ${name} APPEND PROPERTY LINK_LIBRARIES Lumbricus::lumbricus)
endfunction()
