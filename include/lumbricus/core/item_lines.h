// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_item_lines_h
#define lumbricus_core_item_lines_h

#include <deal.II/base/exceptions.h>

#include <cstdint>
#include <sstream>
#include <string>

namespace lumbricus
{
  /** A file that the program wrote for itself is not as it wrote it. Whoever
   * reads such a file catches this one and says which it is. */
  DeclException1(ExcDamaged, std::string, << arg1);

  /** A file that the program wrote has an item of this name, which this
   * version of the program does not know. */
  DeclException1(ExcUnknownItem, std::string, << arg1);



  /**
   * Reads files that the program writes for itself: a line an item, which is
   * its name and its values with one blank before each. What is not exactly so
   * is an ExcDamaged that says what is wrong, as "has ...".
   */
  class ItemLines
  {
  public:
    /** There is no line before next(). */
    explicit ItemLines(const std::string &text);

    /** Go to the next line, if there is one; of the one before all values have
     * to have been read. */
    bool
    next();

    /** The name of the item. */
    const std::string &
    item() const;

    /** The next value: digits, at most @p most. */
    std::uintmax_t
    get_count(const std::uintmax_t most);

    /** The next value: a finite number, at least @p least. */
    double
    get_number(const double least);

    /** The next value: without blanks, of at least one character. */
    std::string
    get_word();

    /** All that is left of the line. */
    std::string
    get_rest();

    /** Throw: the line is no such item. */
    [[noreturn]] void
    fail() const;

  private:
    std::istringstream text;
    std::string        line;
    std::string        name;
    std::size_t        at = 0; ///< where the next value begins, or npos
  };
} // namespace lumbricus

#endif
