#include "IO/Private/DeckElements.h"

#include "Mesh/Cells.h"

#include <charconv>
#include <cstddef>

namespace shape
{
namespace
{

using namespace cell_kind;

/// Names of elements begin with one of these, and then with their number of nodes.
struct AbaqusFamily
{
  std::string_view Prefix;
  int Dimension;
};
constexpr AbaqusFamily AbaqusFamilies[] = { { "C3D", 3 }, { "DC3D", 3 }, { "DCC3D", 3 },
  { "AC3D", 3 }, { "SC", 3 }, { "S", 2 }, { "DS", 2 }, { "STRI", 2 }, { "M3D", 2 }, { "SFM3D", 2 },
  { "R3D", 2 }, { "CPS", 2 }, { "CPE", 2 }, { "CAX", 2 }, { "DC2D", 2 }, { "AC2D", 2 },
  { "DCAX", 2 }, { "T3D", 1 } };

DeckElementType FindByNodes(int dimension, int nodes)
{
  constexpr DeckElementType solids[] = { { Tetrahedron, 4 }, { Pyramid, 5 }, { Wedge, 6 },
    { Hexahedron, 8 }, { QuadraticTetrahedron, 10 }, { QuadraticPyramid, 13 },
    { QuadraticWedge, 15 }, { QuadraticHexahedron, 20 } };
  constexpr DeckElementType surfaces[] = { { Triangle, 3 }, { Quadrilateral, 4 },
    { QuadraticTriangle, 6 }, { QuadraticQuadrilateral, 8 } };
  if (dimension == 1 && nodes == 2)
  {
    return { Line, 2 };
  }
  for (const DeckElementType& type : solids)
  {
    if (dimension == 3 && type.Nodes == nodes)
    {
      return type;
    }
  }
  for (const DeckElementType& type : surfaces)
  {
    if (dimension == 2 && type.Nodes == nodes)
    {
      return type;
    }
  }
  return {};
}

} // namespace

DeckElementType FindAbaqusElement(std::string_view name)
{
  if (name == "STRI65")
  {
    return { QuadraticTriangle, 6 };
  }
  if (name == "B31" || name == "B31R")
  {
    return { Line, 2 };
  }
  const std::size_t digit = name.find_first_of("0123456789");
  for (const AbaqusFamily& family : AbaqusFamilies)
  {
    if (digit == std::string_view::npos || name.substr(0, family.Prefix.size()) != family.Prefix)
    {
      continue;
    }
    int nodes = 0;
    const char* first = name.data() + family.Prefix.size();
    const char* end = name.data() + name.size();
    if (std::from_chars(first, end, nodes).ptr != first)
    {
      return FindByNodes(family.Dimension, nodes);
    }
  }
  return {};
}

DeckElementType FindFebioElement(std::string_view name)
{
  struct FebioFamily
  {
    std::string_view Prefix;
    int Dimension;
  };
  constexpr FebioFamily families[] = { { "hex", 3 }, { "tet", 3 }, { "penta", 3 }, { "pyra", 3 },
    { "quad", 2 }, { "tri", 2 }, { "q", 2 }, { "line", 1 }, { "truss", 1 } };
  for (const FebioFamily& family : families)
  {
    if (name.substr(0, family.Prefix.size()) == family.Prefix)
    {
      int nodes = 0;
      const char* first = name.data() + family.Prefix.size();
      const char* end = name.data() + name.size();
      if (std::from_chars(first, end, nodes).ptr != first)
      {
        return FindByNodes(family.Dimension, nodes);
      }
    }
  }
  return {};
}

} // namespace shape
