#include "Core/Errors.h"
#include "Core/Topology.h"
#include "TestShapes.h"
#include "Volume/Tetrahedralize.h"

#include <gtest/gtest.h>

TEST(Tetrahedralize, ASphere)
{
  const shape::Mesh s = shapetest::Icosphere(3);
  const auto r = shape::Tetrahedralize(s);
  std::cout << r.Points.rows() << " " << r.Tetrahedra.rows() << " " << r.Volume << " "
            << shape::EnclosedVolume(s) << " " << r.MinimumScaledJacobian << " " << r.SteinerPoints
            << "\n";
}
