#pragma once

#include "IO/MeshSets.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// Elements of a file that have one kind and belong to one set.
struct ElementBlock
{
  int Kind = 0; ///< a constant of cell_kind
  std::string Set;
  int SetNumber = 0;        ///< from 1; unique among the sets of the dimension
  int Material = -1;        ///< number of the material, or -1
  std::vector<int> Numbers; ///< of the elements, ascending from 1
  Eigen::MatrixXi Corners;  ///< one row for each element: points of the mesh
};

/**
 * Divides a mesh into blocks for formats that list elements by set: by dimension (highest first),
 * set and kind.
 *
 * Cells keep their index + 1 as number, and belong to the set "Region0" and so on, of number
 * region + 1. If the mesh has materials, the solid cells of each region and material are a set
 * "Region0_Material0" and so on; the sets are then numbered in this order. If the mesh has solid
 * cells but no surface cells, the faces of its boundary follow in the sets "Patch0" and so on, of
 * number patch + 1, and the faces between regions in the sets "Interface0_1" and so on, which
 * continue the numbers of the patches. A face faces outwards, or out of the lower region.
 */
std::vector<ElementBlock> GroupElements(const MeshSets& sets);

} // namespace shape
