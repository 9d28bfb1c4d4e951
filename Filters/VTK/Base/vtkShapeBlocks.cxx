#include "vtkShapeBlocks.h"

#include "vtkShapeComposite.h"
#include "vtkShapeGather.h"

#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <utility>

namespace
{

/// The data and the name of each block of the top level; both may be missing on this process.
std::vector<std::pair<vtkDataObject*, std::string>> ListBlocks(vtkDataObject* data)
{
  std::vector<std::pair<vtkDataObject*, std::string>> blocks;
  const auto add = [&](vtkDataObject* block, vtkInformation* about)
  {
    const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
    blocks.emplace_back(block, name ? name : "");
  };
  if (auto* tree = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i)
    {
      add(tree->GetBlock(i), tree->HasMetaData(i) ? tree->GetMetaData(i) : nullptr);
    }
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      add(collection->GetPartitionedDataSet(i),
        collection->HasMetaData(i) ? collection->GetMetaData(i) : nullptr);
    }
  }
  else
  {
    add(data, nullptr);
  }
  return blocks;
}

} // namespace

std::vector<vtkShapeBlocks::Block> vtkShapeBlocks::Gather(vtkDataObject* data,
  vtkMultiProcessController* controller, std::vector<Block>* empty, const std::string& name)
{
  vtkShapeGather::RunOnAllOrFail(controller, [&] { vtkShapeComposite::RequireDataSets(data); });
  std::vector<std::pair<vtkDataObject*, std::string>> own = ListBlocks(data);
  auto count = static_cast<double>(own.size());
  vtkShapeGather::Reduce(controller, &count, 1, vtkShapeGather::Reduction::Maximum);
  own.resize(static_cast<std::size_t>(count));
  std::vector<Block> blocks;
  for (int number = 0; number < static_cast<int>(own.size()); ++number)
  {
    const auto& [block, blockName] = own[number];
    if (vtkShapeGather::CountPoints(block, controller) > 0)
    {
      std::vector<int> ownPoints;
      blocks.push_back({ vtkShapeGather::Gather(
                           block, name, vtkShapeGather::Joined::Coincident, controller, ownPoints),
        blockName, number });
    }
    else if (empty)
    {
      empty->push_back({ nullptr, blockName, number });
    }
  }
  return blocks;
}
