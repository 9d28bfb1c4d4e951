#pragma once

#include "pqPropertyWidgetInterface.h"

#include <QObject>

/**
 * The rows of the properties panel of ShapeMap's filters and sources. They are ParaView's own rows,
 * with these additions:
 *
 * - An enumeration shows its values as words: "Reversible Harmonic" for ReversibleHarmonic. The
 *   tooltip of a word is the attribute info of its Entry in the XML. Scripts and traces keep the
 *   values.
 * - A number whose value 0 has a meaning of its own shows this meaning while it is 0. The XML
 *   declares it: <Hints><Zero text="automatic"/></Hints>.
 * - A number that is the size of hexahedra says about how many they will be, if the hint
 *   <CellCount size="SurfaceSize" layers="PaddingLayers"/> names the property with volume, area and
 *   longest edge of the solid. on_longest_edge="1": it is the number of cells on that edge instead.
 * - A list of numbers has a slider for each array of an input (pqShapeSliders), with the hint
 *   <Sliders input="Atlas" array="Mode"/>.
 * - A selection input says when there is no selection to copy.
 */
class pqShapeRows
  : public QObject
  , public pqPropertyWidgetInterface
{
  Q_OBJECT
  Q_INTERFACES(pqPropertyWidgetInterface)

public:
  explicit pqShapeRows(QObject* parent = nullptr)
    : QObject(parent)
  {
  }

  void startup();
  void shutdown();

  pqPropertyWidget* createWidgetForProperty(
    vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent) override;
};
