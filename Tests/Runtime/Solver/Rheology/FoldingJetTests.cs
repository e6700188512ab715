using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>A jet of viscous fluid that falls on a floor without slip. It buckles there while its Reynolds number is below 1.2 (Cruickshank
    /// and Munson, J. Fluid Mech. 113, 1981), and then coils or folds.</summary>
    [Category("LongRun")]
    public class FoldingJetTests
    {
        const float Spacing = 0.004f, Radius = 0.01f, Speed = 0.6f, Fall = 0.18f;     // m, m/s
        const float Density = 1000f;
        static readonly Vector3 Box = new Vector3(0.2f, 0.22f, 0.2f);

        [TestCase(200f, true)]
        [TestCase(3f, false)]
        public void A_jet_folds_where_it_lands_if_it_is_thick_enough(float viscosity, bool folds)
        {
            using (var scene = new SourceScene(Box, Spacing, 12000))
            {
                FluidMaterial material = FluidMaterial.Viscous(Density, viscosity);
                material.allowedTension = 0.05f;
                material.artificialPressure = 0.1f;
                scene.Fluid.Material = material;
                scene.Fluid.StepRate = 240f;
                scene.Add<FluidEmitter>(new Vector3(0.1f * Spacing, Fall - 0.5f * Box.y, 0f), Vector3.down, emitter =>
                {
                    emitter.Radius = Radius;
                    emitter.Speed = Speed;
                    emitter.Rate = 0.9f * math.PI * Radius * Radius * Speed;
                });

                // Positions of the jet, halfway down, from its first landing on.
                var positions = new List<float2>();
                for (int frame = 0; frame < 84; frame++)
                {
                    scene.Step();
                    if (frame < 30 || frame % 3 != 0)
                        continue;
                    float3[] jet = scene.Read().positions.Select(p => p.xyz * Spacing)
                        .Where(p => math.abs(p.y - 0.45f * Fall) < 0.1f * Fall).ToArray();
                    Assert.That(jet.Length, Is.GreaterThan(20), "the jet is whole");
                    positions.Add(new float2(jet.Average(p => p.x), jet.Average(p => p.z)));
                }
                float sway = positions.Max(a => positions.Max(b => math.distance(a, b)));
                float fastest = scene.Read().velocities.Max(v => math.length(v.xyz)) * Spacing;
                TestContext.Out.WriteLine($"{viscosity} Pa s: sways by {sway / Radius:0.00} radii; fastest {fastest:0.00} m/s, " +
                    $"Reynolds number {Density * fastest * Radius / viscosity:0.000}");
                scene.AssertConserved();
                if (folds)
                    Assert.That(sway, Is.GreaterThan(Radius));
                else
                    Assert.That(sway, Is.LessThan(0.3f * Radius));
            }
        }
    }
}
