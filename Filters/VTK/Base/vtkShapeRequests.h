#pragma once

class vtkExecutive;
class vtkInformation;
class vtkInformationVector;

/// Parts of the pipeline's requests that depend on no filter.
namespace vtkShapeRequests
{

/// Gives the outputs the times of all inputs. The pipeline passes on only the times of the first
/// port, so a filter would not run again for the times of another port.
void OfferTimes(int inputPorts, vtkInformationVector** inputs, vtkInformationVector* outputs);

/// Gives the outputs the times from 0 to 1, in 41 steps, for filters whose time is a parameter.
void OfferUnitTime(vtkInformationVector* outputs);

/// Returns the requested time of an output with these times: between 0 and 1, and 0 if none is
/// requested.
double GetUnitTime(vtkInformation* output);

/// Requests each input at its own first time, for filters whose time is a parameter.
void RequestFirstTimes(int inputPorts, vtkInformationVector** inputs);

/// For each grid on another port than the first, requests this process's part of its extent. By
/// default, the pipeline would request the extent of the output, which is the extent of the first
/// input.
void RequestOwnExtents(int inputPorts, vtkInformationVector** inputs);

/// Keeps the executive from showing its own error for the request that is about to fail: it has no
/// reason, and follows the error that has one. Called after that error.
void SilenceFailure(vtkExecutive* executive);

} // namespace vtkShapeRequests
