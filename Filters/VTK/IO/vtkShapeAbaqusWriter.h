/**
 * @class   vtkShapeAbaqusWriter
 * @brief   writes a mesh as an input file of Abaqus (.inp), which CalculiX reads, too
 *
 * The file has nodes (point + 1), elements (cell + 1), an element set for each region, and of the
 * boundary of the solid cells the node set Boundary and for each patch between creases a node set
 * Patch0, ... and a surface PatchSurface0, ...; node sets Interface0_1, ... lie between regions. It
 * has no materials, sections or steps: a deck that has them includes it,
 *
 *   *INCLUDE, INPUT=mesh.inp
 *   *SOLID SECTION, ELSET=Region0, MATERIAL=Bone
 *
 * Names, types and digits: shape::WriteAbaqus. Input, regions and patches: vtkShapeWriter.
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
  /// The element of hexahedra: 0 C3D8, fully integrated, which is too stiff in bending; 1 C3D8R,
  /// with one integration point; 2 C3D8I, with incompatible modes. In CalculiX, C3D8R and C3D8I
  /// reproduce a linear displacement exactly only where cells are parallelepipeds. Default: C3D8I.
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
