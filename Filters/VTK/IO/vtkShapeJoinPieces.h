/**
 * @class   vtkShapeJoinPieces
 * @brief   what several processes have of a mesh as one mesh, for the writers
 *
 * Coincident points of several inputs are merged, so that the pieces are connected. A single input
 * is passed on unchanged, because coincident points in it are intended, for example along a crack.
 */
#ifndef vtkShapeJoinPieces_h
#define vtkShapeJoinPieces_h

#include "vtkAppendFilter.h"
#include "vtkShapeFiltersModule.h" // for the export macro

class VTKSHAPEFILTERS_EXPORT vtkShapeJoinPieces : public vtkAppendFilter
{
public:
  static vtkShapeJoinPieces* New();
  vtkTypeMacro(vtkShapeJoinPieces, vtkAppendFilter);

protected:
  vtkShapeJoinPieces() = default;
  ~vtkShapeJoinPieces() override = default;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkShapeJoinPieces(const vtkShapeJoinPieces&) = delete;
  void operator=(const vtkShapeJoinPieces&) = delete;
};

#endif
