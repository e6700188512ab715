using Unity.Mathematics;

namespace Rill
{
    /// <summary>Holds the level at the open sides of a box: lets water in where it stands lower, and takes out what stands higher, in a strip beside
    /// each side.</summary>
    /// <remarks>A side uses one of the last numbers of the emitters and of the drains.</remarks>
    sealed class BorderLevels
    {
        const float Strip = 8f;             // d: two cells of the coarse grid
        const float Above = 0.5f;           // d: over the level from which water is taken out, so that still water is left alone

        readonly EmitterPositions[] positions = new EmitterPositions[FluidBorders.Sides];
        readonly float3[] sizes = new float3[FluidBorders.Sides];

        /// <summary>Number of the emitter and of the drain of a side.</summary>
        public static int NumberOf(int side) => StepSources.MaxEmitters - FluidBorders.Sides + side;

        /// <summary>Adds what happens at the open sides in a step.</summary>
        public void AddTo(StepSources sources, in FluidBorders borders, float3 box, float spacing, float step)
        {
            for (int side = 0; side < FluidBorders.Sides; side++)
            {
                FluidBorder border = borders[side];
                if (border.kind == BorderKind.Open)
                    Add(sources, side, border, box / spacing, spacing, step);
            }
        }

        void Add(StepSources sources, int side, in FluidBorder border, float3 box, float spacing, float step)
        {
            int axis = FluidBorders.AxisOf(side);
            float thickness = math.min(Strip, border.width / spacing), level = border.level / spacing;
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
                    inverseHalf = 1f / half, limit = DrainRegion.NoLimit, emitter = DrainRegion.NoEmitter, number = (uint)NumberOf(side)
                });
            }
            size.y = math.floor(level);
            if (size.y < 1f)
                return;
            center.y = 0.5f * size.y;
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
                number = NumberOf(side), positions = positions[side], start = pose, end = pose, velocity = velocity, cosSpread = 1f,
                due = Emitters.MaxCandidates, maxWaiting = EmitterStep.NoneWaits
            };
            emitter.ChoosePositions(0f, step);
            sources.keepsEmitters = true;
            sources.Add(emitter);
        }
    }
}
