"""The subcommands of ``shapemap``: which filter each runs, what it is judged by, and what is shown."""
from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Optional

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkMultiBlockDataSet, vtkTable

from . import functions


@dataclass(frozen=True)
class Made:
    """What a subcommand makes of a subject: outputs by name, the main one first, and facts."""
    outputs: dict[str, vtkDataObject]
    facts: dict[str, Any]


@dataclass(frozen=True)
class Command:
    """A subcommand. `subject` is the input that gets the subjects; `names` are other names of inputs for the
    user; `measure` is the fact by which subjects are sorted, the largest first if `high`; `shown` is the array
    of the main output by which pictures are coloured, blue and red at the values `colours`."""
    help: str
    function: str
    subject: str
    example: str
    measure: str = ''
    high: bool = True
    shown: str = ''
    colours: tuple[float, float] = (0.0, 1.0)
    names: Mapping[str, str] = field(default_factory=dict)
    make: Optional[Callable[..., Made]] = None
    together: bool = False  # whether all subjects are blocks of one input, and give one result

    def run(self, inputs: Mapping[str, Any], options: Mapping[str, Any]) -> Made:
        if self.make is not None:
            return self.make(**inputs, **options)
        result = getattr(functions, self.function)(**inputs, **options)
        return Made(outputs_of(result), dict(result.facts))


def outputs_of(result: Any) -> dict[str, vtkDataObject]:
    """The outputs of a function that are not empty, by their names; blocks, as `output/block`, come last."""
    found = {name: getattr(result, name) for name in result.__dataclass_fields__ if name != 'facts'}
    whole = {name: data for name, data in found.items()
             if isinstance(data, vtkDataSet) and data.GetNumberOfPoints() > 0 or
             isinstance(data, vtkTable) and data.GetNumberOfRows() > 0}
    for name, data in found.items():
        for k in range(data.GetNumberOfBlocks() if isinstance(data, vtkMultiBlockDataSet) else 0):
            block = name + '/' + (data.GetMetaData(k).Get(vtkMultiBlockDataSet.NAME()) or str(k))
            whole[block + '-%d' % k if block in whole else block] = data.GetBlock(k)
    return whole


def _map(**given: Any) -> Made:
    """Both maps, with their distortion."""
    result = functions.correspondence(**given)
    to_template, from_template = (functions.map_quality(each) for each in (result.surface_b, result.surface_a))
    others = {name: data for name, data in outputs_of(result).items() if name not in ('surface_a', 'surface_b')}
    return Made({'subject': to_template.measured, 'template': from_template.measured, **others}, {
        **result.facts, **{'ToTemplate.' + name: fact for name, fact in to_template.facts.items()},
        **{'FromTemplate.' + name: fact for name, fact in from_template.facts.items()}})


COMMANDS = {
    'surfaces': Command(
        'extract the surfaces between the labels of images', 'label_surfaces', 'input',
        'surfaces segmentations regions', 'Intersections'),
    'hex': Command(
        'fill the solids inside closed surfaces with hexahedra', 'hex_remesh', 'surface',
        'hex surfaces meshes --method Grid --cells-on-longest-side 8 --format inp',
        'MinimumScaledJacobian', False, 'ScaledJacobian', (1.0, 0.0)),
    'map': Command(
        'map every surface onto a template, and the template onto every surface', 'correspondence', 'surface_b',
        'map surfaces maps --template template.vtp',
        'ToTemplate.MeanHencky', True, 'Hencky', names={'surface_a': 'template'}, make=_map),
    'transfer': Command(
        'carry the arrays of one shape onto all, through their maps', 'transfer_fields', 'input',
        'transfer maps fields --source template.vtp', 'OutsidePoints', True, 'OutsideDomain'),
    'solidify': Command(
        'repair surfaces until they bound solids', 'solidify', 'input',
        'solidify surfaces repaired', 'Defects', True, 'Origin', (0.0, 2.0)),
    'tetrahedralize': Command(
        'fill the solids inside closed surfaces with tetrahedra', 'tetrahedralize', 'input',
        'tetrahedralize surfaces tetrahedra', 'MinimumScaledJacobian', False),
    'quality': Command(
        'measure the distortion of maps', 'map_quality', 'input',
        'quality maps measured', 'MeanHencky', True, 'Hencky'),
    'collection': Command(
        'map many shapes onto one of them, and compare them', 'collection', 'shapes',
        'collection maps compared --template template.vtp --correspondence Maps', together=True),
    'atlas': Command(
        'compute the mean of many shapes, and the modes in which they vary', 'atlas', 'shapes',
        'atlas maps average --template template.vtp', together=True),
}
