// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_msh_lines_h
#define lumbricus_geometry_msh_lines_h

#include <fstream>
#include <sstream>
#include <string>

namespace lumbricus
{
  /**
   * The lines of a file of Gmsh and the numbers in them. Throws ExcInput naming
   * the parameter and the file where something is not as it should be.
   */
  class MshLines
  {
  public:
    /** What messages advise: the options that make Gmsh write what is read
     * here. */
    static const std::string how_to_write;

    /** Open the file; @p parameter is that which names it. Throws ExcInput
     * where it cannot be read. There is no line before next(). */
    MshLines(const std::string &parameter, const std::string &file_name);

    /** Go to the next line that is not blank, if there is one. */
    bool
    next();

    /** The same where there has to be one. */
    void
    need();

    /** The line without blanks at its ends. */
    std::string
    trimmed() const;

    /** The line up to its first blank. */
    std::string
    first_word() const;

    /** The next number in the line. */
    template <typename T>
    T
    get();

    /** The next number, which counts or numbers something. */
    std::size_t
    get_count();

    /** The message is that the mesh file so-and-so @p what. */
    [[noreturn]] void
    fail(const std::string &what) const;

    /** The same, with the number of the line in front of @p what. */
    [[noreturn]] void
    fail_in_line(const std::string &what) const;

  private:
    std::ifstream      in;
    const std::string  begin;
    std::string        line;
    std::istringstream words;
    std::size_t        number = 0;
  };



  template <typename T>
  T
  MshLines::get()
  {
    T value;
    if (!(words >> value))
      fail_in_line("'" + trimmed() + "', has no number where one belongs. " +
                   how_to_write);
    return value;
  }
} // namespace lumbricus

#endif
