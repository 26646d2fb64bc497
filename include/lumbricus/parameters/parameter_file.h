// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_parameter_file_h
#define lumbricus_parameters_parameter_file_h

#include <lumbricus/parameters/input_file.h>
#include <lumbricus/parameters/parameter_entry.h>
#include <lumbricus/parameters/parameter_owner.h>
#include <lumbricus/parameters/parameter_source.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Where the parameters of a run come from: a .prm file, the files it
   * includes, and settings from the command line, the later ones winning.
   *
   * The syntax is deal.II's ParameterHandler's. A line `include other.prm`
   * at the top of a file, before any other line, reads another file first;
   * its path is relative to the file that includes it. A file whose name ends
   * in .json is one JSON object instead: see prm_from_json().
   */
  class ParameterFile
  {
  public:
    /** Read a file and what it includes. Throws ExcInput. */
    void
    read(const std::string &file_name);

    /** Take @p text, which print_resolved() wrote to a file of this name: it
     * includes nothing. */
    void
    take_resolved(const std::string &file_name, const std::string &text);

    /** Take a setting "Section/Subsection/Name=value". Throws ExcInput. */
    void
    set(const std::string &setting);

    /** Read the parameters of @p part alone, before those of the others are
     * known: what decides of these. Throws ExcInput where a value is wrong. */
    void
    read_ahead(ParameterOwner &part) const;

    /**
     * Declare, read and extend the parameters of @p root until all that the
     * input asks for is declared (see ParameterOwner), then check them. An
     * unknown section or name, or a value of the wrong type or range, is an
     * ExcInput that names the file, the line, the parameter and its nearest
     * neighbour.
     *
     * What a file says is right where it is used by the file alone, or with
     * the settings: so a setting may make another choice, or list fewer names,
     * than a file with the sections of all that it chose itself.
     */
    template <class Root>
    void
    parse(Root &root);

    /** The sections and parameters of files that are not used because of
     * settings, as "'Section/Name' in file.prm, line 3". */
    const std::vector<std::string> &
    unused() const;

    /** Values of parameters by their paths. */
    using Values = std::map<std::string, std::string>;

    /** All parameters with the values of this run, to run it again, but those
     * of @p instead with the values there. */
    void
    print_resolved(std::ostream &out, const Values &instead = {}) const;

    /** All parameters, with what they mean; their values as by
     * print_resolved(). */
    std::vector<ParameterEntry>
    entries(const Values &instead = {}) const;

    /** The files that the parameters name, as they are now: those with the
     * pattern dealii::Patterns::FileName(), or a list of it, that are set. */
    std::vector<InputFile>
    input_files() const;

    /** The path of the parameter that a setting is of: "Section/Name". */
    static std::string
    path_of_setting(const std::string &setting);

    /** All parameters there are, with documentation; @p root is fresh. */
    static void
    print_reference(ParameterOwner &root, std::ostream &out);

  private:
    using MakeRoot = std::function<std::unique_ptr<ParameterOwner>()>;

    /** The paths of what is declared. */
    struct Names
    {
      std::set<std::string> entries;
      std::set<std::string> sections;

      bool
      have(const PrmLine &line) const
      {
        return (line.is_section ? sections : entries).count(line.path) > 0;
      }
    };

    void
    parse(ParameterOwner &root, const MakeRoot &make_root);

    /** Declare and read until @p root has nothing more to declare. */
    void
    declare(ParameterOwner &root);

    /** Throw ExcInput where nothing is set at all. */
    void
    check_any() const;

    /** Set all that is declared. */
    void
    set_known_values();

    void
    set_value(const ParameterSource &source, const PrmLine &line);

    Names
    known_names() const;

    /** Those that are declared for the files without the settings. */
    Names
    names_of_files(const MakeRoot &make_root) const;

    /** All have to be known, or to be used without the settings. */
    void
    check_names(const MakeRoot &make_root);

    /** The same for parameters in sections that are declared, all of whose
     * parameters are, while others are not yet. */
    void
    check_names_in_known_sections() const;

    /** The message on a line whose path is not known. */
    std::string
    unknown_name(const ParameterSource &source,
                 const PrmLine         &line,
                 const Names           &known) const;

    /**
     * The parameter beside @p section that could choose it but does not, as
     * "'Geometry/Shape' is 'block'"; empty if there is none. Spoils values.
     */
    std::string
    other_choice(const std::string           &section,
                 const std::set<std::string> &known_entries) const;

    /** Whether @p root declared more. */
    bool
    extend(ParameterOwner &root);

    std::vector<ParameterSource> sources;
    std::vector<std::string>     unused_names;

    mutable dealii::ParameterHandler prm;
  };



  template <class Root>
  void
  ParameterFile::parse(Root &root)
  {
    parse(root, []() { return std::make_unique<Root>(); });
  }
} // namespace lumbricus

#endif
