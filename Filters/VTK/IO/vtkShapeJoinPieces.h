/**
 * @class   vtkShapeJoinPieces
 * @brief   what several processes have of a mesh as one mesh, for the writers
 *
 * Of several inputs, points at exactly the same place become one, so that the pieces hang together.
 * One input alone stays as it is: points that it has twice, as in a crack, are so on purpose.
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
