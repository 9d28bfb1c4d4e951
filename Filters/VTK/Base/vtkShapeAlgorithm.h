/**
 * @class   vtkShapeAlgorithm
 * @brief   base of every ShapeMap filter
 *
 * A filter declares its ports in its constructor and overrides Execute. This class handles port
 * information, output types, progress, abort, errors and distributed inputs.
 *
 * - A Pieces port gives Execute the data of this process. A Whole port gives it the complete data:
 *   blocks and the pieces of all processes are gathered into one vtkPolyData or
 *   vtkUnstructuredGrid before. Execute itself communicates nothing. Every port accepts composite
 *   data. Otherwise the pipeline would run the filter once for each block, and processes have
 *   different numbers of blocks.
 * - Execute throws shape::InvalidInput or shape::SolveFailure. Each becomes one error event whose
 *   text starts with the label of the filter. All outputs are empty, and the request fails. If one
 *   process fails, all of them do.
 * - An output that is declared like an input has the type of that input.
 * - An output whose points differ from its inputs' keeps no measure of their geometry: see
 *   vtkShapeMeasures.
 */
#ifndef vtkShapeAlgorithm_h
#define vtkShapeAlgorithm_h

#include "vtkAlgorithm.h"
#include "vtkShapeFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"       // for the gathered inputs

#include "Base/Progress.h" // for shape::Progress

#include <map>    // for ports
#include <set>    // for ports
#include <string> // for names
#include <vector> // for ports

class vtkMultiProcessController;
class vtkPolyData;
class vtkUnstructuredGrid;

/// Set/Get a field of this->`options` that is a number, a Boolean or a small vector of them.
#define vtkShapeOptionOf(options, name, type)                                                      \
  virtual void Set##name(type value)                                                               \
  {                                                                                                \
    if (this->options.name != value)                                                               \
    {                                                                                              \
      this->options.name = value;                                                                  \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual type Get##name()                                                                         \
  {                                                                                                \
    return this->options.name;                                                                     \
  }

/// Set/Get such a field of this->Options.
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

/// Set/Get a field of this->`options` that is an enumeration, as the integers from first to last.
#define vtkShapeEnumOptionOf(options, name, type, first, last)                                     \
  virtual void Set##name(int value)                                                                \
  {                                                                                                \
    if (value < static_cast<int>(first) || value > static_cast<int>(last))                         \
    {                                                                                              \
      vtkErrorMacro(<< this->GetLabel() << ": " #name " " << value                                 \
                    << " does not exist; it ranges "                                               \
                    << "from " << static_cast<int>(first) << " to " << static_cast<int>(last));    \
    }                                                                                              \
    else if (this->options.name != static_cast<type>(value))                                       \
    {                                                                                              \
      this->options.name = static_cast<type>(value);                                               \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual int Get##name()                                                                          \
  {                                                                                                \
    return static_cast<int>(this->options.name);                                                   \
  }

/// Set/Get such a field of this->Options.
#define vtkShapeEnumOption(name, type, first, last)                                                \
  vtkShapeEnumOptionOf(Options, name, type, first, last)

class VTKSHAPEFILTERS_EXPORT vtkShapeAlgorithm : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkShapeAlgorithm, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The name that ParaView shows: "Shape Harmonic Volume Map" for vtkShapeHarmonicVolumeMap.
  std::string GetLabel();
  static std::string LabelOf(const std::string& className);

  /// The name of an input port in errors and in ParaView, such as "Domain".
  std::string GetInputName(int port);

  ///@{
  /// The processes that hold pieces of the same data; initially those of the global controller.
  /// With nullptr, or with one process, nothing is communicated. Otherwise every process must
  /// update the filter.
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
    Pieces,       ///< the part of this process, which may be composite
    Whole,        ///< one vtkPolyData with the data of every block and process
    WholeSurface, ///< the same, with coincident points of several pieces merged
    WholeGrid,    ///< one vtkUnstructuredGrid, which may contain solid cells
    Selection     ///< a vtkSelection, or the cells that it extracted; may be empty
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
  /// Appends an output port of a class.
  void DeclareOutput(const std::string& type);
  ///@{
  /// Appends an output port with the type of an input (by default the first).
  /// DeclareOutputLikeInput keeps the points. DeclareMovedOutput moves those of the first input,
  /// which turns image data and rectilinear grids into structured grids.
  void DeclareOutputLikeInput(int input = 0);
  void DeclareMovedOutput();
  ///@}

  /// Declares which measures of the outputs Execute computes. If the points of an output differ
  /// from the inputs', other measures on it describe the inputs. They are removed or computed again
  /// after Execute.
  void DeclareMeasures(const std::set<std::string>& names);

  /// Adds the sum of the processes' numbers to the field data of an output. Called during Execute,
  /// by every process for the same names in the same order.
  void AddCount(int port, const std::string& name, double own);

  /// Computes the outputs. All required inputs are present and have points. Throws
  /// shape::InvalidInput, shape::SolveFailure, shape::Aborted.
  virtual void Execute(const shape::Progress& progress) = 0;

  ///@{
  /// For filters that depend on time. DescribeOutputs sets the times of the outputs (TIME_RANGE)
  /// before any data are computed. RequestInputs sets the times requested from the inputs
  /// (UPDATE_TIME_STEP). The defaults of the pipeline, which passes everything on, are already set.
  virtual void DescribeOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  virtual void RequestInputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  ///@}

  /// The complete data of an input: Data and, for each point of this process, its index in Data
  /// (OwnPoints); or Grid for a WholeGrid port.
  struct GatheredInput
  {
    vtkSmartPointer<vtkPolyData> Data;
    std::vector<int> OwnPoints;
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
  };
  /// Valid during Execute. `connection` counts up to GetNumberOfInputConnections(port) - 1.
  const GatheredInput& GetGatheredInput(int port, int connection = 0) const;

  int FillInputPortInformation(int port, vtkInformation* info) final;
  int FillOutputPortInformation(int port, vtkInformation* info) final;

private:
  vtkShapeAlgorithm(const vtkShapeAlgorithm&) = delete;
  void operator=(const vtkShapeAlgorithm&) = delete;

  struct InputPort;
  struct Count;
  /// Gives the outputs the times of all inputs. The pipeline passes on those of the first port
  /// only, and would not run a filter again for the times of another port.
  void OfferTimes(vtkInformationVector** inputs, vtkInformationVector* outputs);
  int CreateOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  /// Requests this process's part of the extent of each grid that is not on the first port. By
  /// default the pipeline would request the extent of the output, which is that of the first input.
  void RequestOwnExtents(vtkInformationVector** inputs);
  int Run(vtkInformationVector* outputs);
  void WriteCounts(vtkInformationVector* outputs);
  void RenewMeasures(vtkInformationVector* outputs);
  void PrepareInputs();
  shape::Progress MakeProgress();

  std::vector<InputPort> InputPorts;
  std::vector<std::string> OutputTypes; ///< empty: like an input
  std::map<int, int> LikeInput;         ///< input of each output that is not like the first input
  std::set<int> MovedOutputs;
  std::set<std::string> MadeMeasures;
  std::vector<std::vector<GatheredInput>> GatheredInputs;
  std::vector<Count> Counts;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
