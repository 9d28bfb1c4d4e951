#include "Correspondence/SurfaceMapFacts.h"

#include "Surface/CotangentWeights.h"

#include <Eigen/Geometry>

#include <cmath>

namespace shape
{

SurfaceMapFacts DescribeMaps(const Mesh& a, const Mesh& b, const SurfaceMaps& maps)
{
  const Eigen::MatrixXd images = Pulled(maps.AToB, b.Triangles, b.Points);
  const TriangleAngles angles = AnglesOfTriangles(a);
  const Eigen::SparseMatrix<double> stiffness =
    PositiveStiffness(CotangentStiffness(a.Triangles, angles.Cotangents, a.Points.rows()), 0.0);
  const Eigen::VectorXd masses = LumpedMasses(a.Triangles, angles.Areas, a.Points.rows());
  const double areaA = masses.sum(), areaB = PointAreas(b).sum();
  SurfaceMapFacts facts;
  facts.DirichletEnergy = 0.5 * (images.transpose() * (stiffness * images)).trace() / areaB;
  const Eigen::MatrixXd back =
    Pulled(maps.AToB, b.Triangles, Pulled(maps.BToA, a.Triangles, a.Points));
  facts.RoundTrip = masses.dot((back - a.Points).rowwise().norm()) / (areaA * std::sqrt(areaA));
  const Eigen::MatrixXd image = AreaVectors({ images, a.Triangles }), normals = AreaVectors(b);
  double reversed = 0.0;
  for (Eigen::Index t = 0; t < a.Triangles.rows(); ++t)
  {
    const int place = maps.AToB.Triangles(a.Triangles(t, 0));
    reversed += image.row(t).dot(normals.row(place)) < 0.0 ? angles.Areas(t) : 0.0;
  }
  facts.ReversedArea = reversed / areaA;
  return facts;
}

} // namespace shape
