using System.Collections;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Constraints;
using Is = UnityEngine.TestTools.Constraints.Is;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A playing fluid allocates no garbage.</summary>
    [Category("LongRun")]
    public class AllocationTests
    {
        const int WarmUp = 30, Frames = 300;
        const float Step = 1f / 60f;

        GameObject fluid;

        // Fluids take their steps when this test asks for them and at no other time.
        [SetUp]
        public void StopTime() => Time.timeScale = 0f;

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Object.Destroy(fluid);
            Time.timeScale = 1f;
            yield return null;
        }

        [UnityTest]
        public IEnumerator Three_hundred_frames_with_everything_on_allocate_no_managed_memory()
        {
            FluidSimulation simulation = Dam();
            FluidRenderer[] renderers = fluid.GetComponents<FluidRenderer>();
            Transform collider = fluid.GetComponentInChildren<FluidCollider>().transform;
            TestDelegate frame = () =>
            {
                collider.localPosition = new Vector3(0.1f * Mathf.Sin(simulation.StepCount), 0f, 0f);
                simulation.Results.Surface.IsNeeded = true;
                simulation.Advance(Step);
                foreach (FluidRenderer renderer in renderers)
                    renderer.DrawFrame();
            };
            yield return WarmedUp(frame);
            int before = simulation.StepCount;
            yield return WithoutGarbage(frame, Frames);
            Assert.That(simulation.StepCount - before, NUnit.Framework.Is.GreaterThanOrEqualTo(Frames));
            Assert.That(simulation.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.particles, NUnit.Framework.Is.EqualTo(800 - 64), "the collider takes 4 x 4 x 4 of them");
        }

        [UnityTest]
        public IEnumerator Sixty_frames_with_a_mesh_for_a_renderer_allocate_no_managed_memory()
        {
            FluidSimulation simulation = Dam();
            foreach (FluidRenderer renderer in fluid.GetComponents<FluidRenderer>())
                Object.Destroy(renderer);
            var mesh = fluid.AddComponent<FluidSurfaceMesh>();
            TestDelegate frame = () =>
            {
                simulation.Advance(Step);
                mesh.DrawFrame();
            };
            yield return WarmedUp(frame);
            yield return WithoutGarbage(frame, 60);
            Assert.That(mesh.Mesh != null);
        }

        [UnityTest]
        public IEnumerator Sixty_frames_that_wet_surfaces_allocate_no_managed_memory()
        {
            FluidSimulation simulation = Dam();
            var wetness = fluid.AddComponent<FluidWetness>();
            TestDelegate frame = () =>
            {
                simulation.Advance(Step);
                wetness.DrawFrame();
            };
            yield return WarmedUp(frame);
            yield return WithoutGarbage(frame, 60);
        }

        [UnityTest]
        public IEnumerator A_hundred_frames_with_emitters_drains_and_force_fields_allocate_no_managed_memory()
        {
            FluidSimulation simulation = Basin();
            TestDelegate frame = () => simulation.Advance(Step);
            yield return WarmedUp(frame);
            yield return WithoutGarbage(frame, 100);
            Assert.That(simulation.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.emitted, NUnit.Framework.Is.GreaterThan(300));
            Assert.That(statistics.drained, NUnit.Framework.Is.GreaterThan(100));
        }

        [UnityTest]
        public IEnumerator Sixty_frames_with_a_mesh_that_deforms_allocate_no_managed_memory()
        {
            FluidSimulation simulation = Dam();
            using (var arm = new SkinnedArm())
            {
                var deforming = arm.Object.AddComponent<FluidDeformingMesh>();
                deforming.Margin = 0.5f;
                deforming.TrianglesPerFrame = 400;
                arm.Object.SetActive(true);
                int frames = 0;
                TestDelegate frame = () =>
                {
                    deforming.StartFrame();     // also at the second call in a frame
                    arm.Bend(30f * Mathf.Sin(0.1f * frames++));
                    simulation.Advance(Step);
                };
                yield return WarmedUp(frame);
                yield return WithoutGarbage(frame, 60);
                Assert.That(deforming.BakedFields, NUnit.Framework.Is.GreaterThan(30));
            }
        }

        [UnityTest]
        public IEnumerator Sixty_frames_with_passes_and_readbacks_of_a_script_allocate_no_managed_memory()
        {
            FluidSimulation simulation = Basin();
            simulation.TrackPhases = true;
            var properties = new MaterialPropertyBlock();
            int passes = 0, copies = 0;
            simulation.BeforeStep += (commands, particles) =>
            {
                particles.SortNeighbors(commands);
                passes++;
            };
            using (var readback = new ParticleReadback())
            {
                TestDelegate frame = () =>
                {
                    copies += simulation.RequestParticles(readback) ? 1 : 0;
                    simulation.Advance(Step);
                    simulation.TryGetParticles(out FluidParticles particles);
                    particles.Bind(properties);
                };
                yield return WarmedUp(frame);
                yield return WithoutGarbage(frame, 60);
                Assert.That(passes, NUnit.Framework.Is.GreaterThanOrEqualTo(90));
                Assert.That(copies, NUnit.Framework.Is.GreaterThan(20));
                Assert.That(readback.HasData);
            }
        }

        [UnityTest]
        public IEnumerator Thirty_frames_in_which_a_batch_is_set_and_read_allocate_no_managed_memory()
        {
            FluidSimulation simulation = Basin();
            using (var batch = new FluidQueryBatch(simulation, 16, 8))
            using (var points = new NativeArray<float3>(16, Allocator.Persistent))
            using (var rays = new NativeArray<FluidRay>(8, Allocator.Persistent))
            using (var samples = new NativeArray<FluidProbeSample>(16, Allocator.Persistent))
            {
                NativeArray<FluidRay> to = rays;
                for (int i = 0; i < rays.Length; i++)
                    to[i] = FluidRay.Sphere(new Vector3(0.05f * i - 0.2f, 0.2f, 0f), 0.01f * i, Vector3.down);
                int valid = 0, hits = 0;
                TestDelegate frame = () =>
                {
                    batch.SetPoints(points);
                    batch.SetRays(rays);
                    simulation.Advance(Step);
                    valid += batch.CopySamples(samples);
                    for (int i = 0; i < batch.RayCount; i++)
                        hits += batch.TryGetHit(i, out FluidRayHit found) && found.hit ? 1 : 0;
                };
                yield return WarmedUp(frame);
                yield return WithoutGarbage(frame, 30);
                Assert.That(valid, NUnit.Framework.Is.GreaterThan(16 * 40));
                Assert.That(hits, NUnit.Framework.Is.GreaterThan(5 * 40));
            }
        }

        FluidSimulation Basin()
        {
            fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            var simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(1f, 0.6f, 0.5f), 0.05f, 2000);     // room, or it would say that there is none
            simulation.StatisticsInterval = 3;
            fluid.AddComponent<FluidVolume>().Size = new Vector3(0.5f, 0.4f, 0.5f);
            AddSources();
            fluid.SetActive(true);
            return simulation;
        }

        void AddSources()
        {
            var emitter = Part<FluidEmitter>(new Vector3(0.3f, 0.25f, 0f));
            emitter.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            emitter.Rate = 0.02f;
            emitter.Phase = 2;
            emitter.Lifetime = 1f;
            var fountain = Part<FluidEmitter>(new Vector3(-0.3f, 0.1f, 0f));
            fountain.Rate = 0f;
            var drain = Part<FluidDrain>(new Vector3(0f, -0.3f, 0f));
            drain.RateLimit = 0.01f;
            drain.RecycleTo = fountain;
            Part<FluidForceField>(Vector3.zero).Kind = ForceFieldKind.Wind;
            Part<FluidProbe>(Vector3.zero);
            Part<FluidDetector>(Vector3.zero);
        }

        T Part<T>(Vector3 position) where T : FluidPart
        {
            var part = new GameObject(typeof(T).Name);
            part.transform.SetParent(fluid.transform, false);
            part.transform.localPosition = position;
            return part.AddComponent<T>();
        }

        [Test]
        public void An_allocation_of_a_few_bytes_is_seen()
        {
            object kept = null;
            TestDelegate allocates = () => kept = new object();
            Assert.That(allocates, Is.AllocatingGCMemory());
            Assert.That(kept, NUnit.Framework.Is.Not.Null);
        }

        // Frames in which everything is made that is made once.
        static IEnumerator WarmedUp(TestDelegate frame)
        {
            yield return null;
            for (int i = 0; i < WarmUp; i++)
            {
                frame();        // twice a frame, as the check calls it
                frame();
                yield return null;
            }
        }

        static IEnumerator WithoutGarbage(TestDelegate frame, int count)
        {
            for (int i = 0; i < count; i++)
            {
                Assert.That(frame, Is.Not.AllocatingGCMemory(), $"frame {i}");
                yield return null;
            }
        }

        FluidSimulation Dam()
        {
            fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            var simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(1f, 0.6f, 0.5f), 0.05f, 1000);
            simulation.StatisticsInterval = 3;
            SolverBudget budget = SolverBudget.Default;
            budget.mode = BudgetMode.Milliseconds;
            budget.milliseconds = 1000f;        // a device that takes longer would say so, in a message
            budget.maxIterations = 4;
            simulation.Budget = budget;
            FluidMaterial material = FluidMaterial.Water;
            material.vorticity = 0.1f;
            material.shearModulus = 100f;
            material.artificialPressure = 0.1f;
            simulation.Material = material;
            SolverSettings settings = simulation.Settings;
            settings.deepWater = DeepWater.On;
            simulation.Settings = settings;
            fluid.AddComponent<FluidVolume>().Size = new Vector3(0.5f, 0.4f, 0.5f);
            var collider = new GameObject("Collider").AddComponent<FluidCollider>();
            collider.transform.SetParent(fluid.transform, false);
            collider.Size = 0.2f * Vector3.one;
            collider.MeasuresForce = true;
            fluid.AddComponent<ParticleRenderer>().ColorBy = ParticleRenderer.Quantity.Density;
            fluid.AddComponent<DomainRenderer>();
            fluid.SetActive(true);
            return simulation;
        }
    }
}
