#include "pqShapeStop.h"

#include "pqShapeStopWatch.h"
#include "vtkShapeProgress.h"
#include "vtkShapeRemoteStop.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPipelineSource.h"
#include "pqProgressManager.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "vtkClientServerStream.h"
#include "vtkPVDataInformation.h"
#include "vtkPVSession.h"
#include "vtkSMSession.h"
#include "vtkSMSourceProxy.h"

#include <QMainWindow>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include <vector>

namespace
{

/// The sockets of the servers that the window is connected to; none with the built-in server.
std::vector<int> ServerSockets()
{
  std::vector<int> sockets;
  for (const pqServer* server :
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqServer*>())
  {
    const int socket = vtkShapeRemoteStop::GetSocket(
      server->session()->GetController(vtkPVSession::DATA_SERVER_ROOT));
    if (socket >= 0)
    {
      sockets.push_back(socket);
    }
  }
  return sockets;
}

/// Makes the next update of the VTK filter compute the outputs again, though no property has
/// changed. The proxy is not marked: a view that draws must not start the filter.
void MarkAlgorithm(vtkSMSourceProxy* filter)
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(filter) << "Modified"
         << vtkClientServerStream::End;
  filter->GetSession()->ExecuteStream(filter->GetLocation(), stream);
}

} // namespace

pqShapeStop::pqShapeStop(QObject* parent)
  : QObject(parent)
{
}

pqShapeStop::~pqShapeStop() = default;

void pqShapeStop::startup()
{
  pqApplicationCore* core = pqApplicationCore::instance();
  pqProgressManager* progress = core->getProgressManager();
  if (!progress || !pqShapeStopWatch::IsPossible())
  {
    return;
  }
  vtkShapeProgress::SetStopRequest([this] { return this->Wanted.load(); });
  this->connect(progress, &pqProgressManager::progress, this, &pqShapeStop::OnProgress);
  this->connect(progress, &pqProgressManager::progressEndEvent, this, &pqShapeStop::OnEnd);
  pqServerManagerModel* model = core->getServerManagerModel();
  this->connect(
    model, &pqServerManagerModel::modifiedStateChanged, this, &pqShapeStop::OnModifiedStateChanged);
  this->connect(model, &pqServerManagerModel::sourceRemoved, this,
    [this](pqPipelineSource* source) { this->Stopped.erase(source); });
}

void pqShapeStop::shutdown()
{
  this->Watch.reset();
  vtkShapeProgress::SetStopRequest({});
}

void pqShapeStop::OnProgress(const QString& text, int percent)
{
  // "Shape Hex Remesh: optimizing the hexahedra"; ParaView's own filters never begin so.
  if (!text.startsWith("Shape "))
  {
    return;
  }
  if (!this->Watch)
  {
    this->StartWatch();
  }
  if (!this->Wanted)
  {
    this->Label = text.section(':', 0, 0);
    this->Percent = percent;
  }
}

void pqShapeStop::StartWatch()
{
  QWidget* main = pqCoreUtilities::mainWidget();
  auto* button = main ? main->findChild<QToolButton*>("AbortButton") : nullptr;
  if (!button || !button->isVisible())
  {
    return;
  }
  this->Unreported.clear();
  pqApplicationCore::instance()->getProgressManager()->setEnableAbort(true);
  button->repaint();
  QWidget* window = button->nativeParentWidget();
  const QPoint corner = button->mapTo(window, QPoint(0, 0));
  const double scale = window->devicePixelRatioF();
  const QRect pixels(
    (scale * QPointF(corner)).toPoint(), (scale * QSizeF(button->size())).toSize());
  this->Watch =
    std::make_unique<pqShapeStopWatch>(static_cast<std::uint32_t>(window->winId()), pixels,
      [this, sockets = ServerSockets()]
      {
        this->Wanted = true;
        for (const int socket : sockets)
        {
          vtkShapeRemoteStop::Send(socket);
        }
      });
}

void pqShapeStop::OnEnd()
{
  if (!this->Watch)
  {
    return;
  }
  this->Watch.reset();
  pqApplicationCore::instance()->getProgressManager()->setEnableAbort(false);
  if (this->Wanted.exchange(false))
  {
    this->Unreported = this->Label;
    QTimer::singleShot(0, this, &pqShapeStop::Report);
  }
}

void pqShapeStop::Report()
{
  bool isFound = false;
  for (pqPipelineSource* source :
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineSource*>())
  {
    vtkSMSourceProxy* filter = source->getSourceProxy();
    // In the first Apply, the state changes only after the filter has run; until then a filter that
    // was stopped looks like one that was never applied (OnModifiedStateChanged).
    if (this->Unreported == filter->GetXMLLabel() &&
      source->modifiedState() == pqProxy::UNMODIFIED &&
      filter->GetDataInformation(0)->GetNumberOfPoints() == 0)
    {
      isFound = true;
      MarkAlgorithm(filter);
      this->Stopped.insert(source);
      // As before the first Apply: it shows the result, which has no representation yet.
      source->setModifiedState(pqProxy::UNINITIALIZED);
    }
  }
  auto* main = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
  if (isFound && main)
  {
    main->statusBar()->showMessage(
      QString("%1: stopped at %2 %. Its output is empty; Apply runs it again.")
        .arg(this->Unreported)
        .arg(this->Percent));
  }
  if (isFound)
  {
    this->Unreported.clear();
  }
}

void pqShapeStop::OnModifiedStateChanged(pqServerManagerModelItem* item)
{
  auto* source = qobject_cast<pqPipelineSource*>(item);
  if (!source || source->modifiedState() != pqProxy::UNMODIFIED)
  {
    return;
  }
  if (this->Stopped.erase(source) > 0)
  {
    source->getSourceProxy()->MarkDirty(source->getSourceProxy());
  }
  if (!this->Unreported.isEmpty())
  {
    QTimer::singleShot(0, this, &pqShapeStop::Report);
  }
}
