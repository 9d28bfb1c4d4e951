/**
 * @class   vtkShapeDeckReader
 * @brief   read the mesh of an input deck of Abaqus, CalculiX, LS-DYNA or FEBio
 *
 * Output: vtkUnstructuredGrid with double points: all nodes of the deck and of the files that it
 * includes, in their order, also nodes that no element uses.
 * - Point array `NodeId` (vtkIdType): the number of the node in the deck. `NodePart` (int), if the
 *   deck has parts: parts number their nodes independently.
 * - Cell arrays `ElementId` (vtkIdType) and `RegionId` (int): the element set or part, from 0. The
 *   field array `RegionName` (string) has their names.
 * - Field array `Deck` (string): the path of the file. Shape Moved Deck Writer reads it.
 *
 * Facts in the field data, with the prefix DeckReader: .SkippedElements, the number of elements
 * that are not read, and .Skipped, their types.
 *
 * Formats, keywords and elements: shape::ReadDeck. Included files are looked for in the folder of
 * the deck.
 */
#ifndef vtkShapeDeckReader_h
#define vtkShapeDeckReader_h

#include "vtkShapeReader.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeDeckReader : public vtkShapeReader
{
public:
  static vtkShapeDeckReader* New();
  vtkTypeMacro(vtkShapeDeckReader, vtkShapeReader);

protected:
  vtkShapeDeckReader() = default;
  ~vtkShapeDeckReader() override = default;
  std::string GetOutputType() override;
  void ReadContent(
    std::string content, vtkDataObject* output, const shape::Progress& progress) override;

private:
  vtkShapeDeckReader(const vtkShapeDeckReader&) = delete;
  void operator=(const vtkShapeDeckReader&) = delete;
};

#endif
