#include "vtkShapeCorrespondence.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeCorrespondenceResult.h"
#include "vtkShapeFunctionalMap.h"
#include "vtkShapeGivenLandmarks.h"
#include "vtkShapeList.h"
#include "vtkShapeMapColors.h"
#include "vtkShapeRepair.h"
#include "vtkShapeSurfaces.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeCorrespondence);

namespace
{

constexpr int MatrixPort = 3, CouplingPort = 4, BasePort = 5,
              CandidatesPort = 6; // of the outputs

/// Whether a list names an array.
bool HasNames(const std::vector<std::string>& arrays)
{
  return std::any_of(arrays.begin(), arrays.end(), vtkShapeConvert::IsChosen);
}

double MeanByArea(const shape::Surface& surface, const Eigen::VectorXd& values)
{
  const Eigen::VectorXd areas = shape::ComputePointAreas(surface);
  return areas.dot(values) / areas.sum();
}

} // namespace

void vtkShapeCorrespondence::SetNumberOfDescriptorArrays(int count)
{
  vtkShapeList::Resize(this, this->DescriptorArrays, count);
}

void vtkShapeCorrespondence::SetDescriptorArrays(int index, const std::string& name)
{
  vtkShapeList::Set(this, "Descriptor Arrays", this->DescriptorArrays, index, { name });
}

void vtkShapeCorrespondence::SetNumberOfFeatureArrays(int count)
{
  vtkShapeList::Resize(this, this->FeatureArrays, count);
}

void vtkShapeCorrespondence::SetFeatureArrays(int index, const std::string& name)
{
  vtkShapeList::Set(this, "Feature Arrays", this->FeatureArrays, index, { name });
}

void vtkShapeCorrespondence::SetNumberOfTransferArrays(int count)
{
  vtkShapeList::Resize(this, this->TransferArrays, count);
}

void vtkShapeCorrespondence::SetTransferArrays(int index, const std::string& name)
{
  vtkShapeList::Set(this, "Transfer Arrays", this->TransferArrays, index, { name });
}

vtkShapeCorrespondence::vtkShapeCorrespondence()
{
  this->DeclareInput("SurfaceA", PortData::WholeSurface, PortUse::Required,
    { "vtkPolyData", "vtkUnstructuredGrid" });
  this->DeclareInput("SurfaceB", PortData::WholeSurface, PortUse::Required,
    { "vtkPolyData", "vtkUnstructuredGrid" });
  this->DeclareInput("Landmarks", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareInput("TargetLandmarks", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareInput("FunctionalMap", PortData::Table, PortUse::Optional, { "vtkTable" });
  this->DeclareOutputLikeInput(0);
  this->DeclareOutputLikeInput(1);
  this->DeclareFacts();
  this->DeclareOutput("vtkTable");    // MatrixPort
  this->DeclareOutput("vtkTable");    // CouplingPort
  this->DeclareOutput("vtkPolyData"); // BasePort
  this->DeclareOutput("vtkTable");    // CandidatesPort
  this->DeclareShown(0, { "MapColors" });
  this->DeclareShown(1, { "MapColors" });
}

/// Every process computes the same maps from the gathered surfaces, and writes the rows of its own
/// points.
void vtkShapeCorrespondence::Execute(const shape::Progress& progress)
{
  const shape::Surface a = vtkShapeConvert::ToMesh(this->GetGatheredInput(0).Data, "SurfaceA"),
                       b = vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "SurfaceB");
  shape::RequireManifold(a, "SurfaceA");
  shape::RequireManifold(b, "SurfaceB");
  const bool hasLandmarks = this->GetNumberOfInputConnections(2) > 0;
  const bool hasTargets = this->GetNumberOfInputConnections(3) > 0;
  if (hasTargets && !hasLandmarks)
  {
    throw shape::InvalidInput("there are TargetLandmarks without Landmarks; connect both");
  }
  shape::CorrespondenceOptions options = this->Options;
  shape::RequireOption(
    this->Coupled.Size >= 0, "CoupledBasisSize", this->Coupled.Size, "at least 0");
  shape::RequireOption(this->Coupled.Weight >= 0.0 && std::isfinite(this->Coupled.Weight),
    "CoupledBasisWeight", this->Coupled.Weight, "at least 0 and finite");
  const bool couple = this->Coupled.Size > 0;
  options.FunctionalMatrix = this->OutputEigenfunctions || couple || HasNames(this->TransferArrays);
  shape::FunctionalGuide& guide = options.Functional.Guide;
  guide = this->ReadGuide(a, b);
  shape::Landmarks landmarks;
  if (hasLandmarks)
  {
    vtkUnstructuredGrid* grid = this->GetGatheredInput(2).Grid;
    const vtkShapeGivenLandmarks given(grid,
      hasTargets ? vtkShapeConvert::ToPoints(this->GetGatheredInput(3).Grid)
                 : vtkShapeConvert::ToPointArray(grid, "TargetPosition", 3, "the input Landmarks",
                     "make it with Shape Landmarks"));
    if (options.Method == shape::CorrespondenceOptions::MethodType::CommonBase)
    {
      landmarks = given.PairEnds(a, b);
      options.Base.Curves = given.TraceCurves(a, b);
    }
    else
    {
      landmarks = given.PairAll(a, b);
    }
    if (this->CurveDescriptors)
    {
      guide.Curves = given.PairCurves(a, b);
    }
  }
  if (!options.UsesGuide() && (guide.HasDescriptors() || guide.Matrix.size() > 0))
  {
    this->Warn("the method computes no functional map, so FunctionalMap, DescriptorArrays, "
               "RegionArray and CurveDescriptors do not count; set Method to FunctionalMap");
  }
  shape::RequireOption(this->SmallestMass >= 0.0 && this->SmallestMass <= 1.0, "SmallestMass",
    this->SmallestMass, "between 0 and 1");
  shape::RequireOption(this->ImageOfPoint >= -1, "ImageOfPoint", this->ImageOfPoint, "at least -1");
  if (this->ImageOfPoint >= 0 &&
    this->Options.Method != shape::CorrespondenceOptions::MethodType::GromovWasserstein)
  {
    throw shape::InvalidInput("only GromovWasserstein computes the distribution of an image; set "
                              "Method to GromovWasserstein, or Image Of Point to -1");
  }
  const vtkShapeFunctionalMap::Descriptors features = vtkShapeFunctionalMap::ReadDescriptors(
    this->GetGatheredInput(0).Data, this->GetGatheredInput(1).Data, this->FeatureArrays);
  options.Features.OfA = features.OfA;
  options.Features.OfB = features.OfB;
  const shape::CorrespondenceResult result =
    shape::ComputeCorrespondence(a, b, landmarks, options, progress.Part(0.0, 0.95));
  const bool isPart = result.Part.Which != shape::SurfacePart::WhichType::None;
  if (result.GenusOfA != result.GenusOfB && !isPart)
  {
    this->Warn("the surfaces have genus " + std::to_string(result.GenusOfA) + " and " +
      std::to_string(result.GenusOfB) +
      ": no continuous one-to-one map exists; expect folds, or map surfaces of equal genus");
  }
  const auto& handles = result.Handles;
  const double shortestOfA = handles ? handles->ShortestOfA : -1.0,
               shortestOfB = handles ? handles->ShortestOfB : -1.0;
  for (const auto& [shortest, name] :
    { std::pair(shortestOfA, "SurfaceA"), std::pair(shortestOfB, "SurfaceB") })
  {
    constexpr double tiny = 0.05;
    if (shortest >= 0.0 && shortest < tiny)
    {
      this->Warn(std::string("a loop around a handle of ") + name + " is only " +
        shape::FormatNumber(shortest) +
        " times the root of the area long; if that handle is noise, close it with Shape Solidify");
    }
  }
  std::map<std::string, Eigen::MatrixXd> onA, onB;
  if (!result.Coupling.SamplesOfA.empty())
  {
    onA["SampleWeight"] = Eigen::MatrixXd::Zero(a.Points().rows(), 1);
    onA["SampleWeight"](result.Coupling.SamplesOfA, 0) = result.Coupling.WeightsOfA;
    onB["SampleWeight"] = Eigen::MatrixXd::Zero(b.Points().rows(), 1);
    onB["SampleWeight"](result.Coupling.SamplesOfB, 0) = result.Coupling.WeightsOfB;
  }
  if (result.Blended)
  {
    onA["MapConfidence"] = result.Blended->ConfidenceOfA;
    onB["MapConfidence"] = result.Blended->ConfidenceOfB;
  }
  if (this->ImageOfPoint >= 0)
  {
    const std::vector<int>& points = this->GetGatheredInput(0).GivenPoints;
    const auto found = std::find(points.begin(), points.end(), this->ImageOfPoint);
    const int point =
      found == points.end() ? this->ImageOfPoint : static_cast<int>(found - points.begin());
    onB["ImageDistribution"] =
      shape::ComputeImageDistribution(a, b, result.Coupling, point, progress.Part(0.95, 1.0));
  }
  double diagonal = -1.0;
  if (couple)
  {
    const shape::CoupledFunctions bases = shape::CoupleEigenfunctions(result.Matrix, result.Used,
      guide.DescriptorsOfA, guide.DescriptorsOfB, this->Coupled, progress.Part(0.95, 1.0));
    onA["CoupledEigenfunctions"] = bases.OfA;
    onB["CoupledEigenfunctions"] = bases.OfB;
    diagonal = bases.DiagonalShare;
  }
  this->WriteMap(0, result, b, onA);
  this->WriteMap(1, result, a, onB);
  const double omitted = this->WriteCoupling(result.Coupling);
  const bool isFirst = !this->GetController() || this->GetController()->GetLocalProcessId() == 0;
  if (options.FunctionalMatrix && isFirst)
  {
    vtkShapeFunctionalMap::WriteMatrix(
      result.Matrix, vtkTable::SafeDownCast(this->GetOutputDataObject(MatrixPort)));
  }
  if (result.Base && isFirst)
  {
    vtkShapeCorrespondenceResult::WriteBase(
      result, a, b, vtkPolyData::SafeDownCast(this->GetOutputDataObject(BasePort)));
  }
  if (result.Blended && isFirst)
  {
    const auto given = [&](int port, const Eigen::MatrixXi& points)
    {
      Eigen::MatrixXi numbers(points.rows(), points.cols());
      for (Eigen::Index k = 0; k < points.cols(); ++k)
      {
        numbers.col(k) =
          vtkShapeRepaired::ToGiven(this->GetGatheredInput(port).GivenPoints, points.col(k));
      }
      return numbers;
    };
    vtkShapeCorrespondenceResult::WriteCandidates(*result.Blended,
      given(0, result.Blended->TriplesOfA), given(1, result.Blended->TriplesOfB),
      vtkTable::SafeDownCast(this->GetOutputDataObject(CandidatesPort)));
  }
  vtkShapeMapColors::Add(this->GetOutputDataObject(0), "TargetPosition", b);
  vtkShapeMapColors::Add(this->GetOutputDataObject(1), "", b);
  for (const int port : { 0, 1 })
  {
    const auto add = [&](const std::string& fact, double value)
    { vtkShapeConvert::AddFact(this->GetOutputDataObject(port), "Correspondence." + fact, value); };
    add("Landmarks", static_cast<double>(result.Used.size()));
    add("LandmarksFound", result.Found ? 1.0 : 0.0);
    if (hasLandmarks)
    {
      vtkShapeConvert::AddFact(this->GetOutputDataObject(port), "Correspondence.LandmarkTargets",
        hasTargets ? "TargetLandmarks" : "TargetPosition");
    }
    const bool byDistances = result.Found && result.VotingMaps == 0;
    add("Distortion", byDistances ? result.Start.Distortion : -1.0);
    add("MirroredDistortion", byDistances ? result.Start.MirroredDistortion : -1.0);
    add("MirrorImage", !byDistances ? -1.0 : result.Start.MirrorImage ? 1.0 : 0.0);
    add("IsometryError", byDistances ? result.Start.Error : -1.0);
    add("Alternatives", byDistances ? result.Start.Alternatives : 0.0);
    add("Confidence", byDistances ? result.Start.Confidence : -1.0);
    add("Certain", !byDistances ? -1.0 : result.Start.Certain ? 1.0 : 0.0);
    const auto& congruent = result.Congruent;
    add("Congruence", congruent ? static_cast<double>(congruent->Relation) : -1.0);
    add("MotionError", congruent ? congruent->MotionError : -1.0);
    add("ReflectionError", congruent ? congruent->ReflectionError : -1.0);
    add("VotingMaps", result.VotingMaps);
    add("VotingConfidence", result.VotingConfidence);
    add("DirichletEnergy", result.Facts.DirichletEnergy);
    add("RoundTrip", result.Facts.RoundTrip);
    add("ReversedArea", result.Facts.ReversedArea);
    add("Mirrored", result.Facts.Mirrored ? 1.0 : 0.0);
    add("Part", static_cast<double>(result.Part.Which));
    add("Scale", result.Part.Scale);
    add("PartShare", result.Part.Share);
    add("CoverageOfA", result.Facts.CoverageOfA);
    add("CoverageOfB", result.Facts.CoverageOfB);
    add("CouplingDistortion", result.CouplingDistortion);
    add("CouplingError", result.CouplingError);
    add("CouplingOmitted", omitted);
    add("FeatureCost", result.FeatureCost);
    const auto& distances = result.Distances;
    add("MaximumDistortion", distances ? distances->Maximum : -1.0);
    add("RMSDistortion", distances ? distances->RootMeanSquare : -1.0);
    add("GromovHausdorffUpper", distances ? distances->Upper : -1.0);
    add("GromovHausdorffLower", distances ? distances->Lower : -1.0);
    add("SamplingError", distances ? distances->SamplingError : -1.0);
    add("CoarsePoints", result.CoarsePoints);
    const auto& base = result.Base;
    add("Patches", base ? base->Patches : 0);
    add("FlippedTriangles", base ? base->Flipped : 0);
    add("SymmetricDirichlet", base ? base->Energy : -1.0);
    add("SymmetricDirichletBack", base ? base->EnergyBack : -1.0);
    add("MeasureBefore", base ? base->MeasureBefore : -1.0);
    add("MeasureAfter", base ? base->MeasureAfter : -1.0);
    add("GenusOfA", result.GenusOfA);
    add("GenusOfB", result.GenusOfB);
    add("ShortestLoopOfA", shortestOfA);
    add("ShortestLoopOfB", shortestOfB);
    add("Iterations", result.Iterations);
    const auto& blended = result.Blended;
    add("CandidateMaps", blended ? static_cast<double>(blended->Weights.size()) : 0.0);
    add("GroupMaps", blended ? static_cast<double>((blended->Weights.array() > 0.0).count()) : 0.0);
    add("MeanConfidence",
      !blended      ? -1.0
        : port == 0 ? MeanByArea(a, blended->ConfidenceOfA)
                    : MeanByArea(b, blended->ConfidenceOfB));
    add("CoupledDiagonal", diagonal);
    add("FunctionalMapSize", static_cast<double>(result.Matrix.Matrix.rows()));
  }
}

shape::FunctionalGuide vtkShapeCorrespondence::ReadGuide(
  const shape::Surface& a, const shape::Surface& b)
{
  vtkPolyData *dataA = this->GetGatheredInput(0).Data, *dataB = this->GetGatheredInput(1).Data;
  shape::FunctionalGuide guide;
  vtkShapeFunctionalMap::Descriptors given =
    vtkShapeFunctionalMap::ReadDescriptors(dataA, dataB, this->DescriptorArrays);
  if (vtkShapeConvert::IsChosen(this->RegionArray))
  {
    const auto regions = [&](vtkPolyData* data, const std::string& name)
    {
      std::vector<int> cellOf;
      vtkShapeConvert::ToMesh(data, name, &cellOf);
      return vtkShapeFunctionalMap::ReadRegions(data, cellOf, this->RegionArray, name);
    };
    vtkShapeFunctionalMap::Append(
      shape::ComputeRegionIndicators(a, regions(dataA, "SurfaceA"), b, regions(dataB, "SurfaceB")),
      given);
  }
  guide.DescriptorsOfA = std::move(given.OfA);
  guide.DescriptorsOfB = std::move(given.OfB);
  if (vtkShapeConvert::IsChosen(this->DisplacementArray))
  {
    const auto vectors = [&](vtkPolyData* data, const std::string& name)
    {
      Eigen::MatrixXd values =
        vtkShapeFunctionalMap::ReadArray(data, this->DisplacementArray, name);
      if (values.cols() != 3)
      {
        throw shape::InvalidInput("the array '" + this->DisplacementArray + "' of " + name +
          " has " + std::to_string(values.cols()) +
          " components, but displacements are vectors of 3; choose " +
          "another Displacement Array, or None for the normals");
      }
      return values;
    };
    guide.DisplacementsOfA = vectors(dataA, "SurfaceA");
    guide.DisplacementsOfB = vectors(dataB, "SurfaceB");
  }
  if (this->GetNumberOfInputConnections(4) > 0)
  {
    guide.Matrix =
      vtkShapeFunctionalMap::ReadMatrix(this->GetInputDataObject(4, 0), this->GetController());
    shape::RequireFunctionalMap(guide.Matrix);
  }
  return guide;
}

void vtkShapeCorrespondence::WriteMap(int port, const shape::CorrespondenceResult& result,
  const shape::Mesh& other, const std::map<std::string, Eigen::MatrixXd>& more)
{
  const GatheredInput& whole = this->GetGatheredInput(port);
  const GatheredInput& target = this->GetGatheredInput(1 - port);
  const shape::SurfacePoints& map = port == 0 ? result.Maps.AToB : result.Maps.BToA;
  // Cell ids of polygons follow those of vertices and lines.
  const auto before =
    static_cast<double>(target.Given->GetNumberOfVerts() + target.Given->GetNumberOfLines());
  const Eigen::VectorXi triangles = vtkShapeRepaired::ToGiven(target.GivenTriangles, map.Triangles);
  const auto own = [&](const Eigen::MatrixXd& values)
  { return vtkShapeConvert::Rows(values, whole.OwnPoints); };
  std::vector<vtkShapeComposite::PointField> fields = {
    { "TargetPosition", own(shape::PullBack(map, other.Triangles, other.Points)) },
    { "TargetCell", own(triangles.cast<double>().array() + before), true },
    { "TargetBarycentric", own(map.Barycentrics) }
  };
  if (result.Base)
  {
    const Eigen::VectorXi& patches = port == 0 ? result.Base->PatchesOfA : result.Base->PatchesOfB;
    fields.push_back({ "Patch", own(patches.cast<double>()), true });
  }
  const Eigen::MatrixXd& sphere = port == 0 ? result.SphereA : result.SphereB;
  if (sphere.rows() > 0)
  {
    fields.push_back({ "SpherePosition", own(sphere) });
  }
  for (const auto& [name, values] : more)
  {
    fields.push_back({ name, own(values) });
  }
  const shape::LaplaceEigenpairs& basis = port == 0 ? result.Matrix.OfA : result.Matrix.OfB;
  if (this->OutputEigenfunctions)
  {
    fields.push_back({ "Eigenfunctions", own(basis.Eigenfunctions) });
    fields.push_back({ "Masses", own(basis.Masses) });
  }
  for (const std::string& array : this->TransferArrays)
  {
    if (port == 1 && vtkShapeConvert::IsChosen(array))
    {
      fields.push_back({ array + "FromA",
        own(shape::TransferFunctions(
          result.Matrix, vtkShapeFunctionalMap::ReadArray(target.Data, array, "SurfaceA"))) });
    }
  }
  vtkDataObject* output = this->GetOutputDataObject(port);
  vtkShapeComposite::AddPointFields(
    vtkShapeSurfaces::SolidAsBoundary(
      this->GetInputDataObject(port, 0), this->GetInputName(port), this->GetController()),
    output, fields);
  if (this->OutputEigenfunctions)
  {
    output->GetAttributesAsFieldData(vtkDataObject::FIELD)
      ->AddArray(vtkShapeConvert::ToArray(basis.Eigenvalues, "Eigenvalues"));
  }
}

double vtkShapeCorrespondence::WriteCoupling(const shape::SampledCoupling& coupling)
{
  const shape::CouplingEntries entries = shape::ListEntries(coupling.Masses, this->SmallestMass);
  const auto given = [&](int port, const std::vector<int>& samples, const std::vector<int>& indices)
  {
    Eigen::VectorXi points(static_cast<Eigen::Index>(indices.size()));
    std::transform(
      indices.begin(), indices.end(), points.begin(), [&](int index) { return samples[index]; });
    return vtkShapeRepaired::ToGiven(this->GetGatheredInput(port).GivenPoints, points);
  };
  // Every process has the same coupling, and one of them outputs it.
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    auto* table = vtkTable::SafeDownCast(this->GetOutputDataObject(CouplingPort));
    table->AddColumn(
      vtkShapeCorrespondenceResult::ToIds(given(0, coupling.SamplesOfA, entries.OfA), "SampleOfA"));
    table->AddColumn(
      vtkShapeCorrespondenceResult::ToIds(given(1, coupling.SamplesOfB, entries.OfB), "SampleOfB"));
    table->AddColumn(vtkShapeConvert::ToArray(entries.Masses, "Mass"));
  }
  return coupling.SamplesOfA.empty() ? -1.0 : entries.Omitted;
}
