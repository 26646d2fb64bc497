# add_pytest(<kind> <file without .py> <extra labels...>): a test in Python that
# runs the program, with its own choice of ranks.
function(add_pytest kind name)
  add_test(NAME ${kind}/${name}
    COMMAND ${Python3_EXECUTABLE} -m pytest -q -p no:cacheprovider
      ${PROJECT_SOURCE_DIR}/tests/${kind}/${name}.py)
  set_tests_properties(${kind}/${name} PROPERTIES
    LABELS "${kind};${ARGN}" TIMEOUT 1200
    ENVIRONMENT "LUMBRICUS=$<TARGET_FILE:lumbricus>;LOADED=$<TARGET_FILE:loaded>;STARTER=$<TARGET_FILE:starter>;MPIRUN=${LUMBRICUS_MPIRUN};PYTHONPATH=${PROJECT_SOURCE_DIR}/tests;PYTHONDONTWRITEBYTECODE=1;${LUMBRICUS_TEST_ENVIRONMENT}")
endfunction()

# take_two_cores(<kind>/<name>...): tests that keep two cores busy. Most have runs
# on one rank, one after another, and those on two ranks share the cores with what
# runs beside them. They come first: ctest starts one where two places are free,
# which they are after another one of these, and otherwise not before the others
# have ended.
function(take_two_cores)
  set_tests_properties(${ARGN} PROPERTIES PROCESSORS 2 COST 200)
endfunction()

# start_early(<kind>/<name>...): tests that are so long that a core would wait
# for one that is started last.
function(start_early)
  set_tests_properties(${ARGN} PROPERTIES COST 100)
endfunction()
