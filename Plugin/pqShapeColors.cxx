#include "pqShapeColors.h"

#include "pqShapePorts.h"
#include "pqShapeRepresentation.h"

#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVGeneralSettings.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqView.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace
{

using pqShapeRepresentation::FindVisible;
using pqShapeRepresentation::Set;

/// The maximum number of values whose colours can be distinguished.
constexpr int MaximumCategories = 12;

/// A colour map that belongs to an array: value, red, green and blue of each of its points. Values
/// outside have the first and the last colour, unless there is a colour for values below.
struct ColorMap
{
  const char* Array;
  std::vector<double> Points;
  std::vector<double> Below;
};

/// Bad cells are red, inverted cells darker still, and good cells a calm blue. What is only marked
/// is orange in grey.
const std::vector<ColorMap>& GetColorMaps()
{
  static const std::vector<double> marks = { 0.0, 0.82, 0.82, 0.8, 1.0, 0.93, 0.5, 0.1 };
  static const std::vector<ColorMap> maps = {
    { "ScaledJacobian",
      { 0.0, 0.75, 0.1, 0.1, 0.25, 0.93, 0.45, 0.2, 0.5, 0.97, 0.82, 0.45, 0.75, 0.75, 0.84, 0.85,
        1.0, 0.42, 0.6, 0.75 },
      { 0.35, 0.0, 0.2 } },
    { "Filled", marks, {} },
    { "Inverted", marks, {} },
    { "Flipped", marks, {} },
  };
  return maps;
}

/// An array whose numbers stand for names: a value between two of them means nothing.
struct Category
{
  const char* Array;
  std::vector<std::string> Names; ///< of 0, 1, ...; the numbers themselves if there are none
  std::vector<double> Colors;     ///< red, green and blue of each; ParaView's if there are none
};

const std::vector<Category>& GetCategories()
{
  static const std::vector<Category> categories = {
    { "RegionId", {}, {} },
    { "Patch", {}, {} },
    { "Label", { "+x", "-x", "+y", "-y", "+z", "-z" }, {} },
    { "Part", { "target", "seam", "feature" },
      { 0.82, 0.82, 0.8, 0.97, 0.78, 0.55, 0.93, 0.5, 0.1 } },
  };
  return categories;
}

template <class Maps>
const typename Maps::value_type* Find(const Maps& maps, const std::string& array)
{
  const auto map =
    std::find_if(maps.begin(), maps.end(), [&array](const auto& m) { return array == m.Array; });
  return map == maps.end() ? nullptr : &*map;
}

bool IsShared(vtkSMProxy* table, vtkSMProxy* representation)
{
  for (const auto* other :
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqDataRepresentation*>())
  {
    vtkSMProxy* proxy = other->getProxy();
    if (proxy != representation &&
      vtkSMPropertyHelper(proxy, "LookupTable", true).GetAsProxy() == table)
    {
      return true;
    }
  }
  return false;
}

/// Each value of a category gets a colour of its own, if they are few.
void SetCategory(vtkSMProxy* table, const Category& category, const double range[2])
{
  const int first = static_cast<int>(range[0]), last = static_cast<int>(range[1]);
  if (last - first >= MaximumCategories)
  {
    return;
  }
  std::vector<std::string> annotations; // a value and its name, in turn
  for (int value = first; value <= last; ++value)
  {
    const bool named = value >= 0 && value < static_cast<int>(category.Names.size());
    annotations.push_back(std::to_string(value));
    annotations.push_back(
      named ? category.Names[static_cast<std::size_t>(value)] : annotations.back());
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", table);
  vtkSMTransferFunctionProxy::ApplyPreset(table, "Brewer Qualitative Set2", false);
  vtkSMPropertyHelper(table, "IndexedLookup").Set(1);
  vtkSMPropertyHelper helper(table, "Annotations");
  helper.SetNumberOfElements(static_cast<unsigned int>(annotations.size()));
  for (std::size_t i = 0; i < annotations.size(); ++i)
  {
    helper.Set(static_cast<unsigned int>(i), annotations[i].c_str());
  }
  if (!category.Colors.empty())
  {
    vtkSMPropertyHelper(table, "IndexedColors")
      .Set(category.Colors.data(), static_cast<unsigned int>(category.Colors.size()));
  }
  table->UpdateVTKObjects();
}

/// Gives an array its own colour map, unless another representation already shows the array.
void SetColorMap(vtkSMProxy* representation, const std::string& array, const double range[2])
{
  vtkSMProxy* table = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  if (!table || IsShared(table, representation))
  {
    return;
  }
  if (const Category* category = Find(GetCategories(), array))
  {
    SetCategory(table, *category, range);
  }
  const ColorMap* map = Find(GetColorMaps(), array);
  if (!map)
  {
    return;
  }
  Set(table, "ColorSpace", 0); // mix red, green and blue
  Set(table, "AutomaticRescaleRangeMode", vtkSMTransferFunctionManager::NEVER);
  Set(table, "RGBPoints", map->Points);
  if (!map->Below.empty())
  {
    Set(table, "UseBelowRangeColor", 1);
    Set(table, "BelowRangeColor", map->Below);
  }
}

void ShowColorBar(vtkSMProxy* representation, pqView* view)
{
  if (vtkPVGeneralSettings::GetInstance()->GetScalarBarMode() ==
    vtkPVGeneralSettings::AUTOMATICALLY_SHOW_AND_HIDE_SCALAR_BARS)
  {
    vtkSMPVRepresentationProxy::SetScalarBarVisibility(representation, view->getProxy(), true);
  }
}

/// The values of the array are colours.
void TakeAsColors(vtkSMProxy* representation, pqView* view)
{
  Set(representation, "MapScalars", 0);
  vtkSMPVRepresentationProxy::SetScalarBarVisibility(representation, view->getProxy(), false);
}

bool TakesAsColors(vtkSMProxy* representation)
{
  return vtkSMPropertyHelper(representation, "MapScalars", true).GetAsInt() == 0;
}

std::string GetArray(vtkSMProxy* representation)
{
  const char* name =
    vtkSMPropertyHelper(representation, "ColorArrayName", true).GetInputArrayNameToProcess();
  return name ? name : "";
}

void ColorByArray(pqOutputPort* port, vtkPVXMLElement* element, pqView* view)
{
  vtkSMProxy* representation = FindVisible(port, view);
  std::string array = element->GetAttributeOrEmpty("array");
  int association = std::strcmp(element->GetAttributeOrEmpty("association"), "CELLS") == 0
    ? vtkDataObject::CELL
    : vtkDataObject::POINT;
  const std::string like = element->GetAttributeOrEmpty("like");
  pqOutputPort* input =
    like.empty() ? nullptr : pqShapePorts::FindInput(port->getSource()->getProxy(), like);
  pqDataRepresentation* model = input ? input->getRepresentation(view) : nullptr;
  if (model && vtkSMPVRepresentationProxy::GetUsingScalarColoring(model->getProxy()))
  {
    array = vtkSMPropertyHelper(model->getProxy(), "ColorArrayName").GetInputArrayNameToProcess();
    association = vtkDataObject::POINT; // all transferred arrays are
  }
  if (array.empty() && vtkSMPVRepresentationProxy::GetUsingScalarColoring(representation))
  {
    const vtkSMPropertyHelper chosen(representation, "ColorArrayName");
    array = chosen.GetInputArrayNameToProcess();
    association = chosen.GetInputArrayAssociation();
  }
  vtkPVArrayInformation* information = array.empty()
    ? nullptr
    : port->getDataInformation()->GetArrayInformation(array.c_str(), association);
  if (!information)
  {
    const auto* filter = qobject_cast<pqPipelineFilter*>(port->getSource());
    for (pqOutputPort* each : filter ? filter->getAllInputs() : QList<pqOutputPort*>())
    {
      pqShapeColors::Follow(port, each, view);
    }
    return;
  }
  vtkSMProxy* former = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  if (GetArray(representation) != array)
  {
    // ParaView copies the display of the input, whose array may be one of colours. It crashes if
    // another array, of more than four components, is then taken as colours.
    const bool colors =
      model && GetArray(model->getProxy()) == array && TakesAsColors(model->getProxy());
    Set(representation, "MapScalars", colors ? 0 : 1);
  }
  vtkSMPVRepresentationProxy::SetScalarColoring(representation, array.c_str(), association);
  if (former)
  {
    vtkSMPVRepresentationProxy::HideScalarBarIfNotNeeded(former, view->getProxy());
  }
  if (element->GetAttribute("direct"))
  {
    TakeAsColors(representation, view);
    return;
  }
  int component = 0;
  if (element->GetScalarAttribute("component", &component))
  {
    vtkSMPVRepresentationProxy::SetScalarColoring(
      representation, array.c_str(), association, component);
  }
  vtkSMPVRepresentationProxy::RescaleTransferFunctionToDataRange(representation, false, false);
  SetColorMap(representation, array, information->GetComponentRange(0));
  ShowColorBar(representation, view);
}

} // namespace

namespace pqShapeColors
{

void Apply(pqOutputPort* port, vtkPVXMLElement* element, pqView* view)
{
  vtkSMProxy* representation = FindVisible(port, view);
  if (!representation)
  {
    return;
  }
  double color[3];
  if (element->GetVectorAttribute("solid", 3, color) == 3)
  {
    vtkSMPVRepresentationProxy::SetScalarColoring(representation, nullptr, vtkDataObject::POINT);
    Set(representation, "AmbientColor", { color, color + 3 });
    Set(representation, "DiffuseColor", { color, color + 3 });
    return;
  }
  ColorByArray(port, element, view);
}

void Follow(pqOutputPort* port, pqOutputPort* other, pqView* view)
{
  vtkSMProxy* representation = FindVisible(port, view);
  pqDataRepresentation* model = other->getRepresentation(view);
  if (representation && model && GetArray(representation) == GetArray(model->getProxy()) &&
    TakesAsColors(model->getProxy()) &&
    vtkSMPVRepresentationProxy::GetUsingScalarColoring(representation))
  {
    TakeAsColors(representation, view);
  }
}

} // namespace pqShapeColors
