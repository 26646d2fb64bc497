// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_checkpoint_folders_h
#define lumbricus_checkpoint_checkpoint_folders_h

#include <lumbricus/output/run_folder.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** @name The folders of checkpoints
   * A run has those that its RunRecord lists, each named by its step in
   * checkpoints/, which may be a link to somewhere else. All else there is the
   * user's. All of these are for rank 0 only.
   * @{
   */

  /** The name of the checkpoint of a step: "000012". */
  std::string
  checkpoint_name(const unsigned int step);

  /** Where the checkpoint of this name is, from the folder of the run. */
  std::string
  checkpoint_in_folder(const std::string &name);

  /** Where the checkpoint of this name is, from the working directory. */
  std::string
  checkpoint_path(const RunFolder &folder, const std::string &name);

  /** The names of those of the run that are there, newest first. */
  std::vector<std::string>
  checkpoints_of(const RunFolder &folder);

  /** Record and make that of this name, without files. Throws
   * ExcSolveFailed. */
  void
  make_checkpoint_folder(const RunFolder &folder, const std::string &name);

  /** Remove what the program has written there, and the folder where nothing
   * else is in it. */
  void
  remove_checkpoint(const RunFolder &folder, const std::string &name);

  /** Remove all of an earlier run. Throws ExcSolveFailed where one is still
   * there. */
  void
  remove_checkpoints(const RunFolder &folder);

  /** Remove all but @p current and the newest older one that is complete. */
  void
  remove_old_checkpoints(const RunFolder &folder, const std::string &current);

  /** @} */
} // namespace lumbricus

#endif
