using Unity.Mathematics;

namespace Rill
{
    /// <summary>Holds the level at the open sides of a box: in a part of each band it lets in what lacks and takes out what is more.</summary>
    /// <remarks>A side uses one of the last numbers of the emitters and of the drains.</remarks>
    sealed class BorderLevels
    {
        /// <summary>part of a band, from its side, where water comes and goes; its flow grows from none at the side</summary>
        [GenerateHlsl("Borders")] const float LevelPart = 0.5f;

        const float Above = 0.25f;          // d: over the level from which water is taken out, so that still water is left alone
        const float InflowHead = 5f;      // d: over the level to which water that flows in may stand
        const float MaxWait = 0.5f;         // s
        const float OutflowHead = 1.5f;     // u²/g, measured: what the water before a side loses as it flows out

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
        /// <param name="stepIndex">Its number since the reset.</param>
        public void AddTo(StepSources sources, in StepInput input, uint numbers, SolverLayout layout, uint stepIndex)
        {
            for (int side = 0; side < FluidBorders.Sides; side++)
            {
                if ((numbers >> FirstNumber + side & 1) != 0)
                    Add(sources, side, input, layout, stepIndex);
            }
        }

        // A side with inflow gives the volume, as a river beyond it does, and its level follows. The other sides give the level. Both
        // at once would need the head that the flow has, which depends on all of the scene.
        void Add(StepSources sources, int side, in StepInput input, SolverLayout layout, uint stepIndex)
        {
            FluidBorder border = input.borders[side];
            float3 box = layout.DomainSize;
            float spacing = layout.Spacing, step = input.timeStep, gravity = math.max(math.length(input.gravity), 1e-3f);
            int axis = FluidBorders.AxisOf(side);
            bool flowsIn = border.velocity > 0f;
            // A long side has more room than an emitter has positions: then a thinner strip of the band holds the level.
            float longest = math.floor(EmitterPositions.MaxPositions / (math.ceil(box.y) * math.ceil(box[2 - axis])));
            float thickness = math.min(LevelPart * border.width / spacing, longest), level = border.level / spacing;
            float3 size = box, center = 0.5f * box;
            size[axis] = thickness;
            center[axis] = FluidBorders.IsUpper(side) ? box[axis] - 0.5f * thickness : 0.5f * thickness;
            bool flowsOut = border.velocity < 0f;
            float top = flowsOut ? level - Above - OutflowHead * border.velocity * border.velocity / (gravity * spacing) : level + Above;
            if (!flowsIn && top < box.y)
                AddDrain(sources, side, size, center, box.y, math.max(top, 0f));
            size.y = math.min(math.floor(flowsIn ? level + InflowHead : flowsOut ? top - 1f : level), math.floor(box.y));
            center.y = math.min(0.5f * size.y + Above, box.y - 0.5f * size.y);
            if (size.y < 1f || PositionsOf(side, size, spacing) == null)
                return;
            float3 velocity = 0f;
            velocity[axis] = input.borders.VelocityAt(side) / spacing;
            var pose = new RigidPose(center, quaternion.identity);
            var emitter = new EmitterStep
            {
                number = FirstNumber + side, positions = positions[side], start = pose, end = pose, velocity = velocity, cosSpread = 1f,
                due = Emitters.MaxCandidates, maxWaiting = EmitterStep.NoneWaits
            };
            if (flowsIn)
            {
                double perStep = (double)border.velocity / spacing * step * level * box[2 - axis];
                double before = math.floor(perStep * stepIndex);
                emitter.due = (int)math.min(math.floor(perStep * (stepIndex + 1.0)) - before, Emitters.MaxCandidates);
                emitter.maxWaiting = (int)math.min(perStep * (MaxWait / step), int.MaxValue / 2);
            }
            emitter.ChoosePositions(0f, step);
            sources.keepsEmitters = true;
            sources.Add(emitter);
        }

        static void AddDrain(StepSources sources, int side, float3 size, float3 center, float top, float bottom)
        {
            size.y = top - bottom;
            center.y = 0.5f * (top + bottom);
            sources.keepsDrains = true;
            sources.Add(new DrainRegion
            {
                rotation = quaternion.identity.value, lastRotation = quaternion.identity.value, center = center, lastCenter = center,
                inverseHalf = 2f / size, limit = DrainRegion.NoLimit, emitter = DrainRegion.NoEmitter, number = (uint)(FirstNumber + side)
            });
        }

        EmitterPositions PositionsOf(int side, float3 size, float spacing)
        {
            if (positions[side] == null || !sizes[side].Equals(size))
            {
                positions[side] = EmitterPositions.Of(EmitterShape.Box, EmitterMode.Fill, size * spacing, 0f, null, 1f, spacing, out _);
                sizes[side] = size;
            }
            return positions[side];
        }
    }
}
