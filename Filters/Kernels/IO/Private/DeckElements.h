#pragma once

#include <string_view>

namespace shape
{

// VTK's quadratic cells.
inline constexpr int QuadraticTriangle = 22, QuadraticQuadrilateral = 23, QuadraticTetrahedron = 24,
                     QuadraticHexahedron = 25, QuadraticWedge = 26, QuadraticPyramid = 27;

/// What a name of an element means.
struct DeckElementType
{
  int Kind = 0;  ///< VTK cell type; 0 if the element is not read
  int Nodes = 0; ///< their order is that of VTK
};

/// name: in upper case, for example C3D8R, S4 or T3D2.
DeckElementType FindAbaqusElement(std::string_view name);

/// name: in lower case, for example hex8, tet10 or tri3.
DeckElementType FindFebioElement(std::string_view name);

} // namespace shape
