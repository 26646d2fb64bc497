// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_part_of_body_h
#define lumbricus_geometry_part_of_body_h

#include <lumbricus/parameters/parameter_owner.h>

#include <string>

namespace lumbricus
{
  class Geometry;

  /**
   * What acts in a body or on it and is chosen by name: fibres, an activation,
   * an action, a load, a support. Its life is that of a ParameterOwner,
   * declared, read and checked, then initialize(); all else comes after.
   */
  class PartOfBody : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /**
     * Called once, when all parameters have been read and checked: do what
     * needs the shape of the body, or files. The full name of the section with
     * its parameters is for messages. Throws ExcInput.
     */
    virtual void
    initialize(const std::string & /*section*/, const Geometry & /*geometry*/)
    {}
  };
} // namespace lumbricus

#endif
