using Unity.Mathematics;

namespace Rill
{
    /// <summary>Holds the level at the open sides of a box: lets water in where it stands lower, and takes out what stands higher, in a strip beside
    /// each side.</summary>
    /// <remarks>A side uses one of the last numbers of the emitters and of the drains.</remarks>
    sealed class BorderLevels
    {
        const float LevelPart = 0.5f;       // of a band, beside its side: where water comes and goes
        const float Above = 0.25f;          // d: over the level from which water is taken out, so that still water is left alone

        readonly EmitterPositions[] positions = new EmitterPositions[FluidBorders.Sides];
        readonly float3[] sizes = new float3[FluidBorders.Sides];

        /// <summary>First of the numbers of emitters and drains that open sides use.</summary>
        public const int FirstNumber = StepSources.MaxEmitters - FluidBorders.Sides;

        /// <summary>Returns the numbers of emitters and drains that the open sides use, a bit for each.</summary>
        public static uint NumbersOf(in FluidBorders borders)
        {
            uint numbers = 0;
            for (int side = 0; side < FluidBorders.Sides; side++)
                numbers |= borders[side].kind == BorderKind.Open ? 1u << FirstNumber + side : 0u;
            return numbers;
        }

        /// <summary>Adds what happens at the open sides in a step.</summary>
        /// <param name="numbers">Those that they may use, of <see cref="NumbersOf"/>.</param>
        /// <param name="step">Length of the step, s.</param>
        public void AddTo(StepSources sources, in FluidBorders borders, uint numbers, SolverLayout layout, float step)
        {
            for (int side = 0; side < FluidBorders.Sides; side++)
            {
                if ((numbers >> FirstNumber + side & 1) != 0)
                    Add(sources, side, borders[side], layout.DomainSize, layout.Spacing, step);
            }
        }

        void Add(StepSources sources, int side, in FluidBorder border, float3 box, float spacing, float step)
        {
            int axis = FluidBorders.AxisOf(side);
            float thickness = LevelPart * border.width / spacing, level = border.level / spacing;
            float3 size = box;
            size[axis] = thickness;
            float3 center = 0.5f * box;
            center[axis] = FluidBorders.IsUpper(side) ? box[axis] - 0.5f * thickness : 0.5f * thickness;
            float top = level + Above;
            if (top < box.y)
            {
                float3 half = 0.5f * size, middle = center;
                half.y = 0.5f * (box.y - top);
                middle.y = top + half.y;
                sources.keepsDrains = true;
                sources.Add(new DrainRegion
                {
                    rotation = quaternion.identity.value, lastRotation = quaternion.identity.value, center = middle, lastCenter = middle,
                    inverseHalf = 1f / half, limit = DrainRegion.NoLimit, emitter = DrainRegion.NoEmitter, number = (uint)(FirstNumber + side)
                });
            }
            size.y = math.floor(level);
            if (size.y < 1f)
                return;
            center.y = 0.5f * size.y + Above;
            if (positions[side] == null || !sizes[side].Equals(size))
            {
                positions[side] = EmitterPositions.Of(EmitterShape.Box, EmitterMode.Fill, size * spacing, 0f, null, 1f, spacing, out _);
                sizes[side] = size;
            }
            if (positions[side] == null)
                return;
            float3 velocity = 0f;
            velocity[axis] = (FluidBorders.IsUpper(side) ? -border.velocity : border.velocity) / spacing;
            var pose = new RigidPose(center, quaternion.identity);
            var emitter = new EmitterStep
            {
                number = FirstNumber + side, positions = positions[side], start = pose, end = pose, velocity = velocity, cosSpread = 1f,
                due = Emitters.MaxCandidates, maxWaiting = EmitterStep.NoneWaits
            };
            emitter.ChoosePositions(0f, step);
            sources.keepsEmitters = true;
            sources.Add(emitter);
        }
    }
}
