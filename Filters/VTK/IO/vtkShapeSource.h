/**
 * @class   vtkShapeSource
 * @brief   base of what has no input: readers and example shapes
 *
 * Output: data sets. If the pipeline requests pieces, the first piece is the entire data set, and
 * the others are empty; an image is cropped to the requested extent. An error empties the outputs,
 * and its text starts with the label of the source.
 */
#ifndef vtkShapeSource_h
#define vtkShapeSource_h

#include "vtkAlgorithm.h"
#include "vtkShapeFiltersModule.h" // for the export macro

#include "Base/Progress.h" // for shape::Progress

#include <functional> // for what may fail
#include <string>     // for names

class vtkDataObject;
class vtkInformation;

class VTKSHAPEFILTERS_EXPORT vtkShapeSource : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkShapeSource, vtkAlgorithm);

  /// Returns the name of the source in messages: "Shape OFF Reader" for vtkShapeOFFReader.
  std::string GetLabel();

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) final;

protected:
  vtkShapeSource();
  ~vtkShapeSource() override = default;
  int FillOutputPortInformation(int port, vtkInformation* info) final;

  /// Returns the class name of the outputs, which may depend on properties.
  virtual std::string GetOutputType() = 0;
  /// Sets what is known of the first output before it is made: the extent, origin, spacing and
  /// directions of an image. Throws shape::InvalidInput. By default, nothing.
  virtual void Announce(vtkInformation*) {}
  /// Fills the first output, which is empty, and those of GetFurtherOutput. Throws
  /// shape::InvalidInput, shape::Aborted.
  virtual void Make(vtkDataObject* output, const shape::Progress& progress) = 0;
  /// Returns an output that Make fills. port: from 1.
  vtkDataObject* GetFurtherOutput(int port);

private:
  vtkShapeSource(const vtkShapeSource&) = delete;
  void operator=(const vtkShapeSource&) = delete;

  void CreateOutput(vtkInformationVector* outputs);
  int Run(vtkInformationVector* outputs);
  /// Calls a function, and reports its error. Returns whether there was none.
  bool Try(const std::function<void()>& function);

  vtkInformationVector* Outputs = nullptr; ///< of the request that Make serves
};

#endif
