"""Points and an outline in the plane, triangulated by the kernel and by vtkDelaunay2D: ours finds every
triangle that Euler's formula asks for. VTK's misses some and ends with a segmentation fault on 20,000
clustered points, of which its row is missing.

    python3 Testing/Benchmarks/PlanarDelaunay.py
"""
import sweep

INPUTS = (('random', 20000), ('grid', 20000), ('circle', 2000), ('clustered', 1000),
          ('clustered', 20000))


def main():
    options = sweep.parser(__doc__, models=False).parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('points:<16', 'method:<9', 'wanted:8d', 'triangles:9d', 'milliseconds:12.1f')
    for kind, count in INPUTS:
        found = program.run('planar_delaunay', kind, count)
        subject = '%s %d' % (kind, count)
        for row in found.rows:
            table.print(dict(row, points=subject))
        own = found.rows[0]
        claims.check(subject, 'triangles', own['triangles'], own['triangles'] == own['wanted'],
                     str(own['wanted']))
    claims.finish()


if __name__ == '__main__':
    main()
