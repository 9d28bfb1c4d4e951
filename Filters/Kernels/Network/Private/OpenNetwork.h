#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shape
{

/// An input or output that a network declares.
struct TensorShape
{
  std::string Name;
  std::vector<int> Sizes; ///< of each dimension; 0: any
  bool IsFloat = true;    ///< whether the numbers are in single precision
};

struct NetworkInterface
{
  std::vector<TensorShape> Inputs, Outputs;
};

struct Tensor
{
  std::string Name;
  std::vector<int> Sizes;
  std::vector<float> Values; ///< row-major
};

/// What libshape_network.so does, which links OpenCV.
struct NetworkLibrary
{
  /// Reads what a network declares. Throws InvalidInput if the content is no ONNX file.
  NetworkInterface (*Read)(std::string_view content);
  /// Evaluates a network on one thread of this process, which must expect a crash. Throws
  /// InvalidInput with the message of OpenCV.
  Tensor (*Evaluate)(std::string_view content, const std::vector<Tensor>& inputs);
};

/// Loads OpenCV, unless an earlier call did. Throws InvalidInput if ShapeMap was built without it,
/// and SolveFailure if its libraries are missing.
NetworkLibrary LoadNetworkLibrary();

} // namespace shape

/// The NetworkLibrary of libshape_network.so, which LoadNetworkLibrary looks up by this name.
extern "C" [[gnu::visibility("default")]] void ShapeMapNetworkLibrary(shape::NetworkLibrary& own);
