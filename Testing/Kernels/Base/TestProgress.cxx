#include "Base/Errors.h"
#include "Base/Progress.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace
{

using Reports = std::vector<std::pair<double, std::string>>;

shape::Progress RecordIn(Reports& reports)
{
  return shape::Progress(
    [&reports](double fraction, const char* stage)
    {
      reports.emplace_back(fraction, stage);
      return true;
    });
}

TEST(Progress, PartsOfPartsCoverTheirRange)
{
  Reports reports;
  const shape::Progress part = RecordIn(reports).Part(0.25, 0.75).Part(0.5, 1.0);
  part(0.0);
  part(1.0);
  EXPECT_EQ(reports, (Reports{ { 0.5, "" }, { 0.75, "" } }));
}

TEST(Progress, APartHasTheStageOfTheWholeUnlessItNamesItsOwn)
{
  Reports reports;
  const shape::Progress whole = RecordIn(reports).Part(0.0, 1.0, "cutting");
  whole(0.0);
  whole.Part(0.0, 0.5)(0.0);
  whole.Part(0.5, 1.0, "sewing").Part(0.0, 1.0)(0.0);
  whole(1.0);
  EXPECT_EQ(reports,
    (Reports{ { 0.0, "cutting" }, { 0.0, "cutting" }, { 0.5, "sewing" }, { 1.0, "cutting" } }));
}

TEST(Progress, ACallbackThatReturnsFalseAborts)
{
  const shape::Progress progress([](double fraction) { return fraction < 0.5; });
  EXPECT_NO_THROW(progress(0.4));
  EXPECT_THROW(progress.Part(0.0, 0.6, "cutting")(1.0), shape::Aborted);
}

TEST(Progress, WithoutACallbackAReportDoesNothing)
{
  EXPECT_NO_THROW(shape::Progress().Part(0.0, 0.5, "cutting")(1.0));
}

} // namespace
