// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_checkpoint_files_h
#define lumbricus_checkpoint_checkpoint_files_h

#include <lumbricus/checkpoint/manifest.h>
#include <lumbricus/discretization/cell_key.h>
#include <lumbricus/output/run_folder.h>

#include <cstdint>
#include <set>
#include <string>

namespace lumbricus
{
  /** Write a file of the checkpoint of this name and read it back. Throws
   * ExcSolveFailed.
   * @return its line in the manifest. */
  std::string
  write_and_check(const RunFolder   &folder,
                  const std::string &checkpoint,
                  const std::string &name,
                  const std::string &content);

  /** The whole of a file in the folder @p path that has to be there, of no more
   * than @p most bytes. Throws ExcDamaged. */
  std::string
  read_regular(const std::string   &path,
               const std::string   &name,
               const std::uintmax_t most);

  /** The content of a regular file, which is what the manifest says. Throws
   * ExcDamaged. */
  std::string
  read_listed(const std::string   &path,
              const std::string   &name,
              const Manifest      &manifest,
              const std::uintmax_t most);

  /** The content of the file of the mesh: the cells that are refined. */
  std::string
  mesh_content(const std::set<CellKey> &refined);

  /** The most bytes that mesh_content() has of a mesh of @p n_cells. */
  std::uintmax_t
  largest_mesh_content(const std::uintmax_t n_cells);

  /** Whether @p content was made by mesh_content(). */
  bool
  is_mesh_content(const std::string &content);

  /** The cells that mesh_content() was made of. */
  std::set<CellKey>
  refined_in(const std::string &content);
} // namespace lumbricus

#endif
