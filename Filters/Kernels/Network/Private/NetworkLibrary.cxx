#include "Base/Errors.h"
#include "Network/Private/OpenNetwork.h"

#include <google/protobuf/unknown_field_set.h>
#include <opencv2/dnn.hpp>

#include <climits>
#include <memory>
#include <set>

namespace shape
{
namespace
{

// The numbers of the fields that are read, as the ONNX format defines them (onnx.proto).
constexpr int ModelGraph = 7;
constexpr int GraphInitializer = 5, GraphInput = 11, GraphOutput = 12;
constexpr int TensorName = 8;
constexpr int ValueName = 1, ValueType = 2;
constexpr int TypeTensor = 1;
constexpr int TensorElementType = 1, TensorSizes = 2;
constexpr int SizesDimension = 1;
constexpr int DimensionValue = 1;
constexpr int FloatElement = 1;

/// A message of the format, whose fields have numbers.
class Message
{
public:
  explicit Message(const std::string& bytes)
  {
    if (!this->Fields->ParseFromString(bytes))
    {
      throw InvalidInput("the file is no ONNX network, or it is damaged; export the network again");
    }
  }

  /// Returns the fields with a number that are texts or messages.
  std::vector<std::string> Texts(int number) const
  {
    std::vector<std::string> texts;
    for (int i = 0; i < this->Fields->field_count(); ++i)
    {
      const google::protobuf::UnknownField& field = this->Fields->field(i);
      if (field.number() == number &&
        field.type() == google::protobuf::UnknownField::TYPE_LENGTH_DELIMITED)
      {
        texts.push_back(field.length_delimited());
      }
    }
    return texts;
  }

  /// Returns the last text with a number; empty if there is none.
  std::string Text(int number) const
  {
    const std::vector<std::string> texts = this->Texts(number);
    return texts.empty() ? std::string() : texts.back();
  }

  /// Returns the last message with a number; it has no fields if there is none.
  Message Child(int number) const { return Message(this->Text(number)); }

  /// Returns the last positive integer with a number. 0: there is none, or it is negative, as some
  /// programs write an open dimension.
  int Integer(int number) const
  {
    int value = 0;
    for (int i = 0; i < this->Fields->field_count(); ++i)
    {
      const google::protobuf::UnknownField& field = this->Fields->field(i);
      if (field.number() == number && field.type() == google::protobuf::UnknownField::TYPE_VARINT)
      {
        value = field.varint() <= INT_MAX ? static_cast<int>(field.varint()) : 0;
      }
    }
    return value;
  }

private:
  std::unique_ptr<google::protobuf::UnknownFieldSet> Fields =
    std::make_unique<google::protobuf::UnknownFieldSet>();
};

TensorShape ReadShape(const std::string& bytes)
{
  const Message value(bytes);
  const Message tensor = value.Child(ValueType).Child(TypeTensor);
  TensorShape shape{ value.Text(ValueName), {}, tensor.Integer(TensorElementType) == FloatElement };
  for (const std::string& dimension : tensor.Child(TensorSizes).Texts(SizesDimension))
  {
    shape.Sizes.push_back(Message(dimension).Integer(DimensionValue));
  }
  return shape;
}

NetworkInterface Read(std::string_view content)
{
  const Message graph = Message(std::string(content)).Child(ModelGraph);
  std::set<std::string> constants; // old files list these among the inputs
  for (const std::string& bytes : graph.Texts(GraphInitializer))
  {
    constants.insert(Message(bytes).Text(TensorName));
  }
  NetworkInterface found;
  for (const std::string& bytes : graph.Texts(GraphInput))
  {
    TensorShape input = ReadShape(bytes);
    if (constants.count(input.Name) == 0)
    {
      found.Inputs.push_back(std::move(input));
    }
  }
  for (const std::string& bytes : graph.Texts(GraphOutput))
  {
    found.Outputs.push_back(ReadShape(bytes));
  }
  if (found.Outputs.empty())
  {
    throw InvalidInput("the file has no network with an output; choose the ONNX file of a network");
  }
  return found;
}

Tensor Evaluate(std::string_view content, const std::vector<Tensor>& inputs)
{
  try
  {
    cv::setNumThreads(1);
    cv::dnn::Net net = cv::dnn::readNetFromONNX(content.data(), content.size());
    net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    for (const Tensor& input : inputs)
    {
      net.setInput(
        cv::Mat(input.Sizes, CV_32F, const_cast<float*>(input.Values.data())), input.Name);
    }
    const cv::Mat result = net.forward();
    if (result.type() != CV_32F || !result.isContinuous())
    {
      throw InvalidInput("the network's output is not in single precision; export it as such");
    }
    const auto* values = result.ptr<float>();
    return { {}, { result.size.p, result.size.p + result.dims },
      { values, values + result.total() } };
  }
  catch (const cv::Exception& error)
  {
    throw InvalidInput("OpenCV cannot evaluate the network (" + error.err +
      "); export it with simpler operations, or with another opset");
  }
}

} // namespace
} // namespace shape

void ShapeMapNetworkLibrary(shape::NetworkLibrary& own)
{
  own = { shape::Read, shape::Evaluate };
}
