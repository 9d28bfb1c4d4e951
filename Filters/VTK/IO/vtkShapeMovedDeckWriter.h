/**
 * @class   vtkShapeMovedDeckWriter
 * @brief   write an input deck again with its nodes moved
 *
 * Input: the points of vtkShapeDeckReader after any filter that moves points (vtkPolyData or
 * vtkUnstructuredGrid) with the point array `NodeId`, and `NodePart` if the deck has parts. Every
 * node of the deck must be there.
 *
 * In the copy of the deck, only the coordinates of nodes that moved are different; every other byte
 * is the same. If the copy is in another folder than the deck, the files that the deck includes by
 * relative names are written beside the copy, under the same names. If an included file has nodes,
 * the copy must be in another folder.
 *
 * Format of the coordinates, and errors: shape::FindMovedNodes and shape::WriteMovedFile.
 */
#ifndef vtkShapeMovedDeckWriter_h
#define vtkShapeMovedDeckWriter_h

#include "vtkShapeFileWriter.h"

namespace shape
{
struct Deck;
}

class VTKSHAPEFILTERS_EXPORT vtkShapeMovedDeckWriter : public vtkShapeFileWriter
{
public:
  static vtkShapeMovedDeckWriter* New();
  vtkTypeMacro(vtkShapeMovedDeckWriter, vtkShapeFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The properties. Effects and ranges: vtkShapeMovedDeckWriter.xml.
  vtkSetStdStringFromCharMacro(Deck);
  vtkGetCharFromStdStringMacro(Deck);
  ///@}

protected:
  vtkShapeMovedDeckWriter() = default;
  ~vtkShapeMovedDeckWriter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  Content ReadInput(const shape::Progress& progress) override;

private:
  vtkShapeMovedDeckWriter(const vtkShapeMovedDeckWriter&) = delete;
  void operator=(const vtkShapeMovedDeckWriter&) = delete;

  std::string FindDeck() const;
  void AddIncludedFiles(
    const std::string& path, const std::function<Content(int)>& contentOf, const shape::Deck& deck);

  std::string Deck;
};

#endif
