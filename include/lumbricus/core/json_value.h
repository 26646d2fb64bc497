// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_json_value_h
#define lumbricus_core_json_value_h

#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * A value of JSON: null, true or false, a number, a text in UTF-8, an object
   * or an array. Boost's property tree, which reads JSON, writes every value as
   * a text; here it does the quoting.
   */
  class JsonValue
  {
  public:
    /** Null. */
    JsonValue() = default;

    /** A text; what is not UTF-8 in it, or a control character, is '?'. */
    explicit JsonValue(const std::string &text);

    /** A text, treated as a std::string is. */
    explicit JsonValue(const char *text);

    /** An array of texts. */
    explicit JsonValue(const std::vector<std::string> &texts);

    /** True or false, or a number, of which as many digits are written as make
     * it the same when it is read again; null where it is not finite. */
    template <class Number,
              std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
    explicit JsonValue(const Number value)
    {
      if constexpr (std::is_same_v<Number, bool>)
        scalar = value ? "true" : "false";
      else if constexpr (std::is_integral_v<Number>)
        scalar = std::to_string(value);
      else
        scalar = digits_of(value);
    }

    /** An object that has nothing yet. */
    static JsonValue
    object();

    /** An array that has nothing yet. */
    static JsonValue
    array();

    /** Add a member to an object, behind the others. @return the object. */
    template <class Value>
    JsonValue &
    add(const std::string &name, const Value &value)
    {
      members.emplace_back(name, JsonValue(value));
      return *this;
    }

    /** Add an element to an array. @return the array. */
    template <class Value>
    JsonValue &
    append(const Value &value)
    {
      return add("", value);
    }

    /** Write it, for people too: what has objects in it a line a member, the
     * rest on one line. No line end follows. */
    void
    write(std::ostream &out) const;

    /** Write it for programs, all of it on one line. No line end follows. */
    void
    write_line(std::ostream &out) const;

  private:
    enum class Kind
    {
      scalar,
      object,
      array
    };

    static std::string
    digits_of(const double value);

    void
    write(std::ostream      &out,
          const unsigned int depth,
          const bool         always_one_line) const;

    /** Whether nothing in it is an object, or an array of more than scalars. */
    bool
    is_one_line() const;

    Kind                                           kind   = Kind::scalar;
    std::string                                    scalar = "null";
    std::vector<std::pair<std::string, JsonValue>> members;
  };
} // namespace lumbricus

#endif
