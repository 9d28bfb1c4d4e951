#include "IO/MeshMaterials.h"

#include "Base/Errors.h"
#include "IO/AbaqusWriter.h"
#include "IO/DynaWriter.h"
#include "IO/FebioWriter.h"
#include "IO/GmshWriter.h"
#include "Support/SolverMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{

/// Four cubes in a row: regions 0 0 1 1, materials 2 7 7 7.
shape::MeshSets FourCubes()
{
  const shape::Cells cells = shapetest::Cubes({ 4, 1, 1 }, [](int, int, int) { return true; });
  shape::MeshSets sets = shape::FindMeshSets(cells, Eigen::Vector4i(0, 0, 1, 1), 40.0);
  shape::MeshMaterialsOptions options;
  options.PoissonRatio = 0.25;
  options.DensityScale = 0.5;
  sets.Materials = shape::FindMeshMaterials(Eigen::Vector4i(2, 7, 7, 7),
    Eigen::Vector4d(100.0, 1234.5, 1234.5, 1234.5), Eigen::Vector4d(0.0, 1.5, 1.5, 1.5), options);
  return sets;
}

template <typename Write>
std::string TextOf(Write&& write)
{
  std::ostringstream text;
  write(text);
  return text.str();
}

void ExpectContains(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

} // namespace

TEST(MeshMaterials, HaveOneValueEach)
{
  const shape::MeshMaterials found = FourCubes().Materials;
  ASSERT_EQ(found.ByNumber.size(), 2U);
  EXPECT_EQ(found.ByNumber.at(7).Modulus, 1234.5);
  EXPECT_EQ(found.ByNumber.at(7).Density, 0.75);
  EXPECT_EQ(found.ByNumber.at(2).PoissonRatio, 0.25);
}

TEST(MeshMaterials, RefusesWhatNoSolverAccepts)
{
  const auto find = [](const Eigen::Vector2i& numbers, const Eigen::Vector2d& moduli,
                      const Eigen::Vector2d& densities, double poisson = 0.3, double scale = 1.0) {
    shape::FindMeshMaterials(numbers, moduli, densities, { poisson, scale });
  };
  const Eigen::Vector2i numbers(0, 1);
  const Eigen::Vector2d ones(1.0, 1.0);
  EXPECT_NO_THROW(find(numbers, ones, ones));
  EXPECT_THROW(find({ 0, -1 }, ones, ones), shape::InvalidInput);
  EXPECT_THROW(find(numbers, { 1.0, 0.0 }, ones), shape::InvalidInput);
  EXPECT_THROW(find(numbers, { 1.0, NAN }, ones), shape::InvalidInput);
  EXPECT_THROW(find(numbers, ones, { 1.0, -1.0 }), shape::InvalidInput);
  EXPECT_THROW(find({ 4, 4 }, { 1.0, 2.0 }, ones), shape::InvalidInput);
  EXPECT_THROW(find(numbers, ones, ones, 0.5), shape::InvalidInput);
  EXPECT_THROW(find(numbers, ones, ones, 0.3, 0.0), shape::InvalidInput);
}

TEST(MeshMaterials, AreSectionsForAbaqus)
{
  const std::string text =
    TextOf([](std::ostream& file) { shape::WriteAbaqus(file, FourCubes()); });
  ExpectContains(text, "*ELSET, ELSET=Region1\n3, 4\n");
  ExpectContains(text,
    "*ELSET, ELSET=Material2\n1\n*MATERIAL, NAME=Material2\n*ELASTIC\n100., .25\n"
    "*SOLID SECTION, ELSET=Material2, MATERIAL=Material2\n");
  ExpectContains(text,
    "*ELSET, ELSET=Material7\n2, 3, 4\n*MATERIAL, NAME=Material7\n*ELASTIC\n1234.5, .25\n"
    "*DENSITY\n.75\n*SOLID SECTION, ELSET=Material7, MATERIAL=Material7\n");
}

TEST(MeshMaterials, AreDomainsForFebio)
{
  const std::string text = TextOf([](std::ostream& file) { shape::WriteFebio(file, FourCubes()); });
  ExpectContains(text, "<material id=\"2\" name=\"Material7\" type=\"isotropic elastic\">");
  ExpectContains(text, "<density>0.75</density>\n\t\t\t<E>1234.5</E>\n\t\t\t<v>0.25</v>");
  for (const std::string part : { "Region0_Material2", "Region0_Material7", "Region1_Material7" })
  {
    ExpectContains(text, "<Elements type=\"hex8\" name=\"" + part + "\">");
    ExpectContains(text, "<SolidDomain name=\"" + part + "\" mat=\"" + part.substr(8) + "\"/>");
  }
}

TEST(MeshMaterials, ArePartsForDyna)
{
  const std::string text = TextOf([](std::ostream& file) { shape::WriteDyna(file, FourCubes()); });
  ExpectContains(text, "*PART\nRegion0_Material2\n         1         1         3\n");
  ExpectContains(text, "*PART\nRegion1_Material7\n         3         1         8\n");
  ExpectContains(text, "*SECTION_SOLID\n         1         1\n");
  ExpectContains(text, "*MAT_ELASTIC\n         8       .75    1234.5       .25\n");
}

TEST(MeshMaterials, AreGroupsForGmsh)
{
  const std::string text = TextOf([](std::ostream& file) { shape::WriteGmsh(file, FourCubes()); });
  ExpectContains(
    text, "3 1 \"Region0_Material2\"\n3 2 \"Region0_Material7\"\n3 3 \"Region1_Material7\"\n");
}
