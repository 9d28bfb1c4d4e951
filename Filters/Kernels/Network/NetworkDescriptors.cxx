#include "Network/NetworkDescriptors.h"

#include "Base/ChildMessages.h"
#include "Base/Errors.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/SoundTriangles.h"
#include "Network/Private/OpenNetwork.h"
#include "Spectrum/LaplaceEigenproblem.h"
#include "Spectrum/SpectralSignatures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace shape
{
namespace
{

using Options = NetworkDescriptorOptions;

/// "n x 3", for messages.
std::string Describe(const std::vector<int>& sizes)
{
  std::string text;
  for (const int size : sizes)
  {
    text += (text.empty() ? "" : " x ") + (size > 0 ? std::to_string(size) : std::string("any"));
  }
  return text.empty() ? "a single number" : text;
}

/// The surface at the scale that the network expects.
Surface Scaled(const Surface& surface, Options::ScaleType scale)
{
  if (scale == Options::ScaleType::Given)
  {
    return surface;
  }
  const Eigen::VectorXd areas = ComputePointAreas(surface);
  const double area = areas.sum();
  if (!(area > 0.0))
  {
    throw InvalidInput("the surface has no area; choose another one, or set Scale to Given");
  }
  const Eigen::RowVector3d centroid = areas.transpose() * surface.Points() / area;
  Eigen::MatrixXd points = surface.Points().rowwise() - centroid;
  double length = std::sqrt(area);
  if (scale == Options::ScaleType::UnitRadius)
  {
    length = (areas.array() > 0.0).select(points.rowwise().norm(), 0.0).maxCoeff();
  }
  points /= length;
  return surface.WithPoints(std::move(points));
}

/// Computes what a network's inputs hold.
class InputMaker
{
public:
  InputMaker(const Surface& surface, const Eigen::MatrixXd& arrays, const Options& options)
    : Scaled(shape::Scaled(surface, options.Scale))
    , Arrays(arrays)
    , Eigenpairs(options.NumberOfEigenpairs)
  {
  }

  std::vector<Tensor> Make(const std::vector<TensorShape>& inputs, const Progress& progress)
  {
    this->SolveIfNeeded(inputs, progress);
    std::vector<Tensor> made;
    for (const TensorShape& input : inputs)
    {
      made.push_back(this->Make(input));
    }
    progress(1.0);
    return made;
  }

private:
  /// The columns that an input declares: its last size, unless that is the one of the points.
  static int ColumnsOf(const TensorShape& input)
  {
    return input.Sizes.size() < 2 ? 0 : input.Sizes.back();
  }

  void SolveIfNeeded(const std::vector<TensorShape>& inputs, const Progress& progress)
  {
    bool isNeeded = false;
    for (const TensorShape& input : inputs)
    {
      const bool areValues = input.Name == "Eigenvalues";
      if (areValues || input.Name == "Eigenfunctions")
      {
        const int declared = areValues && !input.Sizes.empty()
          ? *std::max_element(input.Sizes.begin(), input.Sizes.end())
          : ColumnsOf(input);
        this->Eigenpairs = declared > 1 ? declared : this->Eigenpairs;
      }
      isNeeded = this->SourceOf(input).NeedsSpectrum || isNeeded;
    }
    if (isNeeded)
    {
      this->Spectrum = SolveLaplaceEigenproblem(this->Scaled, this->Eigenpairs, progress);
    }
  }

  /// Where the values of an input of this name come from: a row for each point, or for each
  /// eigenvalue.
  struct Source
  {
    const char* Name;
    bool NeedsSpectrum;
    Eigen::MatrixXd (*Compute)(const InputMaker& from, int columns);
  };

  /// Throws InvalidInput if the input's values are not known, before anything is computed.
  const Source& SourceOf(const TensorShape& input) const
  {
    static const std::array<Source, 8> sources{ {
      { "Positions", false, [](const InputMaker& from, int) { return from.Scaled.Points(); } },
      { "Normals", false,
        [](const InputMaker& from, int) -> Eigen::MatrixXd
        { return GetVertexNormals(from.Scaled); } },
      { "Masses", false,
        [](const InputMaker& from, int) -> Eigen::MatrixXd
        { return ComputePointAreas(from.Scaled); } },
      { "Arrays", false, [](const InputMaker& from, int) { return from.Arrays; } },
      { "Eigenvalues", true,
        [](const InputMaker& from, int) -> Eigen::MatrixXd { return from.Spectrum->Eigenvalues; } },
      { "Eigenfunctions", true,
        [](const InputMaker& from, int) { return from.Spectrum->Eigenfunctions; } },
      { "HeatKernelSignature", true,
        [](const InputMaker& from, int columns)
        { return ComputeHeatKernelSignature(*from.Spectrum, columns); } },
      { "WaveKernelSignature", true,
        [](const InputMaker& from, int columns)
        { return ComputeWaveKernelSignature(*from.Spectrum, columns); } },
    } };
    const auto source = std::find_if(sources.begin(), sources.end(),
      [&](const Source& other) { return input.Name == other.Name; });
    if (source == sources.end())
    {
      throw InvalidInput("the network has an input '" + input.Name +
        "', which is none of Positions, Normals, Masses, Eigenvalues, Eigenfunctions, "
        "HeatKernelSignature, WaveKernelSignature and Arrays; rename it when you export the "
        "network");
    }
    if (input.Name == "Arrays" && this->Arrays.cols() == 0)
    {
      throw InvalidInput("the network has the input 'Arrays', but no array is chosen; choose the "
                         "arrays in Input Arrays");
    }
    if (!input.IsFloat)
    {
      throw InvalidInput("the network's input '" + input.Name +
        "' is not in single precision; export the network in single precision");
    }
    return *source;
  }

  Tensor Make(const TensorShape& input) const
  {
    constexpr int usual = 100; // columns of a signature, as in ComputeLaplaceSpectrum
    const Eigen::MatrixXd values =
      this->SourceOf(input).Compute(*this, ColumnsOf(input) > 1 ? ColumnsOf(input) : usual);
    Tensor tensor{ input.Name, FitSizes(input, values.rows(), values.cols()), {} };
    tensor.Values.resize(static_cast<std::size_t>(values.size()));
    Eigen::Map<Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      tensor.Values.data(), values.rows(), values.cols()) = values.cast<float>();
    return tensor;
  }

  /// Returns the sizes that an input declares, with those of the values where it leaves them open.
  /// A matrix fills the last two dimensions, a vector the first one that can hold it, and the
  /// others have size 1. Throws InvalidInput if that is not what is declared.
  static std::vector<int> FitSizes(
    const TensorShape& input, Eigen::Index rows, Eigen::Index columns)
  {
    std::vector<int> wanted{ static_cast<int>(rows) };
    if (columns > 1)
    {
      wanted.push_back(static_cast<int>(columns));
    }
    std::vector<int> sizes = input.Sizes;
    const std::size_t rank = sizes.size();
    std::size_t first = 0;
    if (columns > 1)
    {
      first = rank - std::min(rank, wanted.size());
    }
    else
    {
      const auto holds = [&](int size) { return size == 0 || size == wanted.front(); };
      first =
        static_cast<std::size_t>(std::find_if(sizes.begin(), sizes.end(), holds) - sizes.begin());
    }
    bool fits = first + wanted.size() <= rank;
    for (std::size_t i = 0; i < rank && fits; ++i)
    {
      const bool isFilled = i >= first && i < first + wanted.size();
      const int size = isFilled ? wanted[i - first] : 1;
      fits = sizes[i] == 0 || sizes[i] == size;
      sizes[i] = size;
    }
    if (!fits)
    {
      throw InvalidInput("the network's input '" + input.Name + "' is " + Describe(input.Sizes) +
        ", but its values are " + Describe(wanted) +
        "; export the network for any number of points, and give as many columns as it expects");
    }
    return sizes;
  }

  Surface Scaled;
  const Eigen::MatrixXd& Arrays;
  int Eigenpairs;
  std::optional<LaplaceEigenpairs> Spectrum;
};

/// Evaluates a network in a child process: OpenCV cannot be interrupted, and may crash.
Tensor EvaluateInChild(const NetworkLibrary& library, const std::string& network,
  const std::vector<Tensor>& inputs, const Progress& progress)
{
  ChildTask<Tensor> task;
  task.Compute = [&] { return library.Evaluate(network, inputs); };
  task.UsualSeconds = 0.1 + 1e-7 * static_cast<double>(network.size());
  task.Library = "OpenCV";
  task.Work = "evaluates the network";
  task.MemoryRemedy = "use a surface with fewer points, or a smaller network";
  task.CrashRemedy = "export the network again";
  return ComputeInChild(
    task,
    [](const auto& mover, Tensor& result)
    {
      mover.Move(result.Sizes);
      mover.Move(result.Values);
    },
    progress);
}

/// The output as a matrix with a row for each of `rows` points.
Eigen::MatrixXd ToRows(const Tensor& output, Eigen::Index rows)
{
  std::vector<int> sizes = output.Sizes;
  while (sizes.size() > 1 && sizes.front() == 1 && rows != 1)
  {
    sizes.erase(sizes.begin());
  }
  const auto count = static_cast<Eigen::Index>(output.Values.size());
  if (sizes.empty() || sizes.front() != rows || count == 0)
  {
    throw InvalidInput("the network's output is " + Describe(output.Sizes) +
      ", not a row for each of " + std::to_string(rows) +
      " points; export a network whose output has a row for each point");
  }
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(output.Values.data(), rows, count / rows).cast<double>();
}

} // namespace

Eigen::MatrixXd ComputeNetworkDescriptors(const Surface& surface, const std::string& network,
  const Eigen::MatrixXd& arrays, const NetworkDescriptorOptions& options, const Progress& progress)
{
  RequireOption(options.NumberOfEigenpairs >= 2, "NumberOfEigenpairs", options.NumberOfEigenpairs,
    "at least 2");
  RequireTriangles(surface, "the surface");
  const NetworkLibrary library = LoadNetworkLibrary();
  const NetworkInterface found = library.Read(network);
  if (found.Outputs.size() != 1)
  {
    throw InvalidInput("the network has " + std::to_string(found.Outputs.size()) +
      " outputs; export it with one, which has a row for each point");
  }
  const std::vector<Tensor> inputs =
    InputMaker(surface, arrays, options)
      .Make(found.Inputs, progress.Part(0.0, 0.7, "computing the network's inputs"));
  const Tensor output =
    EvaluateInChild(library, network, inputs, progress.Part(0.7, 1.0, "evaluating the network"));
  Eigen::MatrixXd descriptors = ToRows(output, surface.Points().rows());
  Eigen::VectorXi isUsed = Eigen::VectorXi::Zero(descriptors.rows());
  isUsed(surface.Triangles().reshaped()).setOnes();
  for (Eigen::Index point = 0; point < descriptors.rows(); ++point)
  {
    if (isUsed(point) == 0)
    {
      descriptors.row(point).setZero();
    }
  }
  if (!descriptors.allFinite())
  {
    throw SolveFailure("the network's output is not finite; the shape may be unlike those on which "
                       "it was trained: try another Scale");
  }
  progress(1.0);
  return descriptors;
}

} // namespace shape
