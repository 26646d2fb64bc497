// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/manifest.h>
#include <lumbricus/core/item_lines.h>

#include <algorithm>
#include <limits>

namespace lumbricus
{
  namespace
  {
    const std::string manifest_end = "checksum ";
    const std::string cells_begin  = "cells.";

    constexpr auto any_32 = std::numeric_limits<std::uint32_t>::max();



    std::string
    last_line(const std::string &above)
    {
      return manifest_end + std::to_string(fingerprint(above).checksum) + "\n";
    }
  } // namespace



  const std::string Manifest::file_name  = "MANIFEST";
  const std::string Manifest::mesh       = "mesh";
  const std::string Manifest::progress   = "progress";
  const std::string Manifest::inputs     = "inputs";
  const std::string Manifest::parameters = "parameters.prm";



  std::string
  Manifest::cells(const unsigned int rank)
  {
    return cells_begin + std::to_string(rank);
  }



  bool
  Manifest::is_name_of_a_file(const std::string &name)
  {
    const std::string number = name.substr(
      name.compare(0, cells_begin.size(), cells_begin) == 0 ?
        cells_begin.size() :
        name.size());
    return name == file_name || name == mesh || name == progress ||
           name == inputs || name == parameters ||
           (!number.empty() &&
            number.find_first_not_of("0123456789") == std::string::npos);
  }



  std::string
  Manifest::line_of_file(const std::string &name, const Fingerprint &content)
  {
    return "file " + std::to_string(content.checksum) + " " +
           std::to_string(content.size) + " " + name + "\n";
  }



  std::string
  Manifest::line_of_cells(const unsigned int rank,
                          const unsigned int n_cells,
                          const unsigned int cell_size)
  {
    return "cells " + std::to_string(rank) + " " + std::to_string(n_cells) +
           " " + std::to_string(cell_size) + "\n";
  }



  std::string
  Manifest::text(const std::string &run_id, const std::string &lines)
  {
    const std::string above =
      "version " LUMBRICUS_VERSION "\nrun " + run_id + "\n" + lines;
    return above + last_line(above);
  }



  Manifest
  Manifest::read(const std::string &text)
  {
    const auto end = text.rfind(manifest_end);
    AssertThrow(end != std::string::npos, ExcDamaged("was not completed."));
    const std::string above = text.substr(0, end);
    AssertThrow(text.substr(end) == last_line(above),
                ExcDamaged("has a wrong checksum."));

    Manifest  manifest;
    ItemLines lines(above);
    while (lines.next())
      if (lines.item() == "version" && manifest.version.empty())
        manifest.version = lines.get_word();
      else if (lines.item() == "run" && manifest.run_id.empty())
        manifest.run_id = lines.get_word();
      else if (lines.item() == "cells")
        {
          if (lines.get_count(any_32) != manifest.cells_of_rank.size())
            lines.fail();
          manifest.cells_of_rank.push_back(lines.get_count(any_32));
          const auto size = lines.get_count(any_32);
          if (manifest.cells_of_rank.size() > 1 && size != manifest.cell_size)
            lines.fail();
          manifest.cell_size = size;
        }
      else if (lines.item() == "file")
        {
          Fingerprint content;
          content.checksum =
            lines.get_count(Fingerprint::largest_checksum);
          content.size = lines.get_count(Fingerprint::largest_size);
          const std::string name = lines.get_word();
          if (!is_name_of_a_file(name) ||
              !manifest.files.emplace(name, content).second)
            lines.fail();
        }
      else
        AssertThrow(false, ExcUnknownItem(lines.item()));

    AssertThrow(!manifest.version.empty(),
                ExcDamaged("does not have 'version'."));
    AssertThrow(!manifest.run_id.empty(),
                ExcDamaged("of version " + manifest.version +
                           " does not have 'run', which this version, "
                           LUMBRICUS_VERSION ", needs."));
    std::vector<std::string> needed = {mesh, progress, inputs, parameters};
    for (unsigned int rank = 0; rank < manifest.cells_of_rank.size(); ++rank)
      needed.push_back(cells(rank));
    for (const std::string &name : needed)
      AssertThrow(manifest.files.count(name) > 0,
                  ExcDamaged("does not have the file '" + name + "'."));
    AssertThrow(manifest.files.size() == needed.size(),
                ExcDamaged("has more files than a checkpoint has."));
    for (unsigned int rank = 0; rank < manifest.cells_of_rank.size(); ++rank)
      AssertThrow(manifest.files.at(cells(rank)).size ==
                    std::uintmax_t(manifest.cells_of_rank[rank]) *
                      manifest.cell_size,
                  ExcDamaged("has another number of cells than the file '" +
                             cells(rank) + "' has room for."));
    return manifest;
  }
} // namespace lumbricus
