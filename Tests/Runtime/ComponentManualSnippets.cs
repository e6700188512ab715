using System.Collections;
using System.Linq;
using NUnit.Framework;
using Rill.Testing;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The snippets of Documentation~/components.md: each component made by a script, as in ManualSnippets.</summary>
    public class ComponentManualSnippets : PlayedFluidFixture
    {
        static FluidVolume Volume(Transform parent)
        {
            #region Make a volume (components.md)
            var lake = new GameObject("Lake");
            lake.transform.SetParent(parent, false);                    // the fluid, or anything below it
            lake.transform.localPosition = new Vector3(0f, -0.7f, 0f);
            var volume = lake.AddComponent<FluidVolume>();
            volume.Shape = VolumeShape.Box;                             // or Sphere with Radius, SignedDistanceField with Field
            volume.Size = new Vector3(2f, 0.6f, 1f);                    // m
            volume.Velocity = Vector3.zero;                             // m/s
            #endregion
            return volume;
        }

        static FluidEmitter Emitter(Transform parent)
        {
            #region Make an emitter (components.md)
            var tap = new GameObject("Tap");
            tap.SetActive(false);
            tap.transform.SetParent(parent, false);
            tap.transform.localPosition = new Vector3(-0.5f, 0.6f, 0f);
            tap.transform.localRotation = Quaternion.LookRotation(Vector3.down);    // water leaves along the forward axis
            var emitter = tap.AddComponent<FluidEmitter>();
            emitter.Shape = EmitterShape.Disc;                          // or Box, Sphere, MeshSurface
            emitter.Mode = EmitterMode.Jet;                             // or Spray, Fill
            emitter.Radius = 0.15f;                                     // m
            emitter.Speed = 1.5f;                                       // m/s
            emitter.Rate = 0.05f;                                       // m³/s
            tap.SetActive(true);
            #endregion
            return emitter;
        }

        static FluidDrain Drain(Transform parent)
        {
            #region Make a drain (components.md)
            var outlet = new GameObject("Outlet");
            outlet.SetActive(false);
            outlet.transform.SetParent(parent, false);
            outlet.transform.localPosition = new Vector3(0.7f, -0.9f, 0f);
            var drain = outlet.AddComponent<FluidDrain>();
            drain.Shape = DrainShape.Box;                               // or Sphere with Radius
            drain.Size = new Vector3(0.4f, 0.2f, 0.4f);                 // m
            drain.RateLimit = 0.05f;                                    // m³/s; 0 takes all that gets in
            outlet.SetActive(true);
            #endregion
            return drain;
        }

        static FluidCollider Collider()
        {
            #region Make a collider (components.md)
            var post = new GameObject("Post");                          // anywhere in the scene: it need not be below the fluid
            post.SetActive(false);
            post.transform.position = new Vector3(0f, -0.5f, 0.2f);
            var collider = post.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Capsule;                     // or Box with Size, Sphere, Plane, Mesh with Field, HeightField with Heights
            collider.Radius = 0.12f;                                    // m
            collider.Height = 0.9f;                                     // m, from end to end
            collider.Friction = 0.1f;
            post.SetActive(true);
            #endregion
            return collider;
        }

        static FluidProbe Probe(Transform parent)
        {
            #region Make a probe (components.md)
            var gauge = new GameObject("Gauge");
            gauge.transform.SetParent(parent, false);
            gauge.transform.localPosition = new Vector3(-0.2f, -0.6f, -0.2f);
            var probe = gauge.AddComponent<FluidProbe>();
            probe.LevelStep = 0.02f;                                    // m
            probe.OnLevelChanged += height => Debug.Log($"The water stands at {height:0.00} m");
            #endregion
            return probe;
        }

        static FluidDetector Detector(Transform parent)
        {
            #region Make a detector (components.md)
            var basin = new GameObject("Basin");
            basin.transform.SetParent(parent, false);
            basin.transform.localPosition = new Vector3(-0.5f, -0.7f, 0f);
            var detector = basin.AddComponent<FluidDetector>();
            detector.Shape = DetectorShape.Capsule;                     // or Box with Size, Sphere, Mesh with Field
            detector.Radius = 0.25f;                                    // m
            detector.Height = 0.6f;                                     // m, from end to end
            detector.OnFilled += () => Debug.Log("The basin is full");
            #endregion
            return detector;
        }

        static FluidForceField ForceField(Transform parent)
        {
            #region Make a force field (components.md)
            var gust = new GameObject("Gust");
            gust.transform.SetParent(parent, false);
            gust.transform.localRotation = Quaternion.LookRotation(Vector3.right);
            var field = gust.AddComponent<FluidForceField>();
            field.Kind = ForceFieldKind.Direction;                      // along the forward axis; or Point, Vortex, Wind
            field.Bounds = ForceFieldBounds.Box;                        // or Sphere with Radius, None for everywhere
            field.Size = new Vector3(1f, 1f, 1f);                       // m
            field.Falloff = ForceFieldFalloff.Smooth;                   // or None, Linear, InverseSquare
            field.Strength = 2f;                                        // m/s²
            #endregion
            return field;
        }

        static FluidSurface Surface(FluidSimulation fluid)
        {
            #region Make a surface (components.md)
            var surface = fluid.gameObject.AddComponent<FluidSurface>();        // on the fluid's own object
            surface.Preset = SurfacePreset.Honey;                               // the look alone; FluidMaterial.Honey is how it flows
            surface.Quality = SurfaceQuality.High;
            var particles = fluid.gameObject.AddComponent<ParticleRenderer>();  // or plain balls, to look at what it does
            particles.enabled = false;
            #endregion
            return surface;
        }

        static FluidSurfaceMesh SurfaceMesh(FluidSimulation fluid, Material glass)
        {
            #region Give the surface a material of your own (components.md)
            var surface = fluid.gameObject.AddComponent<FluidSurfaceMesh>();    // brings a Mesh Filter and a Mesh Renderer along
            surface.Quality = SurfaceQuality.High;
            var renderer = fluid.GetComponent<MeshRenderer>();
            renderer.sharedMaterial = glass;                                    // any material: lit, or made with Shader Graph
            renderer.shadowCastingMode = ShadowCastingMode.On;                  // as of any object
            #endregion
            return surface;
        }

        static FluidWetness Wetness(FluidSimulation fluid)
        {
            #region Keep surfaces wet (components.md)
            var wetness = fluid.gameObject.AddComponent<FluidWetness>();        // on the fluid's own object
            wetness.DryingTime = 5f;                                            // s, until 37 % is left
            wetness.Darkening = 0.3f;                                           // light stone; 0.4 is dark ground
            wetness.Smoothness = 0.8f;                                          // of the film, which mirrors the sky
            #endregion
            return wetness;
        }

        static FluidSmoke Smoke(FluidSimulation fluid)
        {
            #region Smoke (components.md)
            var smoke = fluid.gameObject.AddComponent<FluidSmoke>();            // on the fluid's own object
            SmokeSettings air = SmokeSettings.Default;
            air.steam = 4f;                                                     // 1/m, over the water
            smoke.Settings = air;
            var fire = new GameObject("Fire").AddComponent<FluidSmokeSource>();
            fire.transform.position = new Vector3(0f, 0.5f, 0f);
            fire.Temperature = 1200f;                                           // °C
            fire.Density = 8f;                                                  // 1/m
            fire.Simulation = fluid;
            #endregion
            fire.transform.parent = fluid.transform;
            return smoke;
        }

        static FluidConnection Connection(FluidSimulation lake, FluidSimulation basin)
        {
            var connection = new GameObject("Opening").AddComponent<FluidConnection>();
            connection.First = lake;
            connection.Second = basin;
            return connection;
        }

        static void Shapes(FluidSimulation fluid)
        {
            #region Shapes for fills and removals (components.md)
            fluid.Fill(FluidShape.Capsule(new Vector3(0.2f, 0.2f, 0f), new Vector3(0.6f, 0.2f, 0f), 0.15f));     // from end to end, and its radius
            fluid.RemoveInside(FluidShape.Sphere(new Vector3(0.2f, 0.2f, 0f), 0.1f));
            fluid.RemoveInside(FluidShape.Box(new Vector3(0.6f, 0.2f, 0f), new Vector3(0.1f, 0.4f, 0.1f), Quaternion.Euler(0f, 0f, 30f)));
            #endregion
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Each_component_made_by_its_snippet_does_what_it_is_for()
        {
            FluidSimulation fluid = Fluid("Lake", new Vector3(2f, 2f, 1f), 0.1f, 6000, Vector3.zero, made => Volume(made.transform));
            FluidSurface surface = Surface(fluid);
            Transform parent = fluid.transform;
            FluidEmitter emitter = Emitter(parent);
            FluidDrain drain = Drain(parent);
            FluidCollider collider = Collider();
            made.Add(collider.gameObject);
            FluidProbe probe = Probe(parent);
            FluidDetector detector = Detector(parent);
            collider.MeasuresForce = true;
            float height = float.NaN;
            probe.OnLevelChanged += level => height = level;
            yield return Frames(40);
            Assert.That(fluid.GetComponentsInChildren<FluidVolume>().Length, Is.EqualTo(1));
            FluidStatistics now = FluidAssert.Measure(fluid);
            Assert.That(now.added, Is.EqualTo(20 * 6 * 10 - 64), "the volume, without what lies in the post");
            Assert.That(emitter.EmittedVolume, Is.EqualTo(0.05 * 40 / 60).Within(0.01), "the emitter");
            Assert.That(drain.Drained, Is.Positive, "the drain");
            Assert.That(collider.TryGetForce(out Vector3 force, out _) && force.y > 0f, "the collider");
            Assert.That(height, Is.EqualTo(-0.4f).Within(0.15f), "the probe");
            Assert.That(detector.Latest.fill, Is.InRange(0.8f, 1f), "the detector");
            Assert.That((surface.Preset, fluid.GetComponent<ParticleRenderer>().enabled), Is.EqualTo((SurfacePreset.Honey, false)), "the surface");
            Assert.That(detector.ShapeVolume, Is.EqualTo(Mathf.PI * 0.0625f * (0.1f + 4f / 3f * 0.25f)).Within(1e-4f), "a capsule");
        }

        [UnityTest]
        public IEnumerator A_surface_mesh_made_by_its_snippet_fills_the_filter_of_the_renderer()
        {
            FluidSimulation fluid = Fluid("Lake", new Vector3(2f, 2f, 1f), 0.1f, 6000, Vector3.zero, made => Volume(made.transform));
            var glass = new Material(Shader.Find("Standard"));
            FluidSurfaceMesh surface = SurfaceMesh(fluid, glass);
            yield return Frames(3);
            Assert.That(surface.Mesh != null && fluid.GetComponent<MeshFilter>().sharedMesh == surface.Mesh);
            Object.Destroy(glass);
        }

        [UnityTest]
        public IEnumerator A_wetness_made_by_its_snippet_marks_where_the_water_is()
        {
            FluidSimulation fluid = Fluid("Lake", new Vector3(2f, 2f, 1f), 0.1f, 6000, Vector3.zero, made => Volume(made.transform));
            FluidWetness wetness = Wetness(fluid);
            yield return Frames(3);
            Assert.That(wetness.isActiveAndEnabled);
            Assert.That(wetness.HasAnything);
        }

        [UnityTest]
        public IEnumerator Smoke_made_by_its_snippet_rises_from_its_fire()
        {
            FluidSimulation fluid = Fluid("Lake", new Vector3(2f, 2f, 1f), 0.1f, 6000, Vector3.zero);
            Smoke(fluid);
            yield return Frames(4);
            int cells = fluid.Solver.Smoke.Counts.x * fluid.Solver.Smoke.Counts.y * fluid.Solver.Smoke.Counts.z;
            float[] air = GpuTest.Read<float>(fluid.Solver.Smoke.Air, 2 * cells);
            Assert.That(air.Take(cells).Max(), Is.GreaterThan(200f), "K");
            Assert.That(air.Skip(cells).Max(), Is.InRange(3f, 9f), "1/m");
        }

        [UnityTest]
        public IEnumerator A_force_field_made_by_its_snippet_pushes_the_water_to_its_side()
        {
            FluidSimulation fluid = Fluid("Lake", new Vector3(2f, 2f, 1f), 0.1f, 6000, Vector3.zero, made => made.Gravity = Vector3.zero);
            yield return null;
            fluid.Fill(FluidShape.Box(Vector3.zero, 0.6f * Vector3.one));
            ForceField(fluid.transform);
            yield return Frames(20);
            FluidStatistics now = FluidAssert.Measure(fluid);
            Assert.That(now.momentum.x / (1000f * now.particles * 0.001f), Is.InRange(0.1f, 2f * 20f / 60f + 0.01f));
        }

        [UnityTest]
        public IEnumerator Fills_and_removals_by_their_snippet_take_the_volume_of_their_shapes()
        {
            FluidSimulation fluid = Fluid("Lake", new Vector3(2f, 2f, 1f), 0.05f, 6000, Vector3.zero);
            yield return null;
            Shapes(fluid);
            yield return null;
            FluidStatistics now = FluidAssert.Measure(fluid);
            Assert.That(now.added, Is.InRange(150, 240), "whole inside a capsule: centers in one of 0.028 m³, at 8,000 a cubic meter");
            Assert.That(now.drained, Is.InRange(20, 60));
        }

        [UnityTest]
        public IEnumerator A_connection_made_by_its_snippet_is_open()
        {
            var box = new Vector3(2f, 1f, 0.5f);
            FluidSimulation lake = Fluid("Lake", box, 0.1f, 3000, new Vector3(2f, 0.4f, 0.5f));
            FluidSimulation basin = Fluid("Basin", box, 0.1f, 3000, Vector3.zero, made => made.transform.position = new Vector3(1.2f, 0f, 0f));
            FluidConnection connection = Connection(lake, basin);
            made.Add(connection.gameObject);
            yield return Frames(30);
            Assert.That(connection.IsOpen);
            Assert.That(connection.HandedToSecond, Is.Positive);
        }
    }
}
