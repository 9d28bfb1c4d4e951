/**
 * @class   vtkShapeAlgorithm
 * @brief   base of every ShapeMap filter
 *
 * A filter declares its ports in its constructor and overrides Execute. This class handles port
 * information, output types, progress, abort, errors and distributed inputs.
 *
 * - A Pieces port gives Execute the data of this process. A Whole port gives Execute the complete
 *   data: the blocks and pieces of all processes are first gathered into one vtkPolyData or
 *   vtkUnstructuredGrid. A surface may also be an unstructured grid of surface cells. Execute
 * itself need not communicate. Every port accepts composite data. Otherwise, the pipeline would run
 * the filter once for each block, so processes with different numbers of blocks would wait for each
 * other.
 * - A WholeSurface port gives Execute a repaired surface: see vtkShapeRepaired. The outputs keep
 *   the points and cells of the input. A warning and the facts `SplitPoints` and
 *   `RemovedTriangles` say what was done.
 * - Execute throws shape::InvalidInput or shape::SolveFailure. Each exception becomes one error
 *   event whose text starts with the label of the filter. The outputs are then empty, and the
 *   request fails. If one process fails, all processes fail.
 * - An output that is declared like an input (DeclareOutputLikeInput, DeclareMovedOutput) has the
 *   type of that input.
 * - The facts of a run, such as counts and errors, are the columns of a table of one row, which is
 *   the output Facts. In parallel, the first process has the row.
 * - If the points of an output differ from the points of the inputs, the measures of the inputs'
 *   geometry are removed from it: see vtkShapeMeasures.
 */
#ifndef vtkShapeAlgorithm_h
#define vtkShapeAlgorithm_h

#include "vtkAlgorithm.h"
#include "vtkShapeFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"       // for the gathered inputs

#include "Base/Progress.h" // for shape::Progress

#include <Eigen/Core> // for positions

#include <map>     // for ports
#include <memory>  // for repairs
#include <set>     // for ports
#include <string>  // for names
#include <utility> // for connections
#include <vector>  // for ports

class vtkMultiProcessController;
class vtkPolyData;
class vtkShapeRepair;
class vtkUnstructuredGrid;

/// Set/Get this->`field`, which is a number, a Boolean or a small vector.
#define vtkShapeOptionAs(field, name, type)                                                        \
  virtual void Set##name(type value)                                                               \
  {                                                                                                \
    if (this->field != value)                                                                      \
    {                                                                                              \
      this->field = value;                                                                         \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual type Get##name()                                                                         \
  {                                                                                                \
    return this->field;                                                                            \
  }

/// vtkShapeOptionAs for a field of this->`options` with the name of the property.
#define vtkShapeOptionOf(options, name, type) vtkShapeOptionAs(options.name, name, type)

/// vtkShapeOptionOf for a field of this->Options.
#define vtkShapeOption(name, type) vtkShapeOptionOf(Options, name, type)

/// Set/Get a field of this->`options` that is a std::array of three numbers.
#define vtkShapeVectorOptionOf(options, name)                                                      \
  virtual void Set##name(double x, double y, double z)                                             \
  {                                                                                                \
    const decltype(this->options.name) value = { x, y, z };                                        \
    if (this->options.name != value)                                                               \
    {                                                                                              \
      this->options.name = value;                                                                  \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual void Set##name(const double value[3])                                                    \
  {                                                                                                \
    this->Set##name(value[0], value[1], value[2]);                                                 \
  }                                                                                                \
  virtual double* Get##name() VTK_SIZEHINT(3)                                                      \
  {                                                                                                \
    return this->options.name.data();                                                              \
  }

/// Set/Get this->`field`, which is an enumeration. Its values are integers from `first` to `last`;
/// other integers are errors.
#define vtkShapeEnumOptionAs(field, name, type, first, last)                                       \
  virtual void Set##name(int value)                                                                \
  {                                                                                                \
    if (value < static_cast<int>(first) || value > static_cast<int>(last))                         \
    {                                                                                              \
      vtkErrorMacro(<< this->GetLabel() << ": " #name " " << value                                 \
                    << " does not exist; use a value from " << static_cast<int>(first) << " to "   \
                    << static_cast<int>(last));                                                    \
    }                                                                                              \
    else if (this->field != static_cast<type>(value))                                              \
    {                                                                                              \
      this->field = static_cast<type>(value);                                                      \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual int Get##name()                                                                          \
  {                                                                                                \
    return static_cast<int>(this->field);                                                          \
  }

/// vtkShapeEnumOptionAs for a field of this->`options` with the name of the property.
#define vtkShapeEnumOptionOf(options, name, type, first, last)                                     \
  vtkShapeEnumOptionAs(options.name, name, type, first, last)

/// vtkShapeEnumOptionOf for a field of this->Options.
#define vtkShapeEnumOption(name, type, first, last)                                                \
  vtkShapeEnumOptionOf(Options, name, type, first, last)

class VTKSHAPEFILTERS_EXPORT vtkShapeAlgorithm : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkShapeAlgorithm, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Returns the name of the filter in ParaView, such as "Shape Harmonic Volume Map".
  std::string GetLabel();

  /// Returns the name of an input port in errors and in ParaView, such as "Domain".
  std::string GetInputName(int port);

  /// Whether the filter needs this input. All inputs are optional for VTK: the filter itself says
  /// in one line that one is missing.
  bool IsInputRequired(int port);

  ///@{
  /// The controller of the processes that hold pieces of the same data; initially the global
  /// controller. With nullptr, or with one process, nothing is communicated. Otherwise, every
  /// process must update the filter.
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) final;

protected:
  vtkShapeAlgorithm();
  ~vtkShapeAlgorithm() override;

  enum class PortData
  {
    Pieces,        ///< the part of this process, which may be composite
    Whole,         ///< one vtkPolyData with the data of every block and process
    WholePolygons, ///< like Whole, with coincident points of several pieces merged
    WholeSurface,  ///< like WholePolygons, and repaired (RepairInput)
    WholeGrid,     ///< one vtkUnstructuredGrid, which may contain solid cells
    Selection,     ///< a vtkSelection, or the cells that it extracted; may be empty
    Table          ///< a vtkTable, which only some processes may have; may be empty
  };
  enum class PortUse
  {
    Required,
    Optional,
    OptionalRepeatable
  };

  /// Appends an input port; `types` are the class names accepted, alone or as blocks.
  void DeclareInput(
    const std::string& name, PortData data, PortUse use, const std::vector<std::string>& types);
  /// Appends an output port; `type` is the class name of its data.
  void DeclareOutput(const std::string& type);
  ///@{
  /// Appends an output port with the type of an input, by default the first. With
  /// DeclareOutputLikeInput, the points of the input stay unchanged. With DeclareMovedOutput, the
  /// points of the input move, so that image data and rectilinear grids become structured grids.
  void DeclareOutputLikeInput(int input = 0);
  void DeclareMovedOutput(int input = 0);
  ///@}

  /// Appends the output port Facts. If Execute has called vtkShapeConvert::AddFact with names
  /// that begin with the filter's, such as `HexRemesh.`, these facts are moved there. kept: for an
  /// output port, the names without this prefix of facts that also stay in its field data, because
  /// other filters read them.
  void DeclareFacts(const std::map<int, std::set<std::string>>& kept = {});

  /// Declares the array that the window shows on an output at first: the first of `names` that the
  /// output has becomes its active scalars.
  void DeclareShown(int port, const std::vector<std::string>& names);

  /// Declares the remedy, such as "lower Collocation Ratio", that is said in addition to a coarser
  /// input if the memory is not sufficient.
  void DeclareMemoryRemedy(const std::string& remedy);

  /// Tells the user in one line about a doubtful input or result. `text` names the fact and the
  /// remedy. The fact `Warning` has all warnings of a run. In parallel, the first process shows
  /// those of all processes, each text once.
  void Warn(const std::string& text);

  /// Declares the names of the measures that Execute computes for the outputs. If the points of an
  /// output differ from the points of the inputs, all other measures on it still describe the
  /// inputs. They are removed or computed again after Execute.
  void DeclareMeasures(const std::set<std::string>& names);

  /// Adds a number of points to the field data of an output: of the positions of all processes,
  /// which count once if several processes have them. During Execute, every process calls this
  /// function for the same names in the same order.
  void AddCount(int port, const std::string& name, std::vector<Eigen::RowVector3d> positions);

  /// Computes the outputs. It is called only if all required inputs are connected and have points.
  /// Throws shape::InvalidInput, shape::SolveFailure, shape::Aborted.
  virtual void Execute(const shape::Progress& progress) = 0;

  ///@{
  /// For filters that depend on time. DescribeOutputs sets the times of the outputs (TIME_RANGE)
  /// before any data are computed. RequestInputs sets the times requested from the inputs
  /// (UPDATE_TIME_STEP). Both are called after the pipeline has set its defaults, which pass all
  /// times on.
  virtual void DescribeOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  virtual void RequestInputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  ///@}

  /// The complete data of an input. For a WholeGrid port, this is Grid. For other ports, it is
  /// Data, and OwnPoints is the index in Data of each point of this process.
  struct GatheredInput
  {
    vtkSmartPointer<vtkPolyData> Data;
    std::vector<int> OwnPoints;
    vtkSmartPointer<vtkUnstructuredGrid> Grid;

    ///@{
    /// If Data was repaired, Given is the surface as gathered. Otherwise it is Data, and the lists
    /// are empty.
    vtkSmartPointer<vtkPolyData> Given;
    std::vector<int> GivenPoints;    ///< for each point of Data, the point of Given
    std::vector<int> GivenTriangles; ///< for each triangle of Data, the triangle of Given
    std::vector<int> GivenCells;     ///< for each cell of Data, the cell of Given
    ///@}
  };
  /// Returns the complete data of one connection, from 0 to GetNumberOfInputConnections(port) - 1.
  /// The result is valid during Execute.
  const GatheredInput& GetGatheredInput(int port, int connection = 0) const;

  /// Replaces Data of an input by a repaired surface (shape::RepairSheets), and says so. It is
  /// called for WholeSurface ports. separate: see shape::SheetRepairOptions; the interfaces of a
  /// surface with the cell array Regions are never separated.
  void RepairInput(int port, int connection = 0, bool separate = true);

  int FillInputPortInformation(int port, vtkInformation* info) final;
  int FillOutputPortInformation(int port, vtkInformation* info) final;

private:
  vtkShapeAlgorithm(const vtkShapeAlgorithm&) = delete;
  void operator=(const vtkShapeAlgorithm&) = delete;

  struct InputPort;
  struct Count;
  void GatherInput(int port, int connection);
  int CreateOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  int Run(vtkInformationVector* outputs);
  void WriteCounts(vtkInformationVector* outputs);
  void RenewMeasures(vtkInformationVector* outputs);
  void WriteWarnings(vtkInformationVector* outputs);
  void MoveFacts(vtkInformationVector* outputs);
  void ActivateShown(vtkInformationVector* outputs);
  std::vector<vtkDataObject*> GetInputs(); ///< as connected and, during Execute, as gathered
  std::string GetFactPrefix();             ///< "HexRemesh."
  void PrepareInputs();
  shape::Progress MakeProgress();

  std::vector<InputPort> InputPorts;
  std::vector<std::string> OutputTypes; ///< class names; empty: the type of an input
  std::map<int, int> LikeInput;         ///< from output to input, if the input is not the first
  std::set<int> MovedOutputs;
  std::set<std::string> MadeMeasures;
  int FactsPort = -1; ///< -1: there is none
  std::map<int, std::set<std::string>> KeptFacts;
  std::map<int, std::vector<std::string>> Shown;
  std::vector<std::string> Warnings;
  std::string MemoryRemedy;
  std::vector<std::vector<GatheredInput>> GatheredInputs;
  std::vector<Count> Counts;
  /// By port and connection.
  std::map<std::pair<int, int>, std::unique_ptr<vtkShapeRepair>> Repairs;
  int SplitPoints = 0, RemovedTriangles = 0; ///< of all inputs, when repaired
  vtkMultiProcessController* Controller = nullptr;
};

#endif
