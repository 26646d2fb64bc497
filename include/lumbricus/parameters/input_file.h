// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_input_file_h
#define lumbricus_parameters_input_file_h

#include <lumbricus/core/fingerprint.h>

#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** A file that a parameter names and a run reads: a mesh, fibres. A parameter
   * is known to name one by its pattern, Patterns::FileName(). */
  struct InputFile
  {
    std::string parameter; ///< the path of the parameter
    std::string name;      ///< as the parameter has it
    std::string path;      ///< from the root of the file system; "" if unknown

    /** What is in it; none where it is no regular file, but a pipe. */
    std::optional<Fingerprint> content;
  };



  /** The file @p name of @p parameter as it is now. */
  InputFile
  look_at_input_file(const std::string &parameter, const std::string &name);

  /** Lines of an item and its values, for read_input_files(). */
  std::string
  to_text(const std::vector<InputFile> &files);

  /** Read what to_text() wrote. Throws ExcDamaged. */
  std::vector<InputFile>
  read_input_files(const std::string &text);

  /**
   * Find @p file again, by the same name from where the program runs now, else
   * where it was; its content has to be the same.
   * @return its name. Throws ExcInput, which says what is wrong with it.
   */
  std::string
  find_again(const InputFile &file);
} // namespace lumbricus

#endif
