using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>Constants of a substep that every kernel of the solver reads; lengths in d.</summary>
    [GenerateHlsl("Solver", ConstantBuffer = "RillSolver")]
    [StructLayout(LayoutKind.Sequential)]
    struct SolverConstants
    {
        /// <summary>d</summary>
        public float3 domainSize;
        /// <summary>s, one substep</summary>
        public float timeStep;
        /// <summary>g dt² times _AccelerationFraction, d</summary>
        public float3 gravityStep;
        /// <summary>1/s</summary>
        public float inverseTimeStep;
        /// <summary>cells along x, y, z</summary>
        public int3 cellCounts;
        /// <summary>their product</summary>
        public int cellTotal;
        /// <summary>d</summary>
        public float3 cellSize;
        /// <summary>d, support times margin</summary>
        public float listRadius;
        /// <summary>1/d</summary>
        public float3 inverseCellSize;
        /// <summary>d²</summary>
        public float listRadiusSquared;
        /// <summary>particles</summary>
        public int capacity;
        /// <summary>entries of a particle's neighbor list</summary>
        public int neighborCapacity;
        /// <summary>particles whose entries lie in the first list buffer; a multiple of kParticlesPerListBlock</summary>
        public int firstListParticles;
        /// <summary>since the last reset</summary>
        public uint stepIndex;
        /// <summary>poly6 normalization / rest density</summary>
        public float densityScale;
        /// <summary>W(0) / rest density</summary>
        public float selfDensity;
        /// <summary>spiky gradient normalization / rest density, negative</summary>
        public float gradientScale;
        /// <summary>constraint force mixing, 1/d²</summary>
        public float epsilon;
        /// <summary>makes a lattice particle d/2 from a wall see C = 0</summary>
        public float wallScale;
        /// <summary>ω</summary>
        public float relaxation;
        /// <summary>longest correction of one pass, d</summary>
        public float maxCorrection;
        /// <summary>negative density error that is still corrected, at least 0</summary>
        public float allowedTension;
        /// <summary>k of s_corr, d²</summary>
        public float artificialPressure;
        /// <summary>1 / W(dq), without W's normalization</summary>
        public float artificialPressureReference;
        /// <summary>XSPH c of this substep</summary>
        public float smoothing;
        /// <summary>vorticity confinement, d/s</summary>
        public float confinement;
        /// <summary>fraction of the last change of velocity that is added once more, see <see cref="VelocityExtrapolation"/>; 0 for none</summary>
        public float extrapolation;
        /// <summary>1 less it: of an acceleration that lasts, what acts at once</summary>
        public float accelerationFraction;
        /// <summary>change of velocity in a substep up to which it is, d/s</summary>
        public float maxExtrapolation;
        /// <summary>bit 2 a + b: along axis a the lower (b 0) or upper end of the box is open to the coarse
        /// grid; from kTiedFaces on the same where a neighbor's coarse solution is known</summary>
        public uint openFaces;

        /// <summary>Longest correction of one pass, d: what keeps a pass from throwing particles past their neighbors.</summary>
        public const float MaxCorrection = 0.5f;

        /// <summary>Rate, 1/s, at which the velocity smoothing is quoted.</summary>
        public const float SmoothingRate = 60f;

        /// <summary>XSPH's c of a substep. All of it acts at once: what it takes is noise within a neighborhood, of which the mean that is
        /// extrapolated has none.</summary>
        public static float Smoothing(in StepInput input)
        {
            float dt = input.SubstepTime;
            return math.min(input.material.velocitySmoothing * SmoothingRate * dt, 1f);
        }

        /// <param name="input">Valid settings and material; the time step is that of the whole step.</param>
        public static SolverConstants For(SolverLayout layout, in StepInput input, uint stepIndex)
        {
            float dt = input.SubstepTime;
            FluidMaterial material = input.material;
            float atOnce = VelocityExtrapolation.FractionAtOnce(input);
            double pressureAt = LatticeKernels.Support * LatticeKernels.Support
                * (1.0 - (double)material.artificialPressureDistance * material.artificialPressureDistance);
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
                allowedTension = SurfaceTension.IsNeeded(input) ? 0f : material.allowedTension,
                artificialPressure = (float)(material.artificialPressure / LatticeKernels.ReferenceSquares),
                artificialPressureReference = (float)(1.0 / (pressureAt * pressureAt * pressureAt)),
                smoothing = Smoothing(input),
                confinement = material.vorticity / layout.Spacing * atOnce,
                extrapolation = VelocityExtrapolation.WeightFor(input),
                accelerationFraction = atOnce,
                maxExtrapolation = VelocityExtrapolation.MaxChange(input, layout.Spacing),
                openFaces = input.connections?.OpenFaces ?? 0,
            };
        }
    }
}
