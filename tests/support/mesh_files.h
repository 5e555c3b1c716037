// The project's own parts in every mesh format, for tests. All files have the same corners, which a
// binary STL can hold exactly.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/parts/part_maker.h"  // Part

namespace test {

std::string stl_file(const parts::Part& part);
std::string obj_file(const parts::Part& part);
std::string amf_file(const parts::Part& part);
std::string sif_file(const parts::Part& part);
std::string old_sif_file(const parts::Part& part);

// The model part of a 3MF package, and a package around it.
std::string threemf_model(const parts::Part& part);
std::string threemf_file(const std::string& model);

// A package with two boxes in a mesh and the roles that a slicer gives them; and roles by which the
// second is cut out of the first.
std::string two_volume_threemf_file(const std::string& roles);
std::string negative_volume_roles();

// The model part of another, whose object is two slices.
std::string sliced_threemf_model();

// name and content of each entry, packed.
std::string zip_file(const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace test
