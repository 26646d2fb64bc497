// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_output_parts_h
#define lumbricus_output_output_parts_h

#include <lumbricus/output/cell_fields.h>
#include <lumbricus/output/output_format.h>
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /** One of every table and field that has registered itself, and the format
   * that the user chooses: what they declare is in the section Output. */
  class OutputParts : public ParameterOwner
  {
  public:
    /** With the default values. */
    OutputParts();

    /** Throws ExcInput where two tables or two fields have the same name, or a
     * table has one that cannot be that of a file. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** Name the arrays of the fields, by the muscles of @p anatomy, and leave out
     * what has nothing to say where these conditions act. Throws ExcInput where
     * two fields have the same name. */
    void
    initialize(const Anatomy            &anatomy,
               const BoundaryConditions &conditions);

    /** Let all tables look at the first mesh of a run. Throws ExcInput.
     * @return what to tell the user, in lines. Collective. */
    std::string
    check(const MixedSpace &space) const;

    /** The tables that the parameters ask for, by their files: in the order of
     * the names. After initialize(). */
    std::map<std::string, Table *>
    tables() const;

    /** Whether any of these tables needs StepRecord::work. */
    bool
    asks_for_work() const;

    /** Whether any of these tables needs StepRecord::errors. */
    bool
    asks_for_errors() const;

    /** Whether one does so after step @p number. */
    bool
    asks_for_errors(const unsigned int number) const;

    /** Whether any of these tables needs StepRecord::errors_of_steps. */
    bool
    asks_for_errors_of_steps() const;

    /** Whether any of these tables needs StepRecord::errors_of_resets after step
     * @p number. */
    bool
    asks_for_errors_of_resets(const unsigned int number) const;

    /** The arrays of all fields, in the order of Field::place(). After
     * initialize(). */
    const std::vector<FieldArray> &
    field_arrays() const;

    /** The arrays with these names, which have to be there. */
    std::vector<FieldArray>
    field_arrays(const std::vector<std::string> &names) const;

    /** How pictures are written. */
    OutputFormat &
    format();

    /** The name that the user chooses it by. */
    const std::string &
    format_name() const;

  private:
    std::map<std::string, std::unique_ptr<Table>> all_tables;
    std::map<std::string, std::unique_ptr<Field>> all_fields;
    /** Names of tables without anything to write. */
    std::set<std::string>                         empty_tables;
    Choice<OutputFormat>                          format_choice;
    std::vector<FieldArray>                       arrays;
  };
} // namespace lumbricus

#endif
