#pragma once

#include <QObject>
#include <QSet>

class pqPipelineFilter;
class pqServerManagerModelItem;
class pqView;

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
 * <Points port="0"/>: the points of an output are drawn as balls.
 *
 * <Beside port="1" other="0"/>: an output that overlaps another one is drawn beside it. Only its
 * representation is translated, and only if neither of the two was translated before. The name of
 * an input, port="SurfaceB", means what is connected to it. <Off port="0" other="1"/> draws a part
 * off the surface from which it was cut. <Like port="1" other="SurfaceB"/> draws an output where
 * another one is drawn; this is also done for every filter with one input, ParaView's as well.
 *
 * <Hide input="Input"/>: an input that disappears, and, with all="1", all outputs of the filter
 * that makes it. ParaView hides all inputs or none; this is for <Visibility replace_input="0"/>.
 *
 * <Camera from="1 0.6 1"/>: the outputs are seen from this direction if the view still has the
 * direction of a new view.
 *
 * The camera is reset if an output is not well in the view, and lies elsewhere than the inputs or
 * is seen from the direction of a new view. If the filter failed, the first input is shown again,
 * and the next Apply counts as the first.
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

  bool HasRun(pqPipelineFilter* filter, pqView* view);

  QSet<QObject*> New;    ///< filters that have no result yet
  QSet<QObject*> Failed; ///< those of them that were applied
};
