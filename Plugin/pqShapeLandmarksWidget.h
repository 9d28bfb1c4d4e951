#pragma once

#include "pqShapeInteractiveWidget.h"
#include "pqShapeLandmarkFiles.h"
#include "pqShapeLandmarkList.h"
#include "pqShapeLandmarkMarks.h"

#include <Eigen/Geometry>

#include <map>
#include <memory>
#include <optional>

class QPushButton;

/**
 * Picks points on a surface, or pairs of points on two surfaces, and moves them.
 *
 * While the button Pick is checked, a click on the surface appends a point, and a drag rotates the
 * camera as usual. With two surfaces, two clicks make a pair, in any order. If both surfaces are
 * under the mouse, the click counts for the nearest one. Escape cancels the open half of a pair. A
 * second Escape ends picking. Points can be dragged over their surface. Delete removes the point,
 * or the pair, under the mouse. A table shows names and positions, which can be edited there.
 *
 * The points are shown in every view that shows one of the surfaces, and follow its translation,
 * rotation and scale in the view. In the active view they are always shown. There, a hidden surface
 * can be picked if no surface of the filter is visible.
 *
 * Functions of the property group (panel_widget="ShapeLandmarks"): Surface and Points (3 numbers
 * for each point). Optional functions: TargetSurface and TargetPoints (the other half of each
 * pair), Names (of points or pairs), and Dragging. Files can be loaded and saved if there are
 * Names.
 */
class pqShapeLandmarksWidget : public pqShapeInteractiveWidget
{
  Q_OBJECT
  typedef pqShapeInteractiveWidget Superclass;

public:
  pqShapeLandmarksWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqShapeLandmarksWidget() override = default;

  void deselect() override;

protected:
  int FindPart(const Eigen::Vector2d& pixel) override;
  void Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control) override;
  bool Drag(const Eigen::Vector2d& pixel) override;
  bool PressKey(const std::string& key) override;
  bool TurnWheel(int, bool) override { return false; }
  void Draw() override;
  bool Click(const Eigen::Vector2d& pixel) override;
  std::vector<pqView*> FindViews() const override;
  bool UpdateSurface() override;

private Q_SLOTS:
  void UpdateTable();

private:
  Q_DISABLE_COPY(pqShapeLandmarksWidget)

  using Positions = std::vector<Eigen::Vector3d>;
  /// A position on one of the surfaces: 0 is Surface, 1 is TargetSurface.
  struct Landmark
  {
    int Side;
    Eigen::Vector3d Position;
  };
  void AddButtons();
  bool HasTarget() const; ///< whether a second surface is connected
  int CountSides() const { return this->HasTarget() ? 2 : 1; }
  const pqShapeSurface& GetSide(int side) const;
  vtkSMProperty* GetInput(int side) const;
  Positions GetPositions(int side) const;
  void SetPositions(int side, const Positions& positions);
  std::vector<std::string> GetNames() const;
  void SetNames(const std::vector<std::string>& names);
  /// Whether the drawn view shows this surface, and the transformation with which it does.
  bool IsShown(int side) const;
  Eigen::Affine3d GetTransform(int side) const;
  bool FindLandmark(const Eigen::Vector2d& pixel, Landmark& landmark) const;
  void Append(const Landmark& landmark);
  void Remove(std::size_t index);
  pqShapeLandmarkTable GetTable() const;
  void SetTable(const pqShapeLandmarkTable& landmarks);
  void Load();
  void Save();

  pqShapeSurface Target;
  QPushButton* Pick;
  pqShapeLandmarkList* Table;
  std::optional<Landmark> Half; ///< the open half of a pair
  std::map<const pqShapeOverlay*, std::unique_ptr<pqShapeLandmarkMarks>> Marks;
  std::size_t GrabbedIndex = 0;
  int GrabbedSide = 0;
  Eigen::Vector2d Offset = Eigen::Vector2d::Zero();
};
