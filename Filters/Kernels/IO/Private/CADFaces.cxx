#include "IO/Private/CADFaces.h"

#include "Base/Errors.h"

#include <algorithm>
#include <map>
#include <utility>

namespace shape
{
namespace
{

void RequireTriangles(const CascadeModel& faces)
{
  const auto failed = [](const CascadeFace& face) { return face.Triangles.empty(); };
  const auto first = std::find_if(faces.Faces.begin(), faces.Faces.end(), failed);
  if (first != faces.Faces.end())
  {
    const std::string& name = faces.PatchNames[first->Patch - 1];
    throw SolveFailure("OpenCASCADE cannot triangulate " +
      std::to_string(std::count_if(faces.Faces.begin(), faces.Faces.end(), failed)) + " of " +
      std::to_string(faces.Faces.size()) + " faces (first face " + std::to_string(first->Patch) +
      (name.empty() ? "" : ", '" + name + "'") +
      "); change Deflection, or repair the face in the CAD program");
  }
}

/// The points of a model, and where its edges and vertices are among them.
class JoinedPoints
{
public:
  /// Returns the point of each node of a face. Adds the face's edges to `edges` if they are new.
  std::vector<int> Find(const CascadeFace& face, std::vector<CADEdge>& edges);

  Eigen::MatrixXd Stack() const
  {
    Eigen::MatrixXd points(static_cast<Eigen::Index>(this->Positions.size()), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      points.row(i) = this->Positions[i].transpose();
    }
    return points;
  }

private:
  using Key = std::pair<int, int>; ///< region and number

  int Add(const Eigen::Vector3d& position)
  {
    this->Positions.push_back(position);
    return static_cast<int>(this->Positions.size()) - 1;
  }

  int FindVertex(const Key& key, const Eigen::Vector3d& position)
  {
    const auto [found, isNew] = this->Vertices.emplace(key, -1);
    return found->second = isNew ? this->Add(position) : found->second;
  }

  std::vector<int> AddEdge(const CascadeEdge& edge, int region);

  std::vector<Eigen::Vector3d> Positions;
  std::map<Key, int> Vertices;
  std::map<Key, std::vector<int>> Edges;
};

std::vector<int> JoinedPoints::AddEdge(const CascadeEdge& edge, int region)
{
  const std::size_t count = edge.Positions.size();
  std::vector<int> points(count);
  points.front() = this->FindVertex({ region, edge.FirstVertex }, edge.Positions.front());
  points.back() = this->FindVertex({ region, edge.LastVertex }, edge.Positions.back());
  for (std::size_t i = 1; i + 1 < count; ++i)
  {
    points[i] = edge.IsPoint ? points.front() : this->Add(edge.Positions[i]);
  }
  return points;
}

std::vector<int> JoinedPoints::Find(const CascadeFace& face, std::vector<CADEdge>& edges)
{
  std::vector<int> points(face.Nodes.size(), -1);
  for (const CascadeEdge& edge : face.Edges)
  {
    const auto [known, isNew] = this->Edges.emplace(Key{ face.Region, edge.Number }, 0);
    std::vector<int>& along = known->second;
    if (isNew)
    {
      along = this->AddEdge(edge, face.Region);
      if (!edge.IsPoint && !edge.IsSeam)
      {
        edges.push_back({ along, edge.Number });
      }
    }
    if (along.size() != edge.Nodes.size())
    {
      throw SolveFailure("OpenCASCADE divided an edge of face " + std::to_string(face.Patch) +
        " differently on its two sides; change Deflection");
    }
    for (std::size_t i = 0; i < along.size(); ++i)
    {
      points[edge.Nodes[i]] = along[i];
    }
  }
  for (std::size_t node = 0; node < points.size(); ++node)
  {
    points[node] = points[node] < 0 ? this->Add(face.Nodes[node]) : points[node];
  }
  return points;
}

} // namespace

CADModel JoinFaces(CascadeModel faces)
{
  RequireTriangles(faces);
  CADModel model;
  JoinedPoints joined;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> patches, regions;
  for (const CascadeFace& face : faces.Faces)
  {
    const std::vector<int> points = joined.Find(face, model.Edges);
    for (const auto& [a, b, c] : face.Triangles)
    {
      const std::array<int, 3> triangle{ points[a], points[b], points[c] };
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      {
        triangles.push_back(triangle);
      }
    }
    patches.resize(triangles.size(), face.Patch);
    regions.resize(triangles.size(), face.Region);
  }
  const auto count = static_cast<Eigen::Index>(triangles.size());
  model.Surface.Points = joined.Stack();
  model.Surface.Triangles.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    model.Surface.Triangles.row(i) = Eigen::RowVector3i::Map(triangles[i].data());
  }
  model.Patches = Eigen::VectorXi::Map(patches.data(), count);
  model.Regions = Eigen::VectorXi::Map(regions.data(), count);
  model.PatchNames = std::move(faces.PatchNames);
  model.RegionNames = std::move(faces.RegionNames);
  model.Unit = std::move(faces.Unit);
  model.Deflection = faces.Deflection;
  model.Distance = faces.Distance;
  return model;
}

} // namespace shape
