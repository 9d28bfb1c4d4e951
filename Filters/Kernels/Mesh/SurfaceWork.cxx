#include "Mesh/SurfaceWork.h"

#include <utility>

namespace shape
{
namespace
{

std::atomic<SurfaceWork*> Active{ nullptr };

} // namespace

SurfaceWork::SurfaceWork(Eigen::MatrixXd points)
  : Points(std::move(points))
{
  Active = this;
}

SurfaceWork::~SurfaceWork()
{
  Active = nullptr;
}

void SurfaceWork::Note(Kind kind, const Eigen::MatrixXd& points)
{
  SurfaceWork* work = Active;
  if (work && points.rows() == work->Points.rows() && points == work->Points)
  {
    ++work->Counts[static_cast<std::size_t>(kind)];
  }
}

} // namespace shape
