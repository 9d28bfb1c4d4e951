"""Charts of tables, drawn by ParaView."""
import collections

from paraview import simple

# A line of a chart: a column of the table, its label, its colour (None: the next of COLOURS), and whether it
# is dashed, without markers.
Series = collections.namedtuple('Series', 'name label colour dashed', defaults=(None, False))

# Of Okabe and Ito: colour-blind readers can tell them apart.
COLOURS = [[0.0, 0.0, 0.0], [0.90, 0.62, 0.0], [0.34, 0.71, 0.91],
           [0.0, 0.62, 0.45], [0.84, 0.37, 0.0], [0.8, 0.47, 0.65]]

TRADE = (Series('featureRMSE', 'features', [0.95, 0.55, 0.25]),
         Series('boundaryRMSE', 'boundary', [0.22, 0.50, 0.66]),
         Series('featuresAlone', 'features, without them in the system', [0.98, 0.80, 0.62], True),
         Series('boundaryAlone', 'boundary, without features', [0.66, 0.80, 0.88], True))


def lines(path, title, columns, series, bottom, left, legend=None):
    """Lines over the first of the columns (a dictionary from names to numbers), both axes logarithmic.

    bottom, left: the titles of the axes. legend: its position in pixels; without, top left.
    """
    table = simple.ProgrammableSource(OutputDataSetType='vtkTable')
    table.Script = 'import numpy\nfor name, values in %r.items():\n' % columns + (
        '    output.RowData.append(numpy.array(values, float), name)\n')
    view = simple.CreateView('XYChartView')
    view.ViewSize = [1000, 700]
    display = simple.Show(table, view)
    display.UseIndexForXAxis, display.XArrayName = 0, next(iter(columns))

    def by_name(value):
        return [text for one in series for text in (one.name, value(one))]

    display.SeriesVisibility = [one.name for one in series]
    display.SeriesLabel = by_name(lambda one: one.label)
    display.SeriesColor = [text for one, colour in zip(series, COLOURS)
                           for text in [one.name] + [str(value) for value in one.colour or colour]]
    display.SeriesLineThickness = by_name(lambda one: '4')
    display.SeriesLineStyle = by_name(lambda one: '2' if one.dashed else '1')
    display.SeriesMarkerStyle = by_name(lambda one: '0' if one.dashed else '4')
    display.SeriesMarkerSize = by_name(lambda one: '12')
    view.ChartTitle, view.ChartTitleFontSize, view.LegendFontSize = title, 24, 17
    view.LegendLocation = 'Custom' if legend else 'TopLeft'
    if legend:
        view.LegendPosition = legend
    view.LeftAxisTitle, view.BottomAxisTitle = left, bottom
    view.LeftAxisTitleFontSize = view.BottomAxisTitleFontSize = 20
    view.LeftAxisLabelFontSize = view.BottomAxisLabelFontSize = 17
    view.LeftAxisLogScale = view.BottomAxisLogScale = 1
    simple.SaveScreenshot(path, view)
    simple.Delete(view)


def trade(path, title, rows):
    """The errors of features and boundary over the features' weight; row 0 is without features."""
    columns = {'weight': [row['weight'] for row in rows[1:]]}
    for key, alone in (('featureRMSE', 'featuresAlone'), ('boundaryRMSE', 'boundaryAlone')):
        columns[key] = [row[key] for row in rows[1:]]
        columns[alone] = [rows[0][key]] * (len(rows) - 1)
    lines(path, title, columns, TRADE, 'weight of the features', "RMSE, % of the target's longest side",
          legend=[120, 150])
