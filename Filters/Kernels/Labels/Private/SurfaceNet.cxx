#include "Labels/Private/SurfaceNet.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Labels/Private/NetCube.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace shape
{
namespace
{

using namespace net_cube;

/// Builds a net, slab by slab.
class NetBuilder
{
public:
  NetBuilder(const LabelImage& image, const Progress& progress)
    : Image(image)
    , Report(progress)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Cubes[axis] = image.Size[axis] + 1;
    }
    this->Slab = static_cast<std::size_t>(this->Cubes[0]) * this->Cubes[1];
  }

  SurfaceNet Build()
  {
    this->FindCubes(this->Report.Part(0.0, 0.5));
    this->PlacePoints();
    this->FindDoubledEdges();
    this->AddPolygons(this->Report.Part(0.5, 1.0));
    return std::move(this->Net);
  }

private:
  /// The label at a sample of the image that is enlarged by one layer of the outside.
  int LabelAt(int i, int j, int k) const
  {
    const auto& size = this->Image.Size;
    const bool isInside = i > 0 && j > 0 && k > 0 && i <= size[0] && j <= size[1] && k <= size[2];
    return isInside ? this->Image.Labels[this->Image.IndexOf(i - 1, j - 1, k - 1)] : 0;
  }

  /// Where the interface crosses an edge of a cube, from 0 to 1.
  double CrossingOf(const std::array<int, 3>& cube, int edge) const
  {
    std::array<std::size_t, 2> samples;
    const std::array<int, 2> corners = CornersOf(edge);
    for (int end = 0; end < 2; ++end)
    {
      std::array<int, 3> at;
      for (int axis = 0; axis < 3; ++axis)
      {
        // The enlarged image begins one sample earlier.
        at[axis] = cube[axis] - 1 + ((corners[end] >> axis) & 1);
        if (at[axis] < 0 || at[axis] >= this->Image.Size[axis])
        {
          return 0.5; // nothing is known beyond the image
        }
      }
      samples[end] = this->Image.IndexOf(at[0], at[1], at[2]);
    }
    return FindCrossing(this->Image, samples[0], samples[1]);
  }

  std::size_t CubeIndex(int i, int j, int k) const
  {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(this->Cubes[0]) * j +
      this->Slab * k;
  }

  void FindCubes(const Progress& progress);
  void PlacePoints();
  void FindDoubledEdges();
  void AddPolygons(const Progress& progress);

  const LabelImage& Image;
  const Progress Report;
  std::array<int, 3> Cubes;
  std::size_t Slab;
  std::vector<int> MixedAt;           ///< for each cube, its index in Mixed, or -1
  std::vector<Cube> Mixed;            ///< the cubes with several labels, in order
  std::vector<std::array<int, 3>> At; ///< where they are
  /// For a face with two sheets that have the same points on both sides: the points of the sheets
  /// around corner 1 (or 2) and around corner 3 (or 0). The key is 3 times the mixed cube above the
  /// face plus the face's axis.
  std::unordered_map<int, std::array<int, 2>> Doubled;
  SurfaceNet Net;
};

void NetBuilder::FindCubes(const Progress& progress)
{
  struct SlabCubes
  {
    std::vector<Cube> Mixed;
    std::vector<std::array<int, 3>> At;
  };
  std::vector<SlabCubes> slabs(this->Cubes[2]);
  const auto fill = [&](int begin, int end)
  {
    for (int k = begin; k < end; ++k)
    {
      for (int j = 0; j < this->Cubes[1]; ++j)
      {
        std::array<int, 8> labels;
        for (int corner = 1; corner < 8; corner += 2)
        {
          labels[corner] = this->LabelAt(0, j + ((corner >> 1) & 1), k + (corner >> 2));
        }
        for (int i = 0; i < this->Cubes[0]; ++i)
        {
          bool isMixed = false;
          for (int corner = 0; corner < 8; corner += 2)
          {
            labels[corner] = labels[corner + 1];
            labels[corner + 1] = this->LabelAt(i + 1, j + ((corner >> 1) & 1), k + (corner >> 2));
          }
          for (const int label : labels)
          {
            isMixed = isMixed || label != labels[0];
          }
          if (isMixed)
          {
            Cube cube;
            cube.Labels = labels;
            NumberSheets(cube);
            slabs[k].Mixed.push_back(cube);
            slabs[k].At.push_back({ i, j, k });
          }
        }
      }
    }
  };
  ParallelFor(this->Cubes[2], 1, fill, progress);
  this->MixedAt.assign(this->Slab * this->Cubes[2], -1);
  std::int64_t points = 0;
  for (SlabCubes& slab : slabs)
  {
    for (std::size_t n = 0; n < slab.Mixed.size(); ++n)
    {
      Cube& cube = slab.Mixed[n];
      const auto [i, j, k] = slab.At[n];
      this->MixedAt[this->CubeIndex(i, j, k)] = static_cast<int>(this->Mixed.size());
      cube.FirstPoint = static_cast<int>(points);
      points += cube.Count;
      if (points > std::numeric_limits<int>::max() / 4)
      {
        throw InvalidInput(
          "the interfaces have too many points; resample the image to fewer voxels");
      }
      this->Mixed.push_back(cube);
      this->At.push_back(slab.At[n]);
    }
    slab = {};
  }
  this->Net.Points.setZero(points, 3);
  this->Net.Centres.resize(points, 3);
}

void NetBuilder::PlacePoints()
{
  const auto place = [&](int begin, int end)
  {
    for (int n = begin; n < end; ++n)
    {
      const Cube& cube = this->Mixed[n];
      // The enlarged image begins at index -1.
      const Eigen::RowVector3d corner(
        this->At[n][0] - 1.0, this->At[n][1] - 1.0, this->At[n][2] - 1.0);
      std::array<int, CubeEdges> edges = {};
      for (int edge = 0; edge < CubeEdges; ++edge)
      {
        if (cube.SheetOf[edge] != -1)
        {
          const int axis = edge / 4;
          Eigen::RowVector3d crossing;
          crossing(axis) = this->CrossingOf(this->At[n], edge);
          crossing(Following(axis, 1)) = edge & 1;
          crossing(Following(axis, 2)) = (edge >> 1) & 1;
          this->Net.Points.row(cube.FirstPoint + cube.SheetOf[edge]) += crossing;
          ++edges[cube.SheetOf[edge]];
        }
      }
      for (int sheet = 0; sheet < cube.Count; ++sheet)
      {
        auto point = this->Net.Points.row(cube.FirstPoint + sheet);
        point = corner + point / edges[sheet];
        this->Net.Centres.row(cube.FirstPoint + sheet) = corner.array() + 0.5;
      }
    }
  };
  constexpr int grain = 4096;
  ParallelFor(static_cast<int>(this->Mixed.size()), grain, place);
}

void NetBuilder::FindDoubledEdges()
{
  const auto isCrossed = [](const std::array<int, 4>& labels, int edge)
  { return labels[edge] != labels[(edge + 1) % 4]; };
  std::vector<Eigen::RowVector3d> added, centres;
  const int first = static_cast<int>(this->Net.Points.rows());
  std::vector<char> isJunction(first, 0);
  for (std::size_t n = 0; n < this->Mixed.size(); ++n)
  {
    const Cube& cube = this->Mixed[n];
    for (int axis = 0; axis < 3; ++axis)
    {
      std::array<int, 3> below = this->At[n];
      if (--below[axis] < 0)
      {
        continue; // outside the enlarged image, no interface
      }
      const std::array<int, 4> labels = LabelsOf(cube, Faces[2 * axis]);
      const int crossings =
        isCrossed(labels, 0) + isCrossed(labels, 1) + isCrossed(labels, 2) + isCrossed(labels, 3);
      if (crossings == 0)
      {
        continue;
      }
      const Cube& other = this->Mixed[this->MixedAt[this->CubeIndex(below[0], below[1], below[2])]];
      const auto pointAt = [&](const Cube& at, int edge, int side)
      { return at.FirstPoint + at.SheetOf[Faces[2 * axis + side].Edges[edge]]; };
      const Sheets sheets = FindSheets(labels);
      if (sheets == Sheets::Joined)
      {
        const int edge = isCrossed(labels, 0) ? 0 : isCrossed(labels, 1) ? 1 : 2;
        const int a = pointAt(cube, edge, 0), b = pointAt(other, edge, 1);
        this->Net.Edges.push_back({ a, b, crossings > 2 });
        if (crossings > 2)
        {
          isJunction[a] = isJunction[b] = 1;
        }
        continue;
      }
      // Edge `lone` and the one after it cross around corner lone + 1, the others around the corner
      // opposite.
      const int lone = sheets == Sheets::AroundCorner1 ? 0 : 1;
      const std::array<std::array<int, 2>, 2> ends = {
        { { pointAt(cube, lone, 0), pointAt(other, lone, 1) },
          { pointAt(cube, lone + 2, 0), pointAt(other, lone + 2, 1) } }
      };
      if (ends[0] != ends[1])
      {
        this->Net.Edges.push_back({ ends[0][0], ends[0][1], false });
        this->Net.Edges.push_back({ ends[1][0], ends[1][1], false });
        continue;
      }
      std::array<int, 2>& points = this->Doubled[static_cast<int>(3 * n) + axis];
      for (int sheet = 0; sheet < 2; ++sheet)
      {
        points[sheet] = first + static_cast<int>(added.size());
        const int corner = Faces[2 * axis].Corners[(lone + 1 + 2 * sheet) % 4];
        const int bits[] = { corner & 1, (corner >> 1) & 1, (corner >> 2) & 1 };
        Eigen::RowVector3d centre, position;
        for (int c = 0; c < 3; ++c)
        {
          centre(c) = this->At[n][c] - 1.0 + (c == axis ? 0.0 : 0.5);
          // Half-way from the face's centre to the corner.
          position(c) = centre(c) + (c == axis ? 0.0 : 0.5 * (bits[c] - 0.5));
        }
        added.push_back(position);
        centres.push_back(centre);
        this->Net.Edges.push_back({ ends[sheet][0], points[sheet], false });
        this->Net.Edges.push_back({ points[sheet], ends[sheet][1], false });
      }
    }
  }
  const Eigen::Index all = first + static_cast<Eigen::Index>(added.size());
  this->Net.Points.conservativeResize(all, 3);
  this->Net.Centres.conservativeResize(all, 3);
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    this->Net.Points.row(first + static_cast<Eigen::Index>(i)) = added[i];
    this->Net.Centres.row(first + static_cast<Eigen::Index>(i)) = centres[i];
  }
  this->Net.Reach = Eigen::VectorXd::Constant(all, 0.5);
  for (int point = 0; point < first; ++point)
  {
    if (isJunction[point])
    {
      this->Net.Reach(point) = 1.0;
      this->Net.JunctionPoints.push_back(point);
    }
  }
}

void NetBuilder::AddPolygons(const Progress& progress)
{
  struct Side
  {
    int Greater, Lower;
  };
  struct Polygon
  {
    std::array<int, 8> Points;
    int Count;
    Side Regions;
  };
  constexpr int grain = 4096;
  const int cubes = static_cast<int>(this->Mixed.size());
  std::vector<std::vector<Polygon>> chunks((cubes + grain - 1) / grain);
  // The four cubes around an edge of the enlarged image, counter-clockwise around its axis: steps
  // down along the axes that follow, and the axis along which the next cube lies.
  constexpr int steps[4][2] = { { 1, 1 }, { 0, 1 }, { 0, 0 }, { 1, 0 } };
  const auto collect = [&](int begin, int end)
  {
    for (int n = begin; n < end; ++n)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        // The edge from the cube's first corner: it is in this cube and three below.
        const Cube& cube = this->Mixed[n];
        const int edge = EdgeOf(axis, 0, 0);
        if (cube.SheetOf[edge] == -1)
        {
          continue;
        }
        const int b = Following(axis, 1), c = Following(axis, 2);
        std::array<int, 4> around;
        for (int s = 0; s < 4; ++s)
        {
          std::array<int, 3> at = this->At[n];
          at[b] -= steps[s][0];
          at[c] -= steps[s][1];
          around[s] = this->MixedAt[this->CubeIndex(at[0], at[1], at[2])];
        }
        Polygon polygon;
        polygon.Count = 0;
        for (int s = 0; s < 4; ++s)
        {
          const Cube& here = this->Mixed[around[s]];
          polygon.Points[polygon.Count++] =
            here.FirstPoint + here.SheetOf[EdgeOf(axis, steps[s][0], steps[s][1])];
          if (this->Doubled.empty())
          {
            continue;
          }
          // The face between this cube and the next: the upper one of both is above it.
          const int next = (s + 1) % 4;
          const int across = s % 2 == 0 ? b : c;
          const int which = s % 2 == 0 ? 0 : 1;
          const int upper = steps[s][which] == 0 ? s : next;
          const auto found = this->Doubled.find(3 * around[upper] + across);
          if (found == this->Doubled.end())
          {
            continue;
          }
          const Cube& above = this->Mixed[around[upper]];
          const CubeFace& face = Faces[2 * across];
          const int own = EdgeOf(axis, steps[upper][0], steps[upper][1]);
          const int position = static_cast<int>(
            std::find(face.Edges.begin(), face.Edges.end(), own) - face.Edges.begin());
          const int lone = FindSheets(LabelsOf(above, face)) == Sheets::AroundCorner1 ? 0 : 1;
          const bool isFirst = position == lone || position == lone + 1;
          polygon.Points[polygon.Count++] = found->second[isFirst ? 0 : 1];
        }
        const std::array<int, 2> corners = CornersOf(edge);
        polygon.Regions = { cube.Labels[corners[0]], cube.Labels[corners[1]] };
        if (polygon.Regions.Greater < polygon.Regions.Lower)
        {
          std::swap(polygon.Regions.Greater, polygon.Regions.Lower);
          std::reverse(polygon.Points.begin(), polygon.Points.begin() + polygon.Count);
        }
        chunks[begin / grain].push_back(polygon);
      }
    }
  };
  ParallelFor(cubes, grain, collect, progress);
  std::vector<Polygon> larger;
  std::int64_t quads = 0, triangles = 0;
  for (const std::vector<Polygon>& chunk : chunks)
  {
    for (const Polygon& polygon : chunk)
    {
      quads += polygon.Count == 4;
      triangles += polygon.Count - 2;
    }
  }
  if (triangles > std::numeric_limits<int>::max() / 4)
  {
    throw InvalidInput(
      "the interfaces have too many triangles; resample the image to fewer voxels");
  }
  this->Net.Quads = static_cast<int>(quads);
  this->Net.Triangles.resize(triangles, 3);
  this->Net.Regions.resize(triangles, 2);
  Eigen::Index next = 0;
  const auto add = [&](int a, int b, int c, const Side& regions)
  {
    this->Net.Triangles.row(next) << a, b, c;
    this->Net.Regions.row(next++) << regions.Greater, regions.Lower;
  };
  for (const std::vector<Polygon>& chunk : chunks)
  {
    for (const Polygon& polygon : chunk)
    {
      if (polygon.Count > 4)
      {
        larger.push_back(polygon);
        continue;
      }
      const auto& p = polygon.Points;
      add(p[0], p[1], p[2], polygon.Regions);
      add(p[0], p[2], p[3], polygon.Regions);
    }
  }
  const int cubePoints =
    this->Mixed.empty() ? 0 : this->Mixed.back().FirstPoint + this->Mixed.back().Count;
  for (const Polygon& polygon : larger)
  {
    // A diagonal from a point on a face is no edge of another polygon.
    const auto& p = polygon.Points;
    const int start = static_cast<int>(
      std::find_if(p.begin(), p.begin() + polygon.Count, [&](int i) { return i >= cubePoints; }) -
      p.begin());
    for (int i = 1; i + 1 < polygon.Count; ++i)
    {
      add(p[start], p[(start + i) % polygon.Count], p[(start + i + 1) % polygon.Count],
        polygon.Regions);
    }
  }
}

} // namespace

SurfaceNet BuildSurfaceNet(const LabelImage& image, const Progress& progress)
{
  return NetBuilder(image, progress).Build();
}

} // namespace shape
