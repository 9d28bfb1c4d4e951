#pragma once

#include "pqShapeLandmarkFiles.h"

#include <QTableWidget>

#include <functional>

/// A table with the names and the positions of landmarks, which can be edited.
class pqShapeLandmarkList : public QTableWidget
{
public:
  using Table = pqShapeLandmarkTable;

  /// edited: called with the new landmarks when a cell was edited.
  pqShapeLandmarkList(const std::function<void(const Table&)>& edited, QWidget* parent);

  void Show(const Table& landmarks, bool hasNames, bool hasTarget);

private:
  void OnEdited(int row, int column);

  std::function<void(const Table&)> Edited;
  Table Shown;
};
