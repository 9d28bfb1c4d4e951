#include "IO/Private/CascadeFile.h"

#include "Base/Errors.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <UnitsMethods.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <sstream>
#include <sys/mman.h>
#include <unistd.h>

namespace shape
{
namespace
{

std::string ToWord(const Handle(TCollection_HAsciiString) & text)
{
  return text.IsNull() ? std::string() : std::string(text->ToCString());
}

std::string FindEntityName(const Handle(Standard_Transient) & entity)
{
  if (const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity))
  {
    return ToWord(item->Name());
  }
  if (const auto definition = Handle(StepBasic_ProductDefinition)::DownCast(entity))
  {
    const auto formation = definition->Formation();
    return formation.IsNull() || formation->OfProduct().IsNull()
      ? std::string()
      : ToWord(formation->OfProduct()->Name());
  }
  const auto iges = Handle(IGESData_IGESEntity)::DownCast(entity);
  return iges.IsNull() || !iges->HasName() ? std::string() : ToWord(iges->NameValue());
}

/// Finds the names of faces and solids. A solid without a name has that of a product with no other
/// solid.
ShapeNames FindNames(const XSControl_Reader& reader)
{
  ShapeNames names, products;
  const auto process = reader.WS()->TransferReader()->TransientProcess();
  const auto model = reader.WS()->Model();
  for (Standard_Integer i = 1; i <= model->NbEntities(); ++i)
  {
    const Handle(Standard_Transient) entity = model->Value(i);
    const std::string name = FindEntityName(entity);
    const TopoDS_Shape shape =
      name.empty() ? TopoDS_Shape() : TransferBRep::ShapeResult(process, entity);
    if (shape.IsNull())
    {
      continue;
    }
    if (!entity->IsKind(STANDARD_TYPE(StepBasic_ProductDefinition)))
    {
      names.Bind(shape.Located(TopLoc_Location()), name);
      continue;
    }
    TopExp_Explorer solids(shape, TopAbs_SOLID);
    const TopoDS_Shape first = solids.More() ? solids.Current() : TopoDS_Shape();
    if (solids.More() && (solids.Next(), !solids.More()))
    {
      products.Bind(first.Located(TopLoc_Location()), name);
    }
  }
  for (ShapeNames::Iterator product(products); product.More(); product.Next())
  {
    if (!names.IsBound(product.Key()))
    {
      names.Bind(product.Key(), product.Value());
    }
  }
  return names;
}

/// Keeps the first alarm that OpenCASCADE reports, for the error.
class FirstAlarm : public Message_Printer
{
public:
  DEFINE_STANDARD_RTTI_INLINE(FirstAlarm, Message_Printer)
  mutable std::string Text;

protected:
  // NOLINTNEXTLINE(readability-identifier-naming)
  void send(const TCollection_AsciiString& text, Message_Gravity gravity) const override
  {
    if (gravity >= Message_Alarm && this->Text.empty())
    {
      this->Text = text.ToCString();
    }
  }
};

[[noreturn]] void Refuse(const char* format, const FirstAlarm& alarm)
{
  throw InvalidInput(std::string("OpenCASCADE cannot read it as ") + format +
    (alarm.Text.empty() ? "" : " (" + alarm.Text + ")") + "; export the file again");
}

/// Transfers everything that was read. unit: its length in mm, or 0 if there is none.
CascadeFile Transfer(XSControl_Reader& reader, double unit)
{
  CascadeFile file;
  const std::string word = UnitsMethods::DumpLengthUnit(unit);
  file.Unit = unit == 0.0 ? "" : word == "UNDEFINED" ? std::to_string(unit) + " mm" : word;
  reader.TransferRoots();
  file.Shape = reader.OneShape();
  file.Names = FindNames(reader);
  return file;
}

/// Returns the first unit of length, in mm; 0 if there is none.
double FindUnit(const Handle(StepData_StepModel) & model)
{
  using Context = StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext;
  using ContextWithUncertainty = StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx;
  for (Standard_Integer i = 1; i <= model->NbEntities(); ++i)
  {
    const auto plain = Handle(Context)::DownCast(model->Value(i));
    const auto uncertain = Handle(ContextWithUncertainty)::DownCast(model->Value(i));
    STEPConstruct_UnitContext units;
    if (!plain.IsNull() || !uncertain.IsNull())
    {
      units.ComputeFactors(plain.IsNull() ? uncertain->GlobalUnitAssignedContext()
                                          : plain->GlobalUnitAssignedContext());
    }
    if (units.LengthDone())
    {
      return units.LengthFactor();
    }
  }
  return 0.0;
}

CascadeFile ReadSTEP(std::string_view content, const FirstAlarm& alarm)
{
  STEPControl_Reader reader;
  std::istringstream stream{ std::string(content) };
  if (reader.ReadStream("file", stream) != IFSelect_RetDone)
  {
    Refuse("STEP", alarm);
  }
  const double unit = FindUnit(reader.StepModel());
  reader.SetSystemLengthUnit(unit > 0.0 ? unit : 1.0);
  return Transfer(reader, unit);
}

CascadeFile ReadIGES(std::string_view content, const FirstAlarm& alarm)
{
  // The reader opens a file by its name: this one is in memory.
  const int memory = memfd_create("iges", 0);
  if (memory < 0 ||
    write(memory, content.data(), content.size()) != static_cast<ssize_t>(content.size()))
  {
    throw SolveFailure("there is no memory for the file; free some memory");
  }
  IGESControl_Reader reader;
  if (reader.ReadFile(("/proc/self/fd/" + std::to_string(memory)).c_str()) != IFSelect_RetDone)
  {
    Refuse("IGES", alarm);
  }
  IGESData_GlobalSection global = reader.IGESModel()->GlobalSection();
  const double unit = global.UnitValue();
  global.SetCascadeUnit(unit);
  reader.IGESModel()->SetGlobalSection(global);
  return Transfer(reader, unit);
}

CascadeFile ReadBREP(std::string_view content, const FirstAlarm& alarm)
{
  CascadeFile file;
  std::istringstream stream{ std::string(content) };
  BRepTools::Read(file.Shape, stream, BRep_Builder());
  if (file.Shape.IsNull())
  {
    Refuse("BREP", alarm);
  }
  return file;
}

} // namespace

CascadeFile ReadCascadeFile(std::string_view content, CADFormat format)
{
  const Handle(FirstAlarm) alarm = new FirstAlarm;
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Message::DefaultMessenger()->AddPrinter(alarm);
  return format == CADFormat::STEP ? ReadSTEP(content, *alarm)
    : format == CADFormat::IGES    ? ReadIGES(content, *alarm)
                                   : ReadBREP(content, *alarm);
}

} // namespace shape
