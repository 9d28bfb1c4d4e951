#pragma once

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPolyData;

/// The blocks of composite data, each of which is a shape of a collection.
namespace vtkShapeBlocks
{

/// A surface, which is the same on every process.
struct Block
{
  vtkSmartPointer<vtkPolyData> Data;
  std::string Name; ///< of the block; may be empty
  int Number = 0;   ///< of the block at the top level
};

/// Returns the surface of each block of the top level, over all processes: blocks inside it and
/// pieces of several processes are joined. Blocks without points are left out; `empty` gets their
/// names and numbers. name: of the input, in messages. Throws shape::InvalidInput on every process
/// if a block is no surface.
std::vector<Block> Gather(vtkDataObject* data, vtkMultiProcessController* controller,
  std::vector<Block>* empty = nullptr, const std::string& name = "Shapes");

} // namespace vtkShapeBlocks
