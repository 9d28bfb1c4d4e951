#pragma once

#include <QObject>
#include <QSet>

class pqPipelineSource;
class pqServerManagerModelItem;

/**
 * Shows what the first Apply of a filter made, as the element FirstApply among the hints of the
 * filter says. Later, the view is the user's: nothing is changed by another Apply, by undo and
 * redo, by a script, or when a state is loaded. These are its elements:
 *
 * <Color port="0" array="Name" association="CELLS"/>: the colours of an output. component="1" is
 * the second component, direct="1" takes the values as colours, and solid="1 0.6 0.1" is one colour
 * without an array. like="Source" takes the array that colours this input in the view. Without an
 * array, it is the one that ParaView has chosen: the active scalars.
 *
 * <Beside port="1" other="0"/>: an output that overlaps another one is drawn beside it. Only its
 * representation is translated, and only if neither of the two was translated before. The name of
 * an input, port="SurfaceB", means what is connected to it.
 *
 * <Hide input="Input"/>: an input that disappears. ParaView hides all inputs or none; this is for
 * <Visibility replace_input="0"/>.
 *
 * The camera is reset if an output lies elsewhere than the inputs, and is not well in the view. If
 * the filter failed, the first input is shown again, and the next Apply counts as the first.
 */
class pqShapeFirstApply : public QObject
{
  Q_OBJECT

public:
  explicit pqShapeFirstApply(QObject* parent = nullptr)
    : QObject(parent)
  {
  }
  ~pqShapeFirstApply() override = default;

  void startup();
  void shutdown();

private Q_SLOTS:
  void OnStateChanged(pqServerManagerModelItem* item);

private:
  Q_DISABLE_COPY(pqShapeFirstApply)

  QSet<QObject*> New;    ///< filters that have no result yet
  QSet<QObject*> Failed; ///< those of them that were applied
};
