"""Charts of tables, drawn by ParaView."""
from paraview import simple


SERIES = (('featureRMSE', 'features', [0.95, 0.55, 0.25]),
          ('boundaryRMSE', 'boundary', [0.22, 0.50, 0.66]),
          ('featuresAlone', 'features, without them in the system', [0.98, 0.80, 0.62]),
          ('boundaryAlone', 'boundary, without features', [0.66, 0.80, 0.88]))


def trade(path, title, rows):
    """The errors of features and boundary over the features' weight; row 0 is without features."""
    table = simple.ProgrammableSource(OutputDataSetType='vtkTable')
    columns = {'weight': [row['weight'] for row in rows[1:]]}
    for key, alone in (('featureRMSE', 'featuresAlone'), ('boundaryRMSE', 'boundaryAlone')):
        columns[key] = [row[key] for row in rows[1:]]
        columns[alone] = [rows[0][key]] * (len(rows) - 1)
    table.Script = 'import numpy\nfor name, values in %r.items():\n' % columns + (
        '    output.RowData.append(numpy.array(values, float), name)\n')
    view = simple.CreateView('XYChartView')
    view.ViewSize = [1000, 700]
    display = simple.Show(table, view)
    display.UseIndexForXAxis, display.XArrayName = 0, 'weight'
    names = [name for name, _, _ in SERIES]
    display.SeriesVisibility = names
    display.SeriesLabel = [text for name, label, _ in SERIES for text in (name, label)]
    display.SeriesColor = [text for name, _, colour in SERIES
                           for text in [name] + [str(value) for value in colour]]
    display.SeriesLineThickness = [text for name in names for text in (name, '4')]
    display.SeriesLineStyle = [text for name in names
                               for text in (name, '2' if 'Alone' in name else '1')]
    display.SeriesMarkerStyle = [text for name in names
                                 for text in (name, '0' if 'Alone' in name else '4')]
    display.SeriesMarkerSize = [text for name in names for text in (name, '12')]
    view.ChartTitle, view.ChartTitleFontSize, view.LegendFontSize = title, 24, 17
    view.LegendLocation, view.LegendPosition = 'Custom', [120, 150]
    view.LeftAxisTitle = "RMSE, % of the target's longest side"
    view.BottomAxisTitle = 'weight of the features'
    view.LeftAxisTitleFontSize = view.BottomAxisTitleFontSize = 20
    view.LeftAxisLabelFontSize = view.BottomAxisLabelFontSize = 17
    view.LeftAxisLogScale = view.BottomAxisLogScale = 1
    simple.SaveScreenshot(path, view)
    simple.Delete(view)
