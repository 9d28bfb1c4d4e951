"""Progress rises from 0 to 1 and says what is done; an abort stops the filter, leaves its outputs empty without an error,
and the filter can be used again."""
import filters
import shapetesting

for name in filters.names():
    algorithm = filters.with_good_inputs(name)
    seen = []
    stages = set()

    def record(*_):
        seen.append(algorithm.GetProgress())
        label, _, stage = (algorithm.GetProgressText() or '').partition(': ')
        if 0.0 < seen[-1] < 1.0:
            assert label == algorithm.GetLabel(), '%s shows "%s"' % (name, label)
            stages.add(stage)

    tag = algorithm.AddObserver('ProgressEvent', record)
    assert not shapetesting.run(algorithm)
    algorithm.RemoveObserver(tag)
    for stage in stages - {''}:
        assert stage[0].islower() and stage[-1].isalpha() and len(stage) <= 60, '%s: "%s"' % (name, stage)
    assert stages != {''}, name + ' never says what it does'
    assert seen == sorted(seen), name + ': progress falls'
    # The executive itself ends every run at 1: the filter must have said so before.
    assert seen[-2:] == [1.0, 1.0], '%s: progress ends at %s' % (name, seen[-3:])
    inner = [value for value in seen if 0.0 < value < 1.0]
    assert len(inner) >= 3, '%s reports only %s' % (name, seen)
    size = filters.size_of(algorithm.GetOutputDataObject(0))
    assert size > 0, name + ' made nothing'

    # Abort at the third report of the first run of a new filter, which has nothing to take up again: no more
    # than a few may follow.
    algorithm = filters.with_good_inputs(name)
    reports = []

    def abort(*_):
        reports.append(algorithm.GetProgress())
        if len(reports) == 3:
            algorithm.SetAbortExecuteAndUpdateTime()

    tag = algorithm.AddObserver('ProgressEvent', abort)
    messages = shapetesting.run(algorithm)
    algorithm.RemoveObserver(tag)
    assert not messages, '%s calls an abort an error: %s' % (name, messages)
    assert len(reports) <= 5 and reports[-2] < 1.0, '%s went on after an abort: %s' % (name, reports)
    for port in range(algorithm.GetNumberOfOutputPorts()):
        output = algorithm.GetOutputDataObject(port)
        assert filters.size_of(output) == 0, '%s: output %d is not empty after an abort' % (name, port)

    algorithm.SetAbortExecute(0)
    assert not shapetesting.run(algorithm)
    assert filters.size_of(algorithm.GetOutputDataObject(0)) == size, \
        name + ' does not work after an abort'
    print(name, 'reports', len(seen), 'times,', len(stages - {''}), 'stages, aborts and works again')
