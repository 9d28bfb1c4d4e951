#pragma once

class vtkMultiProcessController;

/**
 * Stops the filter that a server runs.
 *
 * A server reads no message of its client until its filter has ended. The client therefore sends an
 * urgent byte (out-of-band data of TCP), which arrives beside the messages and which every report
 * of progress of a filter on the server looks for. An SSH tunnel does not pass on urgent bytes.
 * Source: RFC 793, section 3.7; RFC 6093.
 */
namespace vtkShapeRemoteStop
{

/// Returns the descriptor of the socket that connects this process to another one; -1 if there is
/// none.
int GetSocket(vtkMultiProcessController* controller);

/// Asks the server at the other end of a socket to stop its filter. May be called in any thread.
void Send(int socket);

} // namespace vtkShapeRemoteStop
