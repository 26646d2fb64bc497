# Debian's default BLAS is the reference implementation, eight times slower in
# a MUMPS factorisation than OpenBLAS. Say so when it is what will be loaded.
set(_blas_in_use "")
set(_blas /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/libblas.so.3)
if(EXISTS ${_blas})
  get_filename_component(_blas_in_use ${_blas} REALPATH)
endif()
if(_blas_in_use MATCHES "/blas/libblas")
  message(WARNING
    "The reference BLAS is installed (${_blas_in_use}): the direct solver will be about eight times slower "
    "than with OpenBLAS. On Debian or Ubuntu: apt-get install libopenblas0-serial.")
endif()
