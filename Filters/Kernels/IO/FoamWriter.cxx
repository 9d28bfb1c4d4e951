#include "IO/FoamWriter.h"

#include "IO/Private/ExactText.h"

#include <string>

namespace shape
{
namespace
{

void WriteHeader(
  std::ostream& file, const char* type, const char* name, const std::string& note = {})
{
  file << "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       " << type
       << ";\n";
  if (!note.empty())
  {
    file << "    note        \"" << note << "\";\n";
  }
  file << "    location    \"constant/polyMesh\";\n    object      " << name << ";\n}\n\n";
}

/// Writes a list: its length, and entries by their index.
template <typename WriteEntry>
void WriteList(
  std::ostream& file, Eigen::Index count, const WriteEntry& write, const Progress& progress = {})
{
  file << count << "\n(\n";
  for (Eigen::Index i = 0; i < count; ++i)
  {
    write(i);
    file << '\n';
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(count));
    }
  }
  file << ")\n";
}

template <typename Values>
void WriteIntegers(std::ostream& file, const Values& values, const Progress& progress = {})
{
  WriteList(
    file, static_cast<Eigen::Index>(values.size()), [&](Eigen::Index i) { file << values[i]; },
    progress);
}

void WritePoints(std::ostream& file, const PolyMesh& mesh, const Progress& progress)
{
  WriteHeader(file, "vectorField", "points");
  const auto write = [&](Eigen::Index i)
  {
    file << '(' << ToExactText(mesh.Points(i, 0)) << ' ' << ToExactText(mesh.Points(i, 1)) << ' '
         << ToExactText(mesh.Points(i, 2)) << ')';
  };
  WriteList(file, mesh.Points.rows(), write, progress);
}

void WriteFaces(std::ostream& file, const PolyMesh& mesh, const Progress& progress)
{
  WriteHeader(file, "faceList", "faces");
  const auto write = [&](Eigen::Index i)
  {
    const int size = mesh.Faces(i, 3) < 0 ? 3 : 4;
    file << size << '(' << mesh.Faces(i, 0);
    for (int k = 1; k < size; ++k)
    {
      file << ' ' << mesh.Faces(i, k);
    }
    file << ')';
  };
  WriteList(file, mesh.Faces.rows(), write, progress);
}

void WriteOwner(std::ostream& file, const PolyMesh& mesh, const Progress& progress)
{
  WriteHeader(file, "labelList", "owner",
    "nPoints:" + std::to_string(mesh.Points.rows()) + " nCells:" + std::to_string(mesh.CellCount) +
      " nFaces:" + std::to_string(mesh.Faces.rows()) +
      " nInternalFaces:" + std::to_string(mesh.Neighbours.size()));
  WriteIntegers(file, mesh.Owners, progress);
}

void WriteNeighbour(std::ostream& file, const PolyMesh& mesh, const Progress& progress)
{
  WriteHeader(file, "labelList", "neighbour");
  WriteIntegers(file, mesh.Neighbours, progress);
}

void WriteBoundary(std::ostream& file, const PolyMesh& mesh, const Progress&)
{
  WriteHeader(file, "polyBoundaryMesh", "boundary");
  const auto write = [&](Eigen::Index i)
  {
    const FacePatch& patch = mesh.Patches[i];
    file << "    " << patch.Name
         << "\n    {\n        type            patch;\n        nFaces          " << patch.Count
         << ";\n        startFace       " << patch.First << ";\n    }";
  };
  WriteList(file, static_cast<Eigen::Index>(mesh.Patches.size()), write);
}

/// Writes a dictionary for each zone: its type, and what `write` adds.
template <typename Zone, typename WriteContent>
void WriteZones(std::ostream& file, const char* type, const std::vector<Zone>& zones,
  const WriteContent& write, const Progress& progress)
{
  WriteHeader(file, "regIOobject", (std::string(type) + "s").c_str());
  const auto writeZone = [&](Eigen::Index i)
  {
    file << zones[i].Name << "\n{\n    type            " << type << ";\n";
    write(zones[i]);
    file << ";\n}";
  };
  WriteList(file, static_cast<Eigen::Index>(zones.size()), writeZone, progress);
}

void WriteCellZones(std::ostream& file, const PolyMesh& mesh, const Progress& progress)
{
  const auto write = [&](const CellZone& zone)
  {
    file << "    cellLabels      List<label>\n";
    WriteIntegers(file, zone.Cells);
  };
  WriteZones(file, "cellZone", mesh.CellZones, write, progress);
}

void WriteFaceZones(std::ostream& file, const PolyMesh& mesh, const Progress& progress)
{
  const auto write = [&](const FaceZone& zone)
  {
    file << "    faceLabels      List<label>\n";
    WriteIntegers(file, zone.Faces);
    file << ";\n    flipMap         List<bool>\n";
    WriteIntegers(file, zone.Flips);
  };
  WriteZones(file, "faceZone", mesh.FaceZones, write, progress);
}

} // namespace

const std::vector<FoamFile>& GetFoamFiles()
{
  static const std::vector<FoamFile> files = { { "points", WritePoints }, { "faces", WriteFaces },
    { "owner", WriteOwner }, { "neighbour", WriteNeighbour }, { "boundary", WriteBoundary },
    { "cellZones", WriteCellZones }, { "faceZones", WriteFaceZones } };
  return files;
}

} // namespace shape
