#include "Solidify/Private/SheetPlates.h"

#include "Base/Errors.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"
#include "Mesh/TouchingSheets.h"
#include "Mesh/UsedPoints.h"
#include "Solidify/Private/ClosedDraft.h"
#include "Solidify/Private/EdgeGroups.h"
#include "Solidify/Private/SolidSurface.h"

#include <vector>

namespace shape
{
namespace
{

/// Sheets whose fans do not touch, and where their points and triangles come from.
struct Sheets
{
  shape::Surface Surface;
  std::vector<int> Points;
  std::vector<int> Triangles;
};

Sheets DraftSheets(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress)
{
  const MendedDraft draft = DraftSurface(surface, options, progress).Draft;
  const SplitSheets split = SplitTouchingSheets(draft.Surface);
  const std::vector<int> used =
    FindUsedPoints(split.Surface.Triangles, split.Surface.Points.rows());
  Sheets sheets;
  sheets.Surface = Mesh{ split.Surface.Points(used, Eigen::all),
    RenumberPoints(split.Surface.Triangles, used, split.Surface.Points.rows()) };
  for (const int point : used)
  {
    sheets.Points.push_back(draft.Points[split.Copied[point]]);
  }
  sheets.Triangles = draft.Triangles;
  return sheets;
}

/// Plates around oriented sheets. The points on the side of the normals come first, then as many on
/// the other side. cells: becomes the triangle of the input for each triangle.
Mesh MakePlates(const Sheets& sheets, double thickness, std::vector<int>& cells)
{
  const Eigen::MatrixXd& points = sheets.Surface.Points();
  const Eigen::MatrixXi& triangles = sheets.Surface.Triangles();
  const auto below = static_cast<int>(points.rows());
  cells = sheets.Triangles;
  cells.insert(cells.end(), sheets.Triangles.begin(), sheets.Triangles.end());
  std::vector<Eigen::RowVector3i> strips;
  ForEachEdge(sheets.Surface.HalfEdges(),
    [&](const HalfEdge* begin, const HalfEdge* end)
    {
      if (end - begin == 1)
      {
        strips.emplace_back(begin->End, begin->Begin, begin->Begin + below);
        strips.emplace_back(begin->End, begin->Begin + below, begin->End + below);
        cells.insert(cells.end(), 2, sheets.Triangles[begin->Triangle]);
      }
    });
  const Eigen::MatrixXd shift = 0.5 * thickness * GetVertexNormals(sheets.Surface);
  Mesh plates{ Eigen::MatrixXd(2 * points.rows(), 3),
    Eigen::MatrixXi(static_cast<Eigen::Index>(cells.size()), 3) };
  plates.Points << points + shift, points - shift;
  plates.Triangles.topRows(triangles.rows()) = triangles;
  plates.Triangles.middleRows(triangles.rows(), triangles.rows()) =
    triangles.rowwise().reverse().array() + below;
  for (std::size_t i = 0; i < strips.size(); ++i)
  {
    plates.Triangles.row(2 * triangles.rows() + static_cast<Eigen::Index>(i)) = strips[i];
  }
  return plates;
}

} // namespace

MendedSurface ThickenSheets(const Mesh& surface, double thickness,
  const SurfaceDefectOptions& options, const Progress& progress)
{
  const Sheets sheets = DraftSheets(surface, options, progress.Part(0.0, 0.2));
  std::vector<int> copies = sheets.Points;
  copies.insert(copies.end(), sheets.Points.begin(), sheets.Points.end());
  constexpr int rounds = 5;
  for (int round = 0;; ++round, thickness *= 0.5)
  {
    try
    {
      std::vector<int> cells;
      const Mesh plates = MakePlates(sheets, thickness, cells);
      MendedSurface solid = MakeSolidOfTriangles(plates, { 0.0, options.SmallestPiece },
        progress.Part(0.2 + 0.8 * round / rounds, 0.2 + 0.8 * (round + 1) / rounds));
      const Eigen::VectorXi sources =
        Eigen::Map<const Eigen::VectorXi>(cells.data(), static_cast<Eigen::Index>(cells.size()));
      solid.Provenance =
        Compose(TraceCopies(copies, surface.Points.rows(), sources), solid.Provenance);
      solid.Origin.setConstant(static_cast<int>(TriangleOrigin::Made));
      solid.RemovedTriangles = static_cast<int>(surface.Triangles.rows());
      return solid;
    }
    catch (const InvalidInput&) // thinner plates may be apart
    {
      if (round + 1 == rounds)
      {
        throw;
      }
    }
    catch (const SolveFailure&)
    {
      if (round + 1 == rounds)
      {
        throw;
      }
    }
  }
}

} // namespace shape
