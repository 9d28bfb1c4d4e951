#include "IO/CADReader.h"

#include "Base/Errors.h"
#include "IO/Private/CADProcess.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// Returns the format that the first characters show.
CADFormat FindFormat(std::string_view content)
{
  const std::string_view head = content.substr(0, 1024);
  if (head.find("ISO-10303-21") != std::string_view::npos)
  {
    return CADFormat::STEP;
  }
  if (head.find("DBRep_DrawableShape") != std::string_view::npos ||
    head.find("CASCADE Topology") != std::string_view::npos)
  {
    return CADFormat::BREP;
  }
  // Column 73 of each line of an IGES file is the letter of its section, which begins with S.
  if (head.size() > 80 && head[72] == 'S' &&
    head.substr(0, 72).find('\n') == std::string_view::npos)
  {
    return CADFormat::IGES;
  }
  throw InvalidInput(content.empty()
      ? "the file is empty; choose another file"
      : "the file does not begin as a STEP, IGES or BREP file does; export one of these formats "
        "as text");
}

void CheckOptions(const CADReaderOptions& options)
{
  const auto require = [](bool good, const char* name, double value, const char* range)
  {
    if (!good)
    {
      throw InvalidInput(
        std::string(name) + " is " + std::to_string(value) + "; it must be " + range);
    }
  };
  require(options.Deflection >= 0.0 && std::isfinite(options.Deflection), "Deflection",
    options.Deflection, "0 or more, and finite");
  require(
    options.Angle >= 1.0 && options.Angle <= 90.0, "Angle", options.Angle, "from 1 to 90 degrees");
  require(options.SewingTolerance >= 0.0 && std::isfinite(options.SewingTolerance),
    "SewingTolerance", options.SewingTolerance, "0 or more, and finite");
}

/// What is known of a region's triangles.
struct RegionFacts
{
  double Volume = 0.0; ///< six times the enclosed volume, if it is closed
  int OpenEdges = 0;
};

/// Returns the facts of each region.
std::vector<RegionFacts> FindRegionFacts(const CADModel& model)
{
  std::vector<RegionFacts> facts(model.RegionNames.size());
  const Eigen::MatrixXi& triangles = model.Surface.Triangles;
  const Eigen::RowVector3d origin = model.Surface.Points.row(triangles(0, 0));
  std::vector<std::array<int, 3>> edges; // both ends, ascending, and the region
  for (Eigen::Index triangle = 0; triangle < triangles.rows(); ++triangle)
  {
    const Eigen::Matrix3d corners = GetCorners(model.Surface, triangle).rowwise() - origin;
    facts[model.Regions(triangle)].Volume += corners.determinant();
    for (int k = 0; k < 3; ++k)
    {
      const auto [low, high] =
        std::minmax({ triangles(triangle, k), triangles(triangle, (k + 1) % 3) });
      edges.push_back({ low, high, model.Regions(triangle) });
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end)
  {
    end = first + 1;
    while (end < edges.size() && edges[end] == edges[first])
    {
      ++end;
    }
    facts[edges[first][2]].OpenEdges += end - first == 1;
  }
  return facts;
}

} // namespace

CADModel ReadCAD(
  std::string_view content, const CADReaderOptions& options, const Progress& progress)
{
  CheckOptions(options);
  CADModel model = RunCADProcess(content, FindFormat(content), options, progress.Part(0.0, 0.95));
  const std::vector<RegionFacts> facts = FindRegionFacts(model);
  for (Eigen::Index triangle = 0; triangle < model.Regions.size(); ++triangle)
  {
    const RegionFacts& region = facts[model.Regions(triangle)];
    if (region.OpenEdges == 0 && region.Volume < 0.0)
    {
      std::swap(model.Surface.Triangles(triangle, 1), model.Surface.Triangles(triangle, 2));
    }
  }
  for (const RegionFacts& region : facts)
  {
    model.OpenEdges += region.OpenEdges;
  }
  progress(1.0);
  return model;
}

} // namespace shape
