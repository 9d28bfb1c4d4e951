#include "vtkShapeTriangulation.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkTriangleStrip.h"

#include "Base/Errors.h"

#include <algorithm>

namespace
{

/// Triangulates polygons with vtkPolygon, as vtkTriangleFilter does.
class PolygonTriangulator
{
public:
  explicit PolygonTriangulator(vtkPolyData* surface)
    : Surface(surface)
  {
  }

  /// Returns false if the polygon cannot be triangulated.
  bool Add(vtkIdType cell, vtkIdList* corners, vtkShapeTriangulation& result)
  {
    const vtkIdType count = corners->GetNumberOfIds();
    if (count == 3)
    {
      result.Add(corners->GetId(0), corners->GetId(1), corners->GetId(2), cell);
      return true;
    }
    return count < 3 || this->AddWhole(cell, corners, result) ||
      this->AddWithoutRepeats(cell, corners, result);
  }

private:
  bool AddWhole(vtkIdType cell, vtkIdList* corners, vtkShapeTriangulation& result)
  {
    const vtkIdType count = corners->GetNumberOfIds();
    this->Polygon->PointIds->SetNumberOfIds(count);
    this->Polygon->Points->SetNumberOfPoints(count);
    for (vtkIdType k = 0; k < count; ++k)
    {
      this->Polygon->PointIds->SetId(k, corners->GetId(k));
      this->Polygon->Points->SetPoint(k, this->Surface->GetPoint(corners->GetId(k)));
    }
    this->Polygon->Triangulate(this->Ids);
    if (this->Ids->GetNumberOfIds() != 3 * (count - 2))
    {
      return false;
    }
    for (vtkIdType k = 0; k < this->Ids->GetNumberOfIds(); k += 3)
    {
      result.Add(corners->GetId(this->Ids->GetId(k)), corners->GetId(this->Ids->GetId(k + 1)),
        corners->GetId(this->Ids->GetId(k + 2)), cell);
    }
    return true;
  }

  /// A corner at the position of the corner before it is left out of the polygon, and gets a
  /// triangle without area instead.
  bool AddWithoutRepeats(vtkIdType cell, vtkIdList* corners, vtkShapeTriangulation& result)
  {
    const vtkIdType count = corners->GetNumberOfIds();
    const std::vector<bool> isRepeated =
      vtkShapeTriangulation::FindRepeated(this->Surface, corners);
    const auto repeats = [&](vtkIdType k) { return isRepeated[k % count]; };
    vtkIdType start = 0;
    while (start < count && repeats(start))
    {
      ++start;
    }
    vtkNew<vtkIdList> kept;
    vtkShapeTriangulation flat;
    const auto addFlat = [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      if (a != b && b != c && c != a)
      {
        flat.Add(a, b, c, cell);
      }
    };
    for (vtkIdType k = start; k < start + count; ++k)
    {
      const vtkIdType corner = corners->GetId(k % count);
      if (k == start || !repeats(k))
      {
        kept->InsertNextId(corner);
      }
      else
      {
        addFlat(kept->GetId(kept->GetNumberOfIds() - 1), corner, corners->GetId((k + 1) % count));
      }
    }
    if (kept->GetNumberOfIds() == count)
    {
      return false;
    }
    if (kept->GetNumberOfIds() < 3)
    {
      // All of it is a line or a position: triangles without area.
      flat = {};
      for (vtkIdType k = 2; k < count; ++k)
      {
        addFlat(corners->GetId(0), corners->GetId(k - 1), corners->GetId(k));
      }
    }
    else if (kept->GetNumberOfIds() == 3)
    {
      result.Add(kept->GetId(0), kept->GetId(1), kept->GetId(2), cell);
    }
    else if (!this->AddWhole(cell, kept, result))
    {
      return false;
    }
    for (const auto& [a, b, c] : flat.Triangles)
    {
      result.Add(a, b, c, cell);
    }
    return true;
  }

  vtkPolyData* Surface;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Ids;
};

} // namespace

std::vector<bool> vtkShapeTriangulation::FindRepeated(vtkPolyData* surface, vtkIdList* corners)
{
  const vtkIdType count = corners->GetNumberOfIds();
  const auto distance2 = [&](vtkIdType i, vtkIdType j)
  {
    double one[3], other[3];
    surface->GetPoint(corners->GetId(i), one);
    surface->GetPoint(corners->GetId(j), other);
    return vtkMath::Distance2BetweenPoints(one, other);
  };
  double size2 = 0.0;
  for (vtkIdType k = 1; k < count; ++k)
  {
    size2 = std::max(size2, distance2(0, k));
  }
  // vtkPolygon takes sides below 1e-6 of the size for 0.
  constexpr double share2 = 1e-10;
  std::vector<bool> isRepeated(count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    isRepeated[k] = distance2((k + count - 1) % count, k) <= share2 * size2;
  }
  return isRepeated;
}

vtkShapeTriangulation vtkShapeTriangulation::Of(vtkPolyData* surface, const std::string& name)
{
  vtkShapeTriangulation result;
  PolygonTriangulator polygons(surface);
  vtkNew<vtkIdList> corners;
  vtkIdType cell = 0, failed = 0, first = -1;
  for (vtkIdType i = 0; i < surface->GetPolys()->GetNumberOfCells(); ++i, ++cell)
  {
    surface->GetPolys()->GetCellAtId(i, corners);
    if (!polygons.Add(cell, corners, result))
    {
      first = failed++ == 0 ? i : first;
    }
  }
  if (failed > 0)
  {
    throw shape::InvalidInput(name + " has " + std::to_string(failed) +
      (failed == 1 ? " polygon" : " polygons") + " that cannot be triangulated (first polygon " +
      std::to_string(first) +
      "); merge its repeated points with Clean, or divide it where it "
      "crosses itself");
  }
  for (vtkIdType i = 0; i < surface->GetStrips()->GetNumberOfCells(); ++i, ++cell)
  {
    surface->GetStrips()->GetCellAtId(i, corners);
    vtkNew<vtkCellArray> strip;
    vtkTriangleStrip::DecomposeStrip(corners->GetNumberOfIds(), corners->GetPointer(0), strip);
    vtkNew<vtkIdList> triangle;
    for (vtkIdType t = 0; t < strip->GetNumberOfCells(); ++t)
    {
      strip->GetCellAtId(t, triangle);
      result.Add(triangle->GetId(0), triangle->GetId(1), triangle->GetId(2), cell);
    }
  }
  return result;
}
