// The tetrahedra of the regions of a label image by CGAL's mesher: a peer of Shape Label Surfaces
// with Shape Tetrahedralize, which LabelImages.py runs.
#include "Driver/Case.h"
#include "Driver/Cost.h"

#include "Base/Errors.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <fstream>
#include <string>

namespace
{

constexpr const char* Usage = R"(IMAGE RESULT FACET_SIZE FACET_DISTANCE CELL_SIZE

Meshes the labels of an image (INRIMAGE) by CGAL's make_mesh_3, with its own optimisation, and writes
the tetrahedra with their labels (MEDIT). FACET_SIZE: the largest radius of the balls around
interface triangles; FACET_DISTANCE: their largest distance from the interface; CELL_SIZE: the
largest radius of the balls around tetrahedra; all in the image's units. Angles of interface
triangles are at least 30 degrees, ratios of radius to edge at most 3.

Figures: vertices, tetrahedra, cost.)";

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string path = arguments.NextWord(), written = arguments.NextWord();
  const double size = arguments.NextNumber(), distance = arguments.NextNumber();
  const double cell = arguments.NextNumber();
  arguments.RequireAllRead();
  CGAL::Image_3 image;
  if (!image.read(path.c_str()))
  {
    throw shape::InvalidInput("CGAL cannot read the image " + path);
  }
  Complex mesh;
  const benchmark::Cost cost = benchmark::Measure(
    [&]()
    {
      namespace parameters = CGAL::parameters;
      const Domain domain = Domain::create_labeled_image_mesh_domain(image);
      const Criteria criteria(parameters::facet_angle = 30.0, parameters::facet_size = size,
        parameters::facet_distance = distance, parameters::cell_radius_edge_ratio = 3.0,
        parameters::cell_size = cell);
      mesh = CGAL::make_mesh_3<Complex>(domain, criteria);
    });
  std::ofstream file(written);
  file.precision(17);
  mesh.output_to_medit(file);
  figures.Print(benchmark::Row()
                  .Add("vertices", mesh.triangulation().number_of_vertices())
                  .Add("tetrahedra", mesh.number_of_cells_in_complex())
                  .Add(cost));
}

const benchmark::Entry ImageTetrahedra("image_tetrahedra", { Usage, Run });

} // namespace
