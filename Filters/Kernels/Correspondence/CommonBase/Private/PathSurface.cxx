#include "Correspondence/CommonBase/Private/PathSurface.h"

namespace shape
{
FormValues AddForms(const FormValues& forms, const FormValues& others, int sign)
{
  FormValues sum;
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    sum[i] = static_cast<signed char>(forms[i] + sign * others[i]);
  }
  return sum;
}

PathSurface::PathSurface(const Surface& given)
  : Twins(given.Twins())
  , Out(given.Points().rows(), -1)
  , OnPath(given.Points().rows(), false)
{
  for (Eigen::Index i = 0; i < given.Points().rows(); ++i)
  {
    this->Positions.emplace_back(given.Points().row(i));
  }
  for (int t = 0; t < static_cast<int>(given.Triangles().rows()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Out[given.Triangles()(t, k)] = 3 * t + k;
      this->Corners.push_back(given.Triangles()(t, k));
    }
    this->Givens.push_back(t);
    this->Barycentrics.emplace_back(Eigen::Matrix3d::Identity());
  }
  this->Paths.assign(this->Corners.size(), -1);
  this->Forms.assign(this->Corners.size(), FormValues{});
}

int PathSurface::Find(int from, int to) const
{
  const int first = this->Out[from];
  int side = first;
  do
  {
    if (this->End(side) == to)
    {
      return side;
    }
    side = this->TurnLeft(side);
  } while (side != first);
  return -1;
}

void PathSurface::Link(int side, int twin)
{
  this->Twins[side] = twin;
  this->Twins[twin] = side;
}

// The triangles p q r and q p s become p m r, m q r, q m s, m p s.
int PathSurface::Split(int side, double share)
{
  const int point = this->PointCount(), twin = this->Twins[side];
  const int before = this->SideCount();
  const Eigen::RowVector3d position =
    (1.0 - share) * this->Positions[this->Begin(side)] + share * this->Positions[this->End(side)];
  this->Positions.push_back(position);
  this->Ends.push_back({ this->Begin(side), this->End(side) });
  this->Out.push_back(-1);
  this->OnPath.push_back(false);
  const FormValues along = this->Forms[side];
  for (const auto& [old, here] : { std::pair(side, share), std::pair(twin, 1.0 - share) })
  {
    // The half-edge from p stays in the old triangle, which becomes p m r. The new triangle is
    // m q r.
    const int next = NextHalfEdge(old), previous = PreviousHalfEdge(old);
    const int first = this->SideCount(), triangle = old / 3;
    const int q = this->Corners[next], r = this->Corners[previous];
    const Eigen::Matrix3d corners = this->Barycentrics[triangle];
    const Eigen::RowVector3d inserted =
      (1.0 - here) * corners.row(old % 3) + here * corners.row(next % 3);
    // The form is that of the whole edge before the new point for `side`, and 0 after it.
    const FormValues toNew = old == side ? along : FormValues{};
    const FormValues fromNew = old == side ? FormValues{} : AddForms({}, along, -1);
    const FormValues ofNext = this->Forms[next];
    const FormValues toApex = AddForms(fromNew, ofNext);
    this->Corners.insert(this->Corners.end(), { point, q, r });
    this->Twins.insert(this->Twins.end(), { -1, -1, -1 });
    this->Paths.insert(this->Paths.end(), { -1, this->Paths[next], -1 });
    this->Forms.insert(this->Forms.end(), { fromNew, ofNext, AddForms({}, toApex, -1) });
    this->Givens.push_back(this->Givens[triangle]);
    Eigen::Matrix3d second;
    second << inserted, corners.row(next % 3), corners.row(previous % 3);
    this->Barycentrics.push_back(second);
    this->Barycentrics[triangle].row(next % 3) = inserted;
    this->Link(first + 1, this->Twins[next]);
    this->Corners[next] = point;
    this->Paths[next] = -1;
    this->Forms[old] = toNew;
    this->Forms[next] = toApex;
    this->Link(next, first + 2);
    this->Out[q] = first + 1;
    this->Out[r] = previous;
    this->Out[point] = first;
  }
  this->Link(side, before + 3); // p m and m p
  this->Link(twin, before);     // q m and m q
  this->Out[this->Corners[side]] = side;
  this->Out[this->Corners[twin]] = twin;
  return point;
}

void PathSurface::SplitChords()
{
  for (int side = 0; side < this->SideCount(); ++side)
  {
    if (this->Paths[side] < 0 && this->OnPath[this->Begin(side)] && this->OnPath[this->End(side)])
    {
      this->Split(side, 0.5);
    }
  }
}

void PathSurface::Mark(int side, int path)
{
  this->Paths[side] = path;
  this->Paths[this->Twins[side]] = path;
  this->OnPath[this->Begin(side)] = true;
  this->OnPath[this->End(side)] = true;
}

void PathSurface::SetForm(int side, int form, signed char value)
{
  this->Forms[side][form] = value;
  this->Forms[this->Twins[side]][form] = static_cast<signed char>(-value);
}

Mesh PathSurface::ToMesh() const
{
  Mesh mesh{ Eigen::MatrixXd(this->Positions.size(), 3),
    Eigen::MatrixXi(this->Corners.size() / 3, 3) };
  for (int i = 0; i < this->PointCount(); ++i)
  {
    mesh.Points.row(i) = this->Positions[i];
  }
  for (int side = 0; side < this->SideCount(); ++side)
  {
    mesh.Triangles(side / 3, side % 3) = this->Corners[side];
  }
  return mesh;
}

} // namespace shape
