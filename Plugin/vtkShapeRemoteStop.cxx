#include "vtkShapeRemoteStop.h"

#include "vtkShapeProgress.h"

#include "vtkClientSocket.h"
#include "vtkCommand.h"
#include "vtkCompositeMultiProcessController.h"
#include "vtkPVProgressHandler.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkSocketCommunicator.h"
#include "vtkWeakPointer.h"

#include <chrono>

#include <sys/socket.h>

namespace
{

bool Receive(int socket)
{
  char byte = 0;
  return recv(socket, &byte, 1, MSG_OOB | MSG_DONTWAIT) == 1;
}

/// Looks for urgent bytes of the client. A stop is valid until the client begins its next request,
/// so that it also ends the filters downstream.
class ClientRequest
{
public:
  bool IsWanted()
  {
    using namespace std::chrono;
    constexpr auto interval = milliseconds(50); // filters report far more often
    if (!this->Wanted && steady_clock::now() >= this->Next)
    {
      this->Next = steady_clock::now() + interval;
      this->Wanted = this->FindClient() && Receive(this->Client);
    }
    return this->Wanted;
  }

private:
  bool FindClient()
  {
    vtkProcessModule* module = vtkProcessModule::GetProcessModule();
    auto* session = vtkPVSession::SafeDownCast(module ? module->GetActiveSession() : nullptr);
    this->Client =
      session ? vtkShapeRemoteStop::GetSocket(session->GetController(vtkPVSession::CLIENT)) : -1;
    if (this->Client >= 0 && this->Handler != session->GetProgressHandler())
    {
      this->Handler = session->GetProgressHandler();
      this->Handler->AddObserver(vtkCommand::StartEvent, this, &ClientRequest::Forget);
    }
    return this->Client >= 0;
  }

  /// A byte that arrived after the end of its filter must not stop the next one.
  void Forget()
  {
    this->Wanted = false;
    while (this->Client >= 0 && Receive(this->Client))
    {
    }
  }

  int Client = -1;
  vtkWeakPointer<vtkPVProgressHandler> Handler;
  std::chrono::steady_clock::time_point Next;
  bool Wanted = false;
};

/// Every process that loads the plugin may become a server.
const bool isListening = []
{
  static ClientRequest request;
  vtkShapeProgress::SetStopRequest([] { return request.IsWanted(); });
  return true;
}();

} // namespace

namespace vtkShapeRemoteStop
{

int GetSocket(vtkMultiProcessController* controller)
{
  if (auto* clients = vtkCompositeMultiProcessController::SafeDownCast(controller))
  {
    controller = clients->GetActiveController();
  }
  auto* communicator =
    vtkSocketCommunicator::SafeDownCast(controller ? controller->GetCommunicator() : nullptr);
  vtkClientSocket* socket = communicator ? communicator->GetSocket() : nullptr;
  return socket ? socket->GetSocketDescriptor() : -1;
}

void Send(int socket)
{
  const char byte = 1;
  // If the connection is broken, ParaView says so: nothing is left to stop.
  (void)send(socket, &byte, 1, MSG_OOB | MSG_NOSIGNAL);
}

} // namespace vtkShapeRemoteStop
