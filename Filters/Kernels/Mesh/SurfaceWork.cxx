#include "Mesh/SurfaceWork.h"

#include <utility>

namespace shape
{
namespace
{

std::atomic<SurfaceWork*> active{ nullptr };

} // namespace

SurfaceWork::SurfaceWork(Eigen::MatrixXd points)
  : Points(std::move(points))
{
  active = this;
}

SurfaceWork::~SurfaceWork()
{
  active = nullptr;
}

void SurfaceWork::Note(Kind kind, const Eigen::MatrixXd& points)
{
  SurfaceWork* work = active;
  if (work && points.rows() == work->Points.rows() && points == work->Points)
  {
    ++work->Counts[static_cast<std::size_t>(kind)];
  }
}

} // namespace shape
