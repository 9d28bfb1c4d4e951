#include "vtkShapeDeckReader.h"

#include "vtkShapeFileContent.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include "IO/DeckReader.h"

vtkStandardNewMacro(vtkShapeDeckReader);

std::string vtkShapeDeckReader::GetOutputType()
{
  return "vtkUnstructuredGrid";
}

void vtkShapeDeckReader::ReadContent(
  std::string_view content, vtkDataObject* output, const shape::Progress& progress)
{
  const std::string path = this->GetFileName();
  const shape::Deck deck = vtkShapeFileContent::ReadDeck(path, std::string(content), progress);
  vtkShapeFileContent::ToGrid(deck, path, vtkUnstructuredGrid::SafeDownCast(output));
}
