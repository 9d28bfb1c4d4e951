#!/usr/bin/env python3
"""Checks the names in the C++ of Filters/ and Plugin/: Utilities/lint.py

Universal Ctags reads the sources, in a second. CamelCase: types, functions, members, enumerators. camelBack:
parameters and local variables. lower_case: namespaces. Names of VTK and Qt classes begin with vtkShape and pqShape."""
import json
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
CAMEL, BACK, LOWER = (re.compile(pattern + '$') for pattern in ('[A-Z][A-Za-z0-9]*', '[a-z][A-Za-z0-9]*', '[a-z0-9_]+'))
RULES = {'class': CAMEL, 'struct': CAMEL, 'enum': CAMEL, 'enumerator': CAMEL, 'function': CAMEL, 'prototype': CAMEL,
         'member': CAMEL, 'parameter': BACK, 'local': BACK, 'namespace': LOWER}
# Classes of VTK and Qt, macros, operators, and what Ctags makes up.
OTHERS = re.compile(r'(vtk|pq)Shape\w*|HWY_\w+|__anon\w*|~\w+|operator\b.*|&|Q_\w+|VTK\w+')
# What Qt and ParaView, Eigen, nanoflann, TetGen, OpenCASCADE and the standard library call by these names, and functions that
# Highway's macros declare.
GIVEN = {'startup', 'shutdown', 'apply', 'reset', 'select', 'deselect', 'setView', 'eventFilter', 'event',
         'createWidgetForProperty',
         'intersectVolume', 'intersectObject', 'minimumOnVolume', 'minimumOnObject', 'worstDist', 'full', 'addPoint',
         'terminatetetgen', 'send', 'what', 'Index', 'PotentialsFor', 'GradientsFor', 'FloatProducts', 'solve',
         'DoubleProducts', 'Eigen', 'abs', 'sqrt'}
# The types of parameters without a name, which Ctags takes for their names.
GIVEN |= {'size_t', 'string_view'}
# These macros declare members or only mark them.
MACROS = ('vtkShapeOption', 'vtkShapeOptionOf', 'vtkShapeVectorOptionOf', 'vtkShapeEnumOption', 'vtkShapeEnumOptionAs', 'vtkShapeEnumOptionOf',
          'vtkTypeMacro', 'vtkSetMacro', 'vtkGetMacro', 'vtkBooleanMacro', 'vtkSetVector3Macro', 'vtkGetVector3Macro',
          'vtkStandardNewMacro', 'vtkSetStdStringFromCharMacro', 'vtkGetCharFromStdStringMacro', 'vtkCxxSetObjectMacro', 'vtkErrorMacro', 'vtkWarningMacro',
          'Handle', 'DEFINE_STANDARD_RTTI_INLINE')


def tags():
    command = ['ctags', '--languages=C++', '--langmap=C++:.cxx.h', '--kinds-C++=cdefgmnpsuvlz', '--fields=+nKS', '-R',
               '-f', '-', '--output-format=json', *('-I' + macro + '+' for macro in MACROS), 'Filters', 'Plugin']
    for line in subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines():
        tag = json.loads(line)
        if tag['_type'] == 'tag':
            yield tag


def main():
    checked = 0
    faults = []
    for tag in tags():
        rule, name = RULES.get(tag['kind']), tag['name']
        if rule is None or OTHERS.fullmatch(name) or name in GIVEN:
            continue
        checked += 1
        if not rule.match(name):
            faults.append('%s:%d: the %s %s' % (tag['path'], tag['line'], tag['kind'], name))
    print('\n'.join(faults))
    print('%d names, %d faults' % (checked, len(faults)))
    assert checked > 10000, 'Ctags found too few names'
    sys.exit(1 if faults else 0)


main()
