#pragma once

#include "Base/Progress.h"
#include "Geodesics/SurfacePath.h"
#include "Mesh/Graph.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <memory>
#include <optional>
#include <vector>

namespace shape
{

/// How creases attract a path on a surface.
struct CreaseOptions
{
  /// How much shorter an edge counts than it is; from 0 to 1e6. If the normals of its two triangles
  /// differ by the angle a, its cost is its length / (1 + CreaseWeight a / 90 degrees). 0: paths
  /// are shortest paths.
  double CreaseWeight = 0.0;
  enum class CreasesType
  {
    Concave, ///< seen from the side to which the normals point
    Convex,
    Both
  };
  CreasesType Creases = CreasesType::Concave;
  /// How far a point of a loop may move to a crease, as a share of its distance to the nearer of
  /// its two neighbours; from 0 to 0.5.
  double CreaseReach = 0.25;
};

/// Throws InvalidInput if an option is out of range.
void RequireOptions(const CreaseOptions& options);

/**
 * Finds paths on a surface that follow its creases: "intelligent scissors". The cost of a path is
 * its length, except along edges, whose cost is lower (CreaseOptions). Angles do not depend on the
 * size of the model, so neither do the paths.
 *
 * That an edge costs less the larger the angle between its triangles is, and the search by
 * Dijkstra's algorithm, are the scissors of Funkhouser et al. ("Modeling by example", ACM Trans.
 * Graph. 23(3), 2004). There, and in Lee et al. ("Intelligent mesh scissoring using 3D snakes",
 * Pacific Graphics 2004), paths run along edges only. Here the stretches on which edges save
 * nothing become shortest paths across triangles, as long as that lowers the cost. The result is a
 * local minimum, and never costs more than the path of SurfacePaths.
 *
 * An object serves many searches, from one thread at a time.
 */
class CreasePaths
{
public:
  /// surface: manifold or not. paths: the shortest paths on the same surface; it must outlive this
  /// object. Throws InvalidInput if an option is out of range.
  CreasePaths(const Surface& surface, SurfacePaths& paths, const CreaseOptions& options);

  /// Returns the path between two points. Throws the exceptions of SurfacePaths::Find.
  SurfacePath Find(const SurfacePoint& from, const SurfacePoint& to, const Progress& progress = {});

  /**
   * Returns a position on a crease near a point, or the point itself if there is no crease. Creases
   * are edges whose cost is at most half their length. Of those within a distance of `reach` (>= 0)
   * on the connected surface around the point, the one with the largest saving times (1 - distance
   * / reach) is chosen. This is the cursor snap of Mortensen and Barrett ("Intelligent scissors for
   * image composition", SIGGRAPH 1995).
   */
  SurfacePoint MoveToCrease(const SurfacePoint& point, double reach) const;

private:
  /// A part of a path: along one edge, or a shortest path.
  struct Piece
  {
    SurfacePath Path;
    double Cost;
    bool IsKept; ///< it and the next piece cannot be joined
  };
  /// A point of the surface next to an end of a path, in one triangle with it.
  struct NextPoint
  {
    int Point;
    double Cost;
    int Triangle;
  };

  Piece Straight(const SurfacePoint& from, const SurfacePoint& to, int triangle) const;
  SurfacePoint AtPoint(int point, int triangle) const;
  std::vector<NextPoint> NextPoints(const SurfacePoint& end) const;
  std::vector<Piece> FindAlongEdges(const SurfacePoint& from, const SurfacePoint& to) const;
  std::optional<Piece> FindShorter(
    const SurfacePoint& from, const SurfacePoint& to, double limit, const Progress& progress);
  bool Join(std::vector<Piece>& pieces, const Progress& progress);
  bool Slide(std::vector<Piece>& pieces, const Progress& progress);

  Surface Searched;
  SurfacePaths& Paths;
  std::shared_ptr<const Graph> Edges;
  std::vector<double> Factors; ///< cost over length of each half-edge
  std::vector<double> Costs;   ///< of each link of Edges
  std::vector<int> Triangles;  ///< of each link of Edges: one that contains it
};

} // namespace shape
