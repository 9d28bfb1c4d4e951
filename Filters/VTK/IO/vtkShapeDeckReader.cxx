#include "vtkShapeDeckReader.h"

#include "vtkShapeFileContent.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include "IO/DeckReader.h"

#include <utility>

vtkStandardNewMacro(vtkShapeDeckReader);

std::string vtkShapeDeckReader::GetOutputType()
{
  return "vtkUnstructuredGrid";
}

void vtkShapeDeckReader::ReadContent(
  std::string content, vtkDataObject* output, const shape::Progress& progress)
{
  const std::string path = this->GetFileName();
  const shape::Deck deck = vtkShapeFileContent::ReadDeck(
    path, std::move(content), progress, shape::DeckContent::NodesAndElements);
  vtkShapeFileContent::ToGrid(deck, path, vtkUnstructuredGrid::SafeDownCast(output));
}
