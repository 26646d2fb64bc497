// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/parameter_entry.h>

#include <deal.II/base/utilities.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <functional>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    // The name that deal.II writes as this tag of XML: there a '_' and two
    // digits of base 16 stand for what is neither a letter nor a digit.
    std::string
    name_of_tag(const std::string &tag)
    {
      std::string name;
      for (std::size_t i = 0; i < tag.size(); ++i)
        if (tag[i] == '_' && i + 2 < tag.size())
          {
            name += static_cast<char>(std::stoi(tag.substr(i + 1, 2), 0, 16));
            i += 2;
          }
        else
          name += tag[i];
      return name;
    }




    // The documentation of an entry starts with its unit in brackets.
    void
    take_documentation(const std::string &documentation, ParameterEntry &entry)
    {
      const auto end = documentation.find(']');
      if (documentation.compare(0, 1, "[") == 0 && end != std::string::npos)
        entry.unit = documentation.substr(1, end - 1);
      entry.meaning = dealii::Utilities::trim(
        entry.unit.empty() ? documentation : documentation.substr(end + 1));
    }
  } // namespace



  std::vector<ParameterEntry>
  entries_of(const dealii::ParameterHandler &prm)
  {
    // The way to patterns, defaults and documentation. (In JSON a section with
    // a '.' in its name becomes two.)
    std::stringstream xml;
    prm.print_parameters(xml,
                         dealii::ParameterHandler::XML |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    Tree all;
    boost::property_tree::read_xml(xml, all);

    std::vector<ParameterEntry> entries;
    const std::function<void(const Tree &, const std::string &)> look =
      [&](const Tree &tree, const std::string &path) {
        const auto pattern =
          tree.get_optional<std::string>("pattern_description");
        if (!pattern)
          {
            for (const auto &below : tree)
              look(below.second,
                   (path.empty() ? "" : path + "/") +
                     name_of_tag(below.first));
            return;
          }
        ParameterEntry entry;
        entry.path          = path;
        entry.value         = tree.get<std::string>("value");
        entry.default_value = tree.get<std::string>("default_value");
        entry.pattern       = *pattern;
        take_documentation(tree.get<std::string>("documentation"), entry);
        entries.push_back(entry);
      };
    look(all.get_child("ParameterHandler"), "");
    return entries;
  }
} // namespace lumbricus
