using System.Collections.Generic;
using System.Linq;
using Rill;
using Unity.Mathematics;

namespace Host.Report.Obstacles
{
    /// <summary>
    /// Water in an open cup that gains speed: in its frame gravity leans, so the surface rises by a / g against the acceleration a.
    /// </summary>
    /// <remarks>A square cup of five boxes without friction. Its water starts level and at rest, and sloshes: what is measured is the
    /// mean over a period.</remarks>
    static class MovingCup
    {
        public const float Spacing = 0.05f;             // m
        public const int Inside = 16, Layers = 10;      // d
        const float Rim = 24f;
        const double Settle = 2.0 / 3, Period = 1;      // s; the first standing wave of 0.8 m takes 1.03

        /// <summary>Slope of the surface over a / g.</summary>
        /// <param name="wall">Thickness of walls and floor, d.</param>
        /// <param name="acceleration">m/s².</param>
        /// <param name="degrees">From the grid's x axis to the path.</param>
        /// <param name="shift">Of the start along the path, d.</param>
        public static double Run(StepInput input, float wall, double acceleration, double degrees, float shift)
        {
            quaternion turn = quaternion.RotateY((float)math.radians(-degrees));
            float3 along = math.rotate(turn, new float3(1f, 0f, 0f));
            float path = (float)(acceleration * (Settle + Period) * (Settle + Period) / 2 / Spacing);
            float reach = Inside / 2f + wall;
            float margin = 1.5f * reach + 4f;
            var first = new float3(margin, wall + 2f, margin) + shift * along;
            float3 box = math.ceil(first + along * path + margin + 8f);
            box.y = Rim + wall + 8f;

            // In the cup's frame, whose origin is the center of the floor's upper side.
            var random = new Random(7);
            var positions = new List<float3>();
            FluidRun.AddBlock(positions, new float3(-Inside / 2f, 0f, -Inside / 2f), new int3(Inside, Layers, Inside), ref random);
            ColliderMotion[] walls = Walls(wall, reach);
            float3[] centers = walls.Select(w => w.start.position).ToArray();
            for (int i = 0; i < walls.Length; i++)
                walls[i].end = new RigidPose(first + math.rotate(turn, centers[i]), turn);

            using var run = new FluidRun("cup", box, Spacing, positions.Select(p => math.rotate(turn, p) + first).ToList(), _ => 0f, input);
            double slopes = 0;
            int samples = 0;
            while (run.Time < Settle + Period)
            {
                double then = run.Time + input.timeStep;
                float3 origin = first + (float)(acceleration * then * then / 2 / Spacing) * along;
                for (int i = 0; i < walls.Length; i++)
                {
                    walls[i].start = walls[i].end;
                    walls[i].end.position = origin + math.rotate(turn, centers[i]);
                }
                run.Use(walls);
                run.Step();
                if (run.Time <= Settle)
                    continue;
                // For a plane surface over a square floor, the center of mass lies slope L² / 12 h off the center.
                slopes -= 12.0 * Layers / (Inside * Inside) * run.ReadPositions().Average(p => math.dot(p.xyz - origin, along));
                samples++;
            }
            return slopes / samples / (acceleration / FluidRun.Gravity);
        }

        static ColliderMotion[] Walls(float wall, float reach)
        {
            const float half = Inside / 2f;
            return new[]
            {
                Solids.Box(new float3(-reach, -wall, -reach), new float3(reach, 0f, reach)),
                Solids.Box(new float3(-reach, 0f, -reach), new float3(-half, Rim, reach)),
                Solids.Box(new float3(half, 0f, -reach), new float3(reach, Rim, reach)),
                Solids.Box(new float3(-half, 0f, -reach), new float3(half, Rim, -half)),
                Solids.Box(new float3(-half, 0f, half), new float3(half, Rim, reach)),
            };
        }
    }
}
