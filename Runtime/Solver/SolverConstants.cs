using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The constant buffer RillSolver of Solver.hlsl, member by member; lengths in d.</summary>
    [StructLayout(LayoutKind.Sequential)]
    struct SolverConstants
    {
        public float3 domainSize;
        public float timeStep;
        public float3 gravityStep;
        public float inverseTimeStep;
        public int3 cellCounts;
        public int cellTotal;
        public float3 cellSize;
        public float listRadius;
        public float3 inverseCellSize;
        public float listRadiusSquared;
        public int capacity;
        public int neighborCapacity;
        public int firstListParticles;
        public uint stepIndex;
        public float densityScale;
        public float selfDensity;
        public float gradientScale;
        public float epsilon;
        public float wallScale;
        public float relaxation;
        public float maxCorrection;
        public float allowedTension;
        public float artificialPressure;
        public float artificialPressureReference;
        public float smoothing;
        public float confinement;
        public float extrapolation;
        public float accelerationFraction;
        public float maxExtrapolation;
        public float unused;

        /// <summary>Longest correction of one pass, d: what keeps a pass from throwing particles past their neighbors.</summary>
        public const float MaxCorrection = 0.5f;

        /// <summary>Rate, 1/s, at which the velocity smoothing is quoted.</summary>
        public const float SmoothingRate = 60f;

        /// <summary>XSPH's c of a substep. All of it acts at once: what it takes is noise within a neighborhood, of which the mean that is extrapolated has none.</summary>
        public static float Smoothing(in StepInput input)
        {
            float dt = input.timeStep / input.settings.substeps;
            return math.min(input.material.velocitySmoothing * SmoothingRate * dt, 1f);
        }

        /// <param name="input">Valid settings and material; the time step is that of the whole step.</param>
        public static SolverConstants For(SolverLayout layout, in StepInput input, uint stepIndex)
        {
            float dt = input.timeStep / input.settings.substeps;
            FluidMaterial material = input.material;
            float atOnce = VelocityExtrapolation.FractionAtOnce(input);
            double pressureAt = LatticeKernels.Support * LatticeKernels.Support * (1.0 - (double)material.artificialPressureDistance * material.artificialPressureDistance);
            return new SolverConstants
            {
                domainSize = layout.DomainSize,
                timeStep = dt,
                gravityStep = input.gravity / layout.Spacing * (dt * dt * atOnce),
                inverseTimeStep = 1f / dt,
                cellCounts = layout.CellCounts,
                cellTotal = layout.CellTotal,
                cellSize = layout.CellSize,
                listRadius = layout.ListRadius,
                inverseCellSize = 1f / layout.CellSize,
                listRadiusSquared = layout.ListRadius * layout.ListRadius,
                capacity = layout.Capacity,
                neighborCapacity = layout.NeighborCapacity,
                firstListParticles = layout.FirstListParticles,
                stepIndex = stepIndex,
                densityScale = (float)(LatticeKernels.Poly6Scale / LatticeKernels.RestDensity),
                selfDensity = (float)(LatticeKernels.Poly6(0.0) / LatticeKernels.RestDensity),
                gradientScale = (float)(LatticeKernels.SpikyGradientScale / LatticeKernels.RestDensity),
                epsilon = (float)(input.settings.softness * LatticeKernels.ReferenceSquares),
                wallScale = (float)LatticeKernels.WallScale,
                relaxation = input.settings.relaxation,
                maxCorrection = MaxCorrection,
                allowedTension = material.allowedTension,
                artificialPressure = (float)(material.artificialPressure / LatticeKernels.ReferenceSquares),
                artificialPressureReference = (float)(1.0 / (pressureAt * pressureAt * pressureAt)),
                smoothing = Smoothing(input),
                confinement = material.vorticity / layout.Spacing * atOnce,
                extrapolation = VelocityExtrapolation.WeightFor(input),
                accelerationFraction = atOnce,
                maxExtrapolation = VelocityExtrapolation.Longest(input, layout.Spacing),
            };
        }
    }
}
