/**
 * @class   vtkShapeAlgorithm
 * @brief   base of every ShapeMap filter
 *
 * A filter declares its ports in its constructor and overrides Execute. This class does the rest:
 * port information, output types, progress, abort, errors, distributed inputs.
 *
 * - A Pieces port gives Execute the data of this process. A Whole port gives it the complete data:
 *   blocks and the pieces of all processes are gathered into one vtkPolyData or
 *   vtkUnstructuredGrid before. Execute itself communicates nothing. Every port accepts composite
 *   data. Otherwise the pipeline would run the filter once for each block, and processes have
 *   different numbers of blocks.
 * - Execute throws shape::InvalidInput or shape::SolveFailure. Each becomes one error event whose
 *   text starts with the label of the filter. All outputs are empty, and the request fails. If one
 *   process fails, all of them do.
 * - An output like an input has its type.
 * - An output with points of its own keeps no measure of the geometry of its inputs: see
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

/// Set/Get a field of this->`options` that is a number, a truth value or a small vector of them.
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

  /// What an input port is called, in errors and in ParaView: "Domain".
  std::string GetInputName(int port);

  ///@{
  /// The processes whose pieces belong together; the global controller at first. With nullptr, or
  /// with one process, nothing is communicated; else every process must update the filter.
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
    Pieces,       ///< this process's part, also composite
    Whole,        ///< one vtkPolyData with the data of every block and process
    WholeSurface, ///< the same, with coincident points of several pieces merged
    WholeGrid,    ///< one vtkUnstructuredGrid, of solid cells, too
    Selection     ///< a vtkSelection, or cells extracted by one, which may be none
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
  /// Appends an output port like an input, the first if none is named, whose points are kept, or
  /// moved: then image data and rectilinear grids become structured grids.
  void DeclareOutputLikeInput(int input = 0);
  void DeclareMovedOutput();
  ///@}

  /// Says which measures Execute computes of the outputs. Other measures on an output with points
  /// of its own are the inputs', and are removed or computed again after Execute.
  void DeclareMeasures(const std::set<std::string>& names);

  /// During Execute: field data of an output, the sum of the processes' numbers. Every process
  /// calls it for the same facts in the same order.
  void AddCount(int port, const std::string& name, double own);

  /// Computes the outputs from inputs that are there and have points. Throws shape::InvalidInput,
  /// shape::SolveFailure, shape::Aborted.
  virtual void Execute(const shape::Progress& progress) = 0;

  ///@{
  /// For filters that know time: what the outputs offer (TIME_RANGE), called before anything is
  /// made; and what the inputs are asked for (UPDATE_TIME_STEP). The pipeline's own answer, which
  /// hands everything through, is there already.
  virtual void DescribeOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  virtual void RequestInputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  ///@}

  /// A Whole input, and for each point that this process has, its index in the whole; or a
  /// WholeGrid one.
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
  /// The outputs have every time that an input has: the pipeline hands on those of the first port
  /// alone, and would not run a filter again for the times of another.
  void OfferTimes(vtkInformationVector** inputs, vtkInformationVector* outputs);
  int CreateOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs);
  /// Asks a grid on another port than the first for this process's part of its own extent: the
  /// pipeline would ask it for the extent of the output, which is the first input's.
  void RequestOwnExtents(vtkInformationVector** inputs);
  int Run(vtkInformationVector* outputs);
  void WriteCounts(vtkInformationVector* outputs);
  void RenewMeasures(vtkInformationVector* outputs);
  void PrepareInputs();
  shape::Progress MakeProgress();

  std::vector<InputPort> InputPorts;
  std::vector<std::string> OutputTypes; ///< empty: like an input
  std::map<int, int> LikeInput;         ///< which input, for outputs that are not like the first
  std::set<int> MovedOutputs;
  std::set<std::string> MadeMeasures;
  std::vector<std::vector<GatheredInput>> GatheredInputs;
  std::vector<Count> Counts;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
