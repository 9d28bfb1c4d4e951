/**
 * @class   vtkShapeFileWriter
 * @brief   base of the writers of files
 *
 * The writer writes only the data of this process. In ParaView, the pieces of all processes are
 * first gathered on one process, and coincident points of different pieces are merged.
 *
 * An existing file of the same name is replaced only by a complete one: after an error or an abort,
 * it is unchanged, and no incomplete file is left. If there are several files, none is replaced
 * before all are complete.
 */
#ifndef vtkShapeFileWriter_h
#define vtkShapeFileWriter_h

#include "vtkShapeAlgorithm.h"     // for the macros
#include "vtkShapeFiltersModule.h" // for the export macro
#include "vtkWriter.h"

#include "Base/Progress.h" // for shape::Progress

#include <functional> // for the content
#include <iosfwd>     // for the file
#include <string>     // for names
#include <vector>     // for the files

class VTKSHAPEFILTERS_EXPORT vtkShapeFileWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkShapeFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Returns the name of the writer in messages: "Shape Abaqus Writer" for vtkShapeAbaqusWriter.
  std::string GetLabel();

  ///@{
  /// The file to write.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

protected:
  vtkShapeFileWriter();
  ~vtkShapeFileWriter() override;
  void WriteData() final;

  /// Writes the content of an open file.
  using Content = std::function<void(std::ostream& file, const shape::Progress& progress)>;
  /// Reads the input and returns what writes it. Throws shape::InvalidInput, shape::Aborted.
  virtual Content ReadInput(const shape::Progress& progress) = 0;
  /// Adds a file that belongs to FileName, and is written before it. ReadInput calls this. Folders
  /// below that of FileName are made if necessary.
  void AddFile(const std::string& path, Content content);

  std::string FileName;

private:
  vtkShapeFileWriter(const vtkShapeFileWriter&) = delete;
  void operator=(const vtkShapeFileWriter&) = delete;

  struct OutputFile;

  void WriteFiles(const shape::Progress& progress);
  void MakeFolder(const std::string& folder);
  void WriteTo(
    const OutputFile& file, const std::string& path, const shape::Progress& progress) const;
  void Replace(const OutputFile& file) const;

  std::vector<OutputFile> Files;        ///< to be written
  std::vector<std::string> MadeFolders; ///< for them, from outer to inner ones
};

#endif
