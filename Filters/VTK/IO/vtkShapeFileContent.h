#pragma once

#include "Base/Progress.h"
#include "IO/DeckReader.h"
#include "Mesh/Cells.h"

#include <functional>
#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace shape
{
struct CADModel;
struct MeditMesh;
struct OFFSurface;
} // namespace shape

/// Files as VTK data sets.
namespace vtkShapeFileContent
{

/// Returns all bytes of a file. Throws shape::InvalidInput if it cannot be read, or the path is
/// empty.
std::string Read(const std::string& path);

/// Calls a function that reads a file. Its errors name the file. Throws shape::InvalidInput, too,
/// if the path is empty.
void CallWithName(const std::string& path, const std::function<void()>& function);

/// Returns the path of a file that another file names. Relative names start from its folder.
std::string FindBeside(const std::string& path, const std::string& name);

/// Reads a deck and the files that it includes. Throws as shape::ReadDeck does.
shape::Deck ReadDeck(const std::string& path, std::string content, const shape::Progress& progress,
  shape::DeckContent wanted);

/// Fills a surface with points, faces and the arrays of vtkShapeOFFReader.
void ToPolyData(const shape::OFFSurface& surface, vtkPolyData* output);

/// Fills a surface with triangles and another one with polylines, and both with the arrays of
/// vtkShapeCADReader.
void ToPolyData(const shape::CADModel& model, vtkPolyData* surface, vtkPolyData* edges);

/// Fills a grid with points, cells and the arrays of vtkShapeMeditReader.
void ToGrid(const shape::MeditMesh& mesh, vtkUnstructuredGrid* output);

/// Fills a grid with the nodes, elements and arrays of vtkShapeDeckReader. path: of the deck.
void ToGrid(const shape::Deck& deck, const std::string& path, vtkUnstructuredGrid* output);

} // namespace vtkShapeFileContent
