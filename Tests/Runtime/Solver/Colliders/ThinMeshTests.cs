using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Thin meshes in the way of water at 100 m/s, 33 spacings in a step.</summary>
    public class ThinMeshTests
    {
        const float Spacing = 0.05f;
        static readonly float3 Box = new float3(16f, 24f, 16f);     // d

        // The sheet reaches through the domain's walls: in the corner under which it leans water slides out of the domain and is put back.
        [Test, Category("LongRun")]
        public void A_block_at_100_meters_a_second_does_not_pass_a_thin_mesh([Values(false, true)] bool isShell,
            [Values(0f, 0.5f)] float tilt, [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            MeshSdfSettings bake = MeshSdfSettings.Default;
            bake.voxelSize = isShell ? 0.25f : 0.5f;
            bake.shellThickness = isShell ? 0.5f : 0f;
            SignedDistanceField field = SignedDistanceField.Create(MeshSdfBaker.Bake(isShell ? TestMeshes.Sheet(32f)
                : TestMeshes.Box(new Vector3(32f, 1f, 32f)), bake));
            try
            {
                SolverSettings settings = SolverSettings.Default;
                settings.deepWater = deepWater;
                using (var fluid = new TestFluid(Box * Spacing, Spacing, 512, settings).AddBlock(new float3(4f, 13f, 4f) * Spacing,
                    8f * Spacing, new float3(0f, -100f, 0f)))
                {
                    quaternion turn = quaternion.Euler(0f, 0f, tilt);
                    ColliderMotion plate = ColliderTests.Still(ColliderShape.Mesh, field.Bounds.extents, Box * new float3(0.5f, 0.35f, 0.5f), turn);
                    plate.field = field.Texture;
                    plate.voxel = field.VoxelSize;
                    plate.fieldUnit = 1f;
                    ColliderTests.Use(fluid, plate);
                    for (int step = 1; step <= 12; step++)
                    {
                        fluid.Step().MeasureWhole();
                        int through = fluid.Read().positions.Count(p => math.mul(math.conjugate(turn), p.xyz - plate.end.position).y < 0f);
                        Assert.That(through, Is.Zero, $"through the mesh after {step} steps");
                    }
                }
            }
            finally
            {
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }
        }
    }
}
