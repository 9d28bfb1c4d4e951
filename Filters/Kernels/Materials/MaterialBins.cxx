#include "Materials/MaterialBins.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cmath>

namespace shape
{

MaterialBins::MaterialBins(double minimum, double maximum, int count)
  : Minimum(minimum)
  , Scale(maximum > minimum ? count / std::log(maximum / minimum) : 0.0)
{
  RequireOption(count >= 1, "Materials", count, "1 or more");
  this->Sums.setZero(4, count);
}

int MaterialBins::FindBin(double modulus) const
{
  const double position = this->Scale * std::log(modulus / this->Minimum);
  return std::clamp(static_cast<int>(position), 0, static_cast<int>(this->Sums.cols()) - 1);
}

void MaterialBins::Add(const Eigen::VectorXd& modulus, const Eigen::VectorXd& density,
  const Eigen::VectorXd& volumes, const Eigen::VectorXi& own)
{
  for (Eigen::Index cell = 0; cell < modulus.size(); ++cell)
  {
    if (own.size() == 0 || own(cell) != 0)
    {
      const double volume = volumes(cell);
      this->Sums.col(this->FindBin(modulus(cell))) +=
        Eigen::Vector4d(volume * modulus(cell), volume * density(cell), volume, 1.0);
    }
  }
}

Materials FindMaterials(const MaterialBins& bins)
{
  const Eigen::MatrixXd& sums = bins.Sums;
  Materials materials;
  materials.OfBin.setConstant(sums.cols(), -1);
  const Eigen::Index count = (sums.row(3).array() > 0.0).count();
  for (Eigen::VectorXd* column :
    { &materials.Modulus, &materials.Density, &materials.Volume, &materials.Cells })
  {
    column->resize(count);
  }
  int next = 0;
  for (Eigen::Index bin = 0; bin < sums.cols(); ++bin)
  {
    if (sums(3, bin) > 0.0)
    {
      materials.Modulus(next) = sums(0, bin) / sums(2, bin);
      materials.Density(next) = sums(1, bin) / sums(2, bin);
      materials.Volume(next) = sums(2, bin);
      materials.Cells(next) = sums(3, bin);
      materials.OfBin(bin) = next++;
    }
  }
  return materials;
}

} // namespace shape
