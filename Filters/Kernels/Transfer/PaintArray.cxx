#include "Transfer/PaintArray.h"

#include "Base/Errors.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/Graph.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace shape
{

namespace
{

/// The points and edges of a surface, and links between coincident points.
Graph LinkPoints(const Surface& surface)
{
  std::vector<std::pair<int, int>> links;
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = surface.Triangles()(t, k);
      const int to = surface.Triangles()(t, (k + 1) % 3);
      if (from != to)
      {
        links.emplace_back(from, to);
      }
    }
  }
  const std::vector<int> first = FindCoincidentPoints(surface.Points());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    if (first[i] != static_cast<int>(i))
    {
      links.emplace_back(first[i], static_cast<int>(i));
    }
  }
  return BuildGraph(surface.Points(), std::move(links));
}

void RequireStroke(const BrushStroke& stroke, std::size_t index)
{
  const std::string name = "of stroke " + std::to_string(index);
  RequireOption(stroke.Radius > 0.0 && std::isfinite(stroke.Radius), "Radius " + name,
    stroke.Radius, "a finite number greater than 0");
  RequireOption(stroke.Strength >= 0.0 && stroke.Strength <= 1.0, "Strength " + name,
    stroke.Strength, "from 0 to 1");
  RequireOption(std::isfinite(stroke.Value), "Value " + name, stroke.Value, "finite");
  if (!stroke.Positions.allFinite())
  {
    throw InvalidInput("a position " + name + " is not finite; remove it");
  }
}

bool HaveSameBrush(const BrushStroke& one, const BrushStroke& other)
{
  return one.Mode == other.Mode && one.Radius == other.Radius && one.Strength == other.Strength &&
    one.Value == other.Value;
}

/// Whether `longer` is `stroke`, or `stroke` with further positions.
bool Continues(const BrushStroke& longer, const BrushStroke& stroke)
{
  const Eigen::Index count = stroke.Positions.rows();
  return HaveSameBrush(longer, stroke) && longer.Positions.rows() >= count &&
    longer.Positions.topRows(count) == stroke.Positions;
}

} // namespace

struct SurfacePainter::Canvas
{
  Canvas(const Surface& surface, Eigen::VectorXd initial)
    : Locator(surface)
    , Links(LinkPoints(surface))
    , Areas(ComputePointAreas(surface))
    , Initial(std::move(initial))
    , Values(this->Initial)
    , Weights(Eigen::VectorXd::Zero(this->Initial.size()))
    , Marks(static_cast<std::size_t>(this->Initial.size()), 0)
  {
  }

  struct Painted
  {
    int Point;
    double Weight;
  };

  /// Lists the points with a weight at a position, in Ball.
  void FindBall(const Eigen::RowVector3d& position, double radius);
  void ActOnce(const BrushStroke& brush);
  void Smooth(double strength);
  void Begin(const BrushStroke& stroke);
  void Restart();

  SurfaceLocator Locator;
  Graph Links;
  Eigen::VectorXd Areas; ///< of each point
  Eigen::VectorXd Initial, Values;
  std::vector<BrushStroke> Done; ///< that Values contain
  Eigen::VectorXd Before;        ///< the values before the last stroke of Done
  Eigen::VectorXd Weights;       ///< of the points for the last stroke of Done
  std::vector<Painted> Ball;
  std::vector<int> Queue;
  std::vector<int> Marks; ///< the number of the last search that reached the point
  int Search = 0;
  int Triangle = -1; ///< that the last position was closest to
};

void SurfacePainter::Canvas::FindBall(const Eigen::RowVector3d& position, double radius)
{
  const Surface& surface = this->Locator.GetSurface();
  this->Triangle = this->Locator.FindOne(position, this->Triangle).Triangle;
  ++this->Search;
  this->Queue.clear();
  this->Ball.clear();
  const auto reach = [&](int point)
  {
    if (this->Marks[static_cast<std::size_t>(point)] != this->Search)
    {
      this->Marks[static_cast<std::size_t>(point)] = this->Search;
      const double share = (surface.Points().row(point) - position).norm() / radius;
      if (share < 1.0)
      {
        const double root = 1.0 - share * share;
        this->Ball.push_back({ point, root * root });
        this->Queue.push_back(point);
      }
    }
  };
  for (int k = 0; k < 3; ++k)
  {
    reach(surface.Triangles()(this->Triangle, k));
  }
  for (std::size_t next = 0; next < this->Queue.size(); ++next)
  {
    const auto point = static_cast<std::size_t>(this->Queue[next]);
    for (int k = this->Links.First[point]; k < this->Links.First[point + 1]; ++k)
    {
      reach(this->Links.Neighbours[static_cast<std::size_t>(k)]);
    }
  }
}

void SurfacePainter::Canvas::ActOnce(const BrushStroke& brush)
{
  for (const Painted& painted : this->Ball)
  {
    if (painted.Weight > this->Weights(painted.Point))
    {
      this->Weights(painted.Point) = painted.Weight;
      const double before = this->Before(painted.Point);
      const double change =
        brush.Mode == BrushStroke::ModeType::Set ? brush.Value - before : brush.Value;
      this->Values(painted.Point) = before + brush.Strength * painted.Weight * change;
    }
  }
}

void SurfacePainter::Canvas::Smooth(double strength)
{
  double sum = 0.0;
  double mass = 0.0;
  for (const Painted& painted : this->Ball)
  {
    const double share = painted.Weight * this->Areas(painted.Point);
    sum += share * this->Values(painted.Point);
    mass += share;
  }
  if (mass > 0.0)
  {
    for (const Painted& painted : this->Ball)
    {
      double& value = this->Values(painted.Point);
      value += strength * painted.Weight * (sum / mass - value);
    }
  }
}

void SurfacePainter::Canvas::Begin(const BrushStroke& stroke)
{
  this->Before = this->Values;
  this->Weights.setZero();
  this->Done.push_back(stroke);
  this->Done.back().Positions.resize(0, 3);
}

void SurfacePainter::Canvas::Restart()
{
  this->Values = this->Initial;
  this->Done.clear();
  this->Triangle = -1; // a guess decides among triangles at equal distance
}

SurfacePainter::SurfacePainter(const Surface& surface, Eigen::VectorXd initial)
{
  RequireIndices(surface);
  RequireFinite(surface.Points(), "the surface");
  RequireFinite(initial, "the initial values");
  if (initial.size() != surface.Points().rows())
  {
    throw InvalidInput("there are " + std::to_string(initial.size()) + " initial values for " +
      std::to_string(surface.Points().rows()) + " points; give one for each point");
  }
  this->Impl = std::make_unique<Canvas>(surface, std::move(initial));
}

SurfacePainter::~SurfacePainter() = default;
SurfacePainter::SurfacePainter(SurfacePainter&&) noexcept = default;
SurfacePainter& SurfacePainter::operator=(SurfacePainter&&) noexcept = default;

const Eigen::VectorXd& SurfacePainter::Paint(
  const std::vector<BrushStroke>& strokes, const Progress& progress)
{
  Canvas& canvas = *this->Impl;
  for (std::size_t s = 0; s < strokes.size(); ++s)
  {
    RequireStroke(strokes[s], s);
  }
  bool isContinued = strokes.size() >= canvas.Done.size();
  for (std::size_t s = 0; isContinued && s < canvas.Done.size(); ++s)
  {
    isContinued = Continues(strokes[s], canvas.Done[s]) &&
      (s + 1 == canvas.Done.size() || Continues(canvas.Done[s], strokes[s]));
  }
  if (!isContinued)
  {
    canvas.Restart();
  }
  for (std::size_t s = canvas.Done.empty() ? 0 : canvas.Done.size() - 1; s < strokes.size(); ++s)
  {
    if (s == canvas.Done.size())
    {
      canvas.Begin(strokes[s]);
    }
    const Eigen::MatrixXd& positions = strokes[s].Positions;
    const auto share = [&](std::size_t stroke)
    { return static_cast<double>(stroke) / static_cast<double>(strokes.size()); };
    const Progress part = progress.Part(share(s), share(s + 1), "painting the strokes");
    for (Eigen::Index p = canvas.Done[s].Positions.rows(); p < positions.rows(); ++p)
    {
      part(static_cast<double>(p) / static_cast<double>(positions.rows()));
      canvas.FindBall(positions.row(p), strokes[s].Radius);
      if (strokes[s].Mode == BrushStroke::ModeType::Smooth)
      {
        canvas.Smooth(strokes[s].Strength);
      }
      else
      {
        canvas.ActOnce(strokes[s]);
      }
      canvas.Done[s].Positions.conservativeResize(p + 1, 3);
      canvas.Done[s].Positions.row(p) = positions.row(p);
    }
  }
  return canvas.Values;
}

Eigen::VectorXd PaintArray(const Surface& surface, Eigen::VectorXd initial,
  const std::vector<BrushStroke>& strokes, const Progress& progress)
{
  return SurfacePainter(surface, std::move(initial)).Paint(strokes, progress);
}

} // namespace shape
