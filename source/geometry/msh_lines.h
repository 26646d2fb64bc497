// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_msh_lines_h
#define lumbricus_geometry_msh_lines_h

#include <fstream>
#include <set>
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

    /** Go to the next line that is not blank. Throws ExcInput where there is
     * none. */
    void
    need();

    /** The line without blanks at its ends. */
    std::string
    trimmed() const;

    /** As much of it as a message takes, in quotation marks. */
    std::string
    shown() const;

    /** The line up to its first blank. */
    std::string
    first_word() const;

    /** The next number in the line. */
    double
    get_number();

    /** The next number, an integer. */
    int
    get_integer();

    /** The next number, which counts or numbers something. */
    std::size_t
    get_count();

    /** Throws where the line has more in it. */
    void
    need_end_of_line();

    /** From the line "$Name" of a section, which may be there once, to its
     * first line. */
    void
    begin_section(const std::string &name);

    /** To the line "$EndName", which has to be the next. */
    void
    end_section(const std::string &name);

    /** Whether there was a begin_section() of that name. */
    bool
    had_section(const std::string &name) const;

    /** Throws where as many @p what have been read up to this line as the
     * section has not said. */
    void
    check_count(const std::string &what,
                const std::size_t  read,
                const std::size_t  said) const;

    /** The message is that the mesh file so-and-so @p what. */
    [[noreturn]] void
    fail(const std::string &what) const;

    /** The message is that line so-and-so of the mesh file @p what. */
    [[noreturn]] void
    fail_in_line(const std::string &what) const;

  private:
    /** The next word, as a number of this type. */
    template <typename T>
    T
    get();

    std::ifstream      in;
    const std::string  begin;
    std::string        line;
    std::istringstream words;
    std::size_t           number = 0;
    std::set<std::string> sections;
  };
} // namespace lumbricus

#endif
