// SPDX-License-Identifier: LGPL-2.1-or-later
#include "checkpoint_files.h"

#include <lumbricus/checkpoint/checkpoint_folders.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/item_lines.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace lumbricus
{
  namespace
  {
    const std::string mesh_header = "cells that are refined\n";



    std::string
    content_of(const std::string &file_name)
    {
      std::ifstream in(file_name, std::ios::binary);
      return {std::istreambuf_iterator<char>(in), {}};
    }
  } // namespace



  std::string
  write_and_check(const RunFolder   &folder,
                  const std::string &checkpoint,
                  const std::string &name,
                  const std::string &content)
  {
    folder.write(checkpoint_in_folder(checkpoint) + "/" + name,
                 [&](std::ostream &out) { out << content; });
    const std::string file_name =
      checkpoint_path(folder, checkpoint) + "/" + name;
    AssertThrow(content_of(file_name) == content,
                ExcSolveFailed("The file '" + file_name +
                               "' is not on disk as it was written. Check "
                               "the disk."));
    return Manifest::line_of_file(name, fingerprint(content));
  }



  std::string
  read_regular(const std::string   &path,
               const std::string   &name,
               const std::uintmax_t most)
  {
    const std::string file_name = path + "/" + name;
    std::error_code   error;
    AssertThrow(std::filesystem::is_regular_file(
                  std::filesystem::symlink_status(file_name, error)),
                ExcDamaged("does not have the file '" + name + "'."));
    AssertThrow(std::filesystem::file_size(file_name, error) <= most,
                ExcDamaged("has a file '" + name + "' of more than " +
                           std::to_string(most) + " bytes."));
    return content_of(file_name);
  }



  std::string
  read_listed(const std::string   &path,
              const std::string   &name,
              const Manifest      &manifest,
              const std::uintmax_t most)
  {
    const std::string content = read_regular(path, name, most);
    const Fingerprint listed  = manifest.files.at(name);
    AssertThrow(content.size() == listed.size,
                ExcDamaged("has a file '" + name + "' of " +
                           std::to_string(content.size()) +
                           " bytes instead of " +
                           std::to_string(listed.size) + "."));
    AssertThrow(fingerprint(content) == listed,
                ExcDamaged("has a file '" + name +
                           "' whose checksum is wrong."));
    return content;
  }



  std::string
  mesh_content(const std::set<CellKey> &refined)
  {
    std::string content = mesh_header;
    for (const CellKey &key : refined)
      content.append(reinterpret_cast<const char *>(key.data()),
                     sizeof(CellKey));
    return content;
  }



  std::uintmax_t
  largest_mesh_content(const std::uintmax_t n_cells)
  {
    // A cell that is cut gives eight, of which seven are more than before.
    return mesh_header.size() + n_cells / 7 * sizeof(CellKey);
  }



  bool
  is_mesh_content(const std::string &content)
  {
    return content.compare(0, mesh_header.size(), mesh_header) == 0 &&
           (content.size() - mesh_header.size()) % sizeof(CellKey) == 0;
  }



  std::set<CellKey>
  refined_in(const std::string &content)
  {
    std::set<CellKey> refined;
    for (std::size_t at = mesh_header.size(); at < content.size();
         at += sizeof(CellKey))
      {
        CellKey key;
        std::copy_n(content.data() + at,
                    sizeof(CellKey),
                    reinterpret_cast<char *>(key.data()));
        refined.insert(key);
      }
    return refined;
  }
} // namespace lumbricus
