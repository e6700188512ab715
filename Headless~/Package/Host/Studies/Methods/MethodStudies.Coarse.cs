using System.Collections.Generic;
using System.Linq;

namespace Host.Studies.Methods
{
    // Parameters of the two-level correction and of what surrounds the passes.
    static partial class MethodStudies
    {
        static IEnumerable<MethodStudy> Coarse(bool quick)
        {
            yield return new MethodStudy("cell-size", "Coarse cells", "side H of a coarse cell (spacings)",
                (quick ? new[] { 6f } : new[] { 3f, 4f, 5f, 6f, 8f })
                    .Select(size => With("cell size", size, new CoarseVariation { CellSize = size })).ToArray(), Alike: true);
            yield return new MethodStudy("cycles", "V-cycles and warm start", "V-cycles a solve", Cycles(quick).ToArray(), Alike: true);
            yield return new MethodStudy("screening", "Screening length", "length l (spacings); none drawn at 1000",
                (quick ? new[] { 30f } : new[] { 10f, 30f, 100f, 300f, float.PositiveInfinity })
                .Select(length => With("screening length", float.IsInfinity(length) ? 1000 : length,
                    new CoarseVariation { ScreeningLength = length }) with { Label = float.IsInfinity(length) ? "none" : null }).ToArray(),
                    true, true);
            yield return new MethodStudy("surface", "Distance of the free surface", "0 off; 1 on",
                new[] { false, true }.Where(on => !quick || !on)
                    .Select(on => With("surface distance", on ? 1 : 0, new CoarseVariation { SurfaceDistance = on }) with { Label = on
                    ? "on" : "off" }).ToArray(), Alike: true);
            yield return new MethodStudy("capacity", "Entries of a neighbor list", "neighbor capacity",
                (quick ? new[] { 64 } : new[] { 48, 64, 96, 128 })
                    .SelectMany(capacity => Both("capacity", capacity).Select(variant => variant with { NeighborCapacity = capacity }))
                    .ToArray());
            yield return new MethodStudy("viscosity", "XSPH", "XSPH c",
                (quick ? new[] { 0f } : new[] { 0f, 0.003f, 0.01f, 0.03f, 0.1f })
                    .SelectMany(smoothing => Both("XSPH", smoothing).Select(variant => variant with { Smoothing = smoothing })).ToArray());
        }

        static MethodVariant With(string series, double value, CoarseVariation variation) =>
            new() { Series = series + ", two-level, k 2", Value = value, Iterations = 2, TwoLevel = true, Coarse = variation };

        static IEnumerable<MethodVariant> Both(string series, double value)
        {
            yield return With(series, value, new CoarseVariation());
            yield return new MethodVariant { Series = series + ", Jacobi, k 4", Value = value, Iterations = 4 };
        }

        static IEnumerable<MethodVariant> Cycles(bool quick)
        {
            foreach (int cycles in quick ? new[] { 2 } : new[] { 1, 2, 3, 6 })
            {
                yield return With("warm start", cycles, new CoarseVariation { Cycles = cycles });
                yield return With("cold start", cycles, new CoarseVariation { Cycles = cycles, WarmStart = false });
            }
        }
    }
}
