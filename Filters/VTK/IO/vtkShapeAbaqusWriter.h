/**
 * @class   vtkShapeAbaqusWriter
 * @brief   write a mesh as an input file of Abaqus or CalculiX
 *
 * CalculiX reads these files, too. The file has nodes (numbered by point index + 1), elements
 * (numbered by cell index + 1) and an element set for each region. The node set Boundary contains
 * the points on the boundary of the solid cells. Each patch between creases is a node set Patch0,
 * ... and a surface PatchSurface0, ... The node sets Interface0_1, ... contain the points between
 * two regions. If the cells have materials of Shape Image Values, the file has their sections.
 * Otherwise, include it in an input file that has materials and sections:
 *
 *   *INCLUDE, INPUT=mesh.inp
 *   *SOLID SECTION, ELSET=Region0, MATERIAL=Bone
 *
 * Names of sets, types of elements and precision: shape::WriteAbaqus. Input, regions and patches:
 * vtkShapeWriter.
 */
#ifndef vtkShapeAbaqusWriter_h
#define vtkShapeAbaqusWriter_h

#include "vtkShapeWriter.h"

#include "IO/AbaqusWriter.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeAbaqusWriter : public vtkShapeWriter
{
public:
  static vtkShapeAbaqusWriter* New();
  vtkTypeMacro(vtkShapeAbaqusWriter, vtkShapeWriter);

  ///@{
  /// The properties. Effects and ranges: vtkShapeAbaqusWriter.xml. Enumerations and defaults:
  /// shape::AbaqusWriterOptions.
  vtkShapeEnumOption(HexahedronType, shape::HexahedronType, shape::HexahedronType::C3D8,
    shape::HexahedronType::C3D8I);
  ///@}

protected:
  vtkShapeAbaqusWriter() = default;
  ~vtkShapeAbaqusWriter() override = default;
  void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) override;

private:
  vtkShapeAbaqusWriter(const vtkShapeAbaqusWriter&) = delete;
  void operator=(const vtkShapeAbaqusWriter&) = delete;

  shape::AbaqusWriterOptions Options;
};

#endif
