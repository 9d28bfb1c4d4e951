/**
 * @class   vtkShapePaintArray
 * @brief   paint a point array onto a surface by strokes of a brush
 *
 * Input: a surface, open or closed, which may be non-manifold, composite or distributed. Polygons
 * are triangulated internally. Blocks and pieces are joined first, so that strokes cross their
 * seams, and each process gets its own pieces back.
 *
 * Output: the same surface with the point array ArrayName (double). If Input has such a point array
 * of one component, the strokes change its values. Otherwise, they change InitialValue.
 *
 * Strokes has five numbers for each stroke: Mode (0: Set, 1: Add, 2: Smooth), Radius, Strength,
 * Value, and the number of its positions. StrokePoints are the positions of all strokes, in order.
 *
 * If only new strokes or positions are appended, only their effect is computed.
 *
 * The mathematics: shape::SurfacePainter.
 */
#ifndef vtkShapePaintArray_h
#define vtkShapePaintArray_h

#include "vtkShapeAlgorithm.h"

#include "Transfer/PaintArray.h" // for the strokes

#include <memory> // for what is kept
#include <string> // for the name
#include <vector> // for strokes

class VTKSHAPEFILTERS_EXPORT vtkShapePaintArray : public vtkShapeAlgorithm
{
public:
  static vtkShapePaintArray* New();
  vtkTypeMacro(vtkShapePaintArray, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapePaintArray.xml. Modes: shape::BrushStroke.
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  vtkSetMacro(InitialValue, double);
  vtkGetMacro(InitialValue, double);
  void SetNumberOfStrokes(int count);
  void SetStrokes(
    int index, double mode, double radius, double strength, double value, double points);
  std::vector<double> GetStrokes() { return this->Strokes; }
  void SetNumberOfStrokePoints(int count);
  void SetStrokePoints(int index, double x, double y, double z);
  std::vector<double> GetStrokePoints() { return this->StrokePoints; }
  ///@}

protected:
  vtkShapePaintArray();
  ~vtkShapePaintArray() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapePaintArray(const vtkShapePaintArray&) = delete;
  void operator=(const vtkShapePaintArray&) = delete;

  std::vector<shape::BrushStroke> MakeStrokes() const;
  /// Returns the values before the first stroke, at the points of the gathered Input.
  Eigen::VectorXd MakeInitialValues() const;

  std::string ArrayName = "Painted";
  double InitialValue = 0.0;
  std::vector<double> Strokes; ///< five numbers for each stroke
  std::vector<double> StrokePoints;
  struct Kept;
  std::unique_ptr<Kept> Cache;
};

#endif
