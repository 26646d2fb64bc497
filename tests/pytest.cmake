# add_pytest(<kind> <file without .py> <extra labels...>): a test in Python that
# runs the program, with its own choice of ranks.
function(add_pytest kind name)
  add_test(NAME ${kind}/${name}
    COMMAND ${Python3_EXECUTABLE} -m pytest -q -p no:cacheprovider
      ${PROJECT_SOURCE_DIR}/tests/${kind}/${name}.py)
  set_tests_properties(${kind}/${name} PROPERTIES
    LABELS "${kind};${ARGN}" PROCESSORS 2 TIMEOUT 1200
    ENVIRONMENT "LUMBRICUS=$<TARGET_FILE:lumbricus>;MPIRUN=${LUMBRICUS_MPIRUN};PYTHONPATH=${PROJECT_SOURCE_DIR}/tests;PYTHONDONTWRITEBYTECODE=1;OMP_NUM_THREADS=1;OPENBLAS_NUM_THREADS=1")
endfunction()
