/**
 * @class   vtkShapeJoinPieces
 * @brief   what several processes have of a mesh as one mesh, for the writers
 *
 * Coincident points of several inputs are merged, so that the pieces are connected, unless
 * MergePieces is off. A single input is passed on unchanged, because coincident points in it are
 * intended, for example along a crack. The field data are those of the first input.
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

  ///@{
  /// Whether coincident points of several inputs are merged. The default is true.
  vtkSetMacro(MergePieces, bool);
  vtkGetMacro(MergePieces, bool);
  ///@}

protected:
  vtkShapeJoinPieces() = default;
  ~vtkShapeJoinPieces() override = default;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkShapeJoinPieces(const vtkShapeJoinPieces&) = delete;
  void operator=(const vtkShapeJoinPieces&) = delete;

  bool MergePieces = true;
};

#endif
