// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/program/blas.h>

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace lumbricus
{
  void
  prepare_blas(char *const argv[])
  {
    bool       changed = false;
    const auto wish    = [&](const char *name, const char *value) {
      if (std::getenv(name) == nullptr)
        changed = (setenv(name, value, 0) == 0) || changed;
    };

    wish("OPENBLAS_NUM_THREADS", "1");
    wish("OMP_NUM_THREADS", "1");
#if defined(__x86_64__) && defined(__GNUC__)
    if (__builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      wish("OPENBLAS_CORETYPE", "SKYLAKEX");
#endif

    if (!changed)
      return;
    // The library has read its environment already. The file itself is named,
    // not the link to it: a process is called by what was started, and this one
    // is to stay what ps and pkill know it by. If this fails the program goes
    // on as it is, only slower.
    std::error_code             error;
    const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error)
      execv(program.c_str(), argv);
    execv("/proc/self/exe", argv);
  }



  std::string
  blas_warning()
  {
    Dl_info     info;
    void *const dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
    if (dgemm == nullptr || dladdr(dgemm, &info) == 0)
      return "";
    std::error_code   error;
    const std::string library =
      std::filesystem::canonical(info.dli_fname, error).string();
    return library.find("/blas/libblas.so") != std::string::npos ?
             "Warning: the reference BLAS is loaded (" + library +
               "); the direct solver is about eight times slower than with "
               "OpenBLAS (apt-get install libopenblas0-serial).\n" :
             "";
  }
} // namespace lumbricus
