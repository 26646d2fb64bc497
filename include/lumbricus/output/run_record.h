// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_run_record_h
#define lumbricus_output_run_record_h

#include <lumbricus/core/fingerprint.h>

#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What a run has written to its folder, so that what it has not is left
   * alone: the file lumbricus.run there. Its first line says what it is, then
   * a line an item: the run's number, files, checkpoints, and the contents
   * that parameters.prm has had. An item is recorded before it is written.
   * Only rank 0 has one.
   */
  class RunRecord
  {
  public:
    /** The name of the file in the folder. */
    static const std::string file_name;

    /** Read that of @p folder, if it has one. Throws ExcInput where the file of
     * that name is something else. */
    void
    read(const std::string &folder);

    /** Begin that of a new run with @p files, in the place of what there was.
     * Throws ExcSolveFailed. */
    void
    begin(const std::string &folder, const std::vector<std::string> &files);

    /** A number that no other run has; empty without a record. */
    const std::string &
    run_id() const;

    /** Files in the folder, or one below it, by their names from there. */
    const std::set<std::string> &
    files() const;

    /** The names of folders of checkpoints. */
    const std::set<std::string> &
    checkpoints() const;

    /** Whether parameters.prm was written with this content. */
    bool
    has_parameters(const Fingerprint &content) const;

    /** Add files that are not recorded yet. Throws ExcSolveFailed. */
    void
    add_files(const std::vector<std::string> &names);

    /** Add a checkpoint, unless it is recorded. Throws ExcSolveFailed. */
    void
    add_checkpoint(const std::string &name);

    /** Add what parameters.prm will be. Throws ExcSolveFailed. */
    void
    add_parameters(const Fingerprint &content);

  private:
    void
    read_lines(const std::string &text);

    /** Add complete lines to the file. */
    void
    append(const std::string &lines);

    std::string              path;
    std::uintmax_t           complete_size = 0; ///< of its whole lines [bytes]
    bool                     ends_in_the_middle = false;
    std::string              id;
    std::set<std::string>    all_files;
    std::set<std::string>    all_checkpoints;
    std::vector<Fingerprint> parameters;
  };
} // namespace lumbricus

#endif
