using System;
using System.Collections;
using System.IO;
using NUnit.Framework;
using Rill.Testing;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>
    /// The snippets of the manual: each region is one of them, word for word, which a test of the host compares. Its name is that of the section
    /// in Documentation~/scripting.md, or of another page in brackets. Those of modules are with their tests.
    /// </summary>
    public class ManualSnippets
    {
        GameObject root;

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(root);

        static GameObject MakeFluid()
        {
            #region Make a fluid
            var box = new GameObject("Fluid");
            box.SetActive(false);                                       // nothing starts before all is set
            var fluid = box.AddComponent<FluidSimulation>();
            fluid.Configure(new Vector3(2f, 2f, 1f), 0.1f, 4000);       // size in m, spacing in m, capacity
            box.AddComponent<FluidSurface>();

            var water = new GameObject("Water");
            water.transform.SetParent(box.transform, false);
            water.transform.localPosition = new Vector3(-0.6f, -0.4f, 0f);
            water.AddComponent<FluidVolume>().Size = new Vector3(0.8f, 1.2f, 1f);
            box.SetActive(true);
            #endregion
            return box;
        }

        static string ReadStatistics(FluidSimulation fluid)
        {
            string text = null;
            #region Read the statistics
            if (fluid.TryGetStatistics(out FluidStatistics now))        // false until the first came back
                text = $"{now.particles} particles, density error {100f * now.densityError:0.00} %, {now.refused} refused";
            #endregion
            return text;
        }

        static void OpenTap(FluidEmitter tap)
        {
            #region Turn a tap
            tap.Rate = 0.0005f;             // half a liter a second
            tap.Speed = 1f;                 // m/s
            if (!tap.IsEmitting)
                tap.StartEmission();        // and StopEmission() to close it
            #endregion
        }

        static void AddSplash(FluidSimulation fluid, Vector3 at)
        {
            #region Add particles
            const int Side = 5;
            float d = fluid.ParticleSpacing;
            using (var positions = new NativeArray<float3>(Side * Side * Side, Allocator.Temp))
            using (var velocities = new NativeArray<float3>(Side * Side * Side, Allocator.Temp))
            {
                NativeArray<float3> to = positions, velocitiesTo = velocities;
                for (int i = 0; i < to.Length; i++)
                {
                    to[i] = (float3)at + d * new float3(i % Side, i / Side % Side, i / (Side * Side));      // a spacing apart
                    velocitiesTo[i] = new float3(0f, -3f, 0f);
                }
                fluid.AddParticles(positions, velocities, phase: 1, lifetime: 5f);      // world space, m and m/s; gone after 5 s
            }
            #endregion
        }

        static void FillAndRemove(FluidSimulation fluid, Vector3 center, bool empties)
        {
            #region Fill and remove
            fluid.RemoveInside(FluidShape.Sphere(center, 0.3f));                        // those whose center is inside
            fluid.Fill(FluidShape.Box(center + 0.5f * Vector3.up, 0.4f * Vector3.one), velocity: Vector3.down);
            if (empties)
                fluid.Clear();                                                          // all of it; time and emitters go on
            #endregion
        }

        static void SeveralLiquids(FluidSimulation simulation)
        {
            #region Several liquids (materials.md)
            FluidMaterialAsset oil = FluidMaterialAsset.Create("Oil", density: 910f, dynamicViscosity: 0.08f);
            simulation.PhaseMaterials = new[] { oil };
            simulation.Fill(FluidShape.Box(new Vector3(0f, 0.5f, 0f), Vector3.one * 0.2f), Vector3.zero, oil);
            #endregion
        }

        static void FollowATarget(FluidSimulation fluid, Transform target, Transform lake)
        {
            #region Follow a target
            Vector3 away = target.position - fluid.transform.position;
            away.y = 0f;                                                                // along the ground
            if (away.magnitude > 4f * fluid.ParticleSpacing)
            {
                fluid.Recenter(fluid.transform.position + away);                        // what is outside then is removed
                lake.position = fluid.transform.position;                               // a Fluid Volume as wide as the box
                fluid.Fill(lake.GetComponent<FluidVolume>());                           // fills what is new, and nothing else
            }
            #endregion
        }

        static void FollowByAComponent(FluidSimulation fluid, Transform boat)
        {
            #region Follow a target by a component
            var follow = fluid.gameObject.AddComponent<FluidFollow>();
            follow.Target = boat;                           // not below the fluid
            follow.Distance = 6f;                           // spacings that it may be away before the box moves
            follow.Leaving = LeavingParticles.Keep;         // finds its water again
            #endregion
        }

        static void FindTheWaterAgain(FluidSimulation fluid, Transform target)
        {
            #region Find the water again
            fluid.KeptCapacity = 200000;                                                // particles outside at most
            fluid.Recenter(target.position, LeavingParticles.Keep);
            int outside = fluid.KeptParticleCount;                                      // two or three frames old
            #endregion
            _ = outside;
        }

        static void HandOverWhatIsLeftBehind(FluidSimulation fluid, Transform target, FluidSimulation harbor)
        {
            #region Hand over what is left behind
            fluid.Recenter(target.position, LeavingParticles.Keep, handOverTo: harbor);     // what lies in neither box is kept
            #endregion
        }

        static void ConnectTwoFluids(GameObject gameObject, FluidSimulation lake, FluidSimulation basin)
        {
            #region Connect two fluids
            FluidConnection opening = gameObject.AddComponent<FluidConnection>();
            opening.First = lake;
            opening.Second = basin;
            bool flows = opening.IsOpen;
            int gone = opening.HandedToSecond, waiting = opening.WaitingForSecond;      // two or three frames old
            #endregion
            _ = (flows, gone, waiting);
        }

        static void DisableAndEnable(FluidSimulation fluid, GameObject pooled, bool keeps)
        {
            #region Keep or drop the water of a disabled fluid
            pooled.SetActive(false);                                        // its water stays as it is
            fluid.KeepStateOnDisable = keeps;                               // false gives its memory back now
            pooled.SetActive(true);                                         // goes on, or begins again
            #endregion
        }

        static void SimulateWhatIsSeen(FluidSimulation fluid)
        {
            #region Simulate only what is in view
            fluid.CullingMode = FluidCullingMode.Slow;      // or Pause
            fluid.CulledRate = 0.25f;                       // a quarter of the steps while no camera sees the box
            fluid.CullingDistance = 50f;                    // m; cameras further away do not count
            #endregion
        }

        internal static void ChangeParticles(FluidSimulation fluid, ComputeShader shader, Vector4 center)
        {
            #region Change the particles before each step
            int kernel = shader.FindKernel("Turn");
            fluid.BeforeStep += (commands, particles) =>            // once for each fixed step
            {
                commands.SetComputeVectorParam(shader, "_Center", center);
                particles.Dispatch(commands, shader, kernel);       // binds the particles and runs the kernel for all of them
            };
            #endregion
        }

        static float ReadParticles(FluidSimulation fluid, ParticleReadback readback)
        {
            float highest = float.MinValue;
            #region Read the particles on the CPU
            if (readback.HasData)
                foreach (float3 position in readback.Positions)                 // world space, m
                    highest = Mathf.Max(highest, position.y);
            fluid.RequestParticles(readback, ParticleFields.Positions);         // false while one is pending
            #endregion
            return highest;
        }

        static void MoveCollider(FluidCollider paddle, bool isTeleport)
        {
            #region Move a collider
            paddle.transform.position += 0.5f * Time.deltaTime * Vector3.right;     // it pushes the water
            if (isTeleport)
            {
                paddle.transform.position = Vector3.up;
                paddle.Teleport();                                                  // it was not in the water between
            }
            #endregion
        }

        static void MakeCharacterSolid(SkinnedMeshRenderer character, bool isSeenClosely)
        {
            #region Make a character solid
            if (isSeenClosely)
            {
                var skin = character.gameObject.AddComponent<FluidDeformingMesh>();     // follows the mesh itself
                skin.Resolution = 64;
                skin.TrianglesPerFrame = 20000;                                         // of 60,000: a field every third frame
            }
            else
            {
                var bones = character.gameObject.AddComponent<FluidBoneColliders>();    // a capsule for each limb
                bones.MinVertices = 40;                                                 // none for fingers
                bones.Fit();
            }
            #endregion
        }

        static void ReadForce(FluidCollider gate)
        {
            #region Read the force on a collider
            gate.MeasuresForce = true;
            if (gate.TryGetForce(out Vector3 force, out Vector3 torque))        // N and N m, a few frames old
                Debug.DrawRay(gate.WorldCenter, 0.001f * force);
            #endregion
        }

        static void ListenToHits(FluidCollider gate)
        {
            #region Hear what the water hits
            gate.HitImpulse = 20f;                                              // N s of one reading, which is that of one to three frames
            gate.OnHit += contact => Debug.Log($"{contact.Collider.name}: {contact.Impulse.magnitude} N s in step {contact.Step}");
            #endregion
        }

        static void ApplyPreset(FluidSimulation fluid)
        {
            #region Give a fluid a preset
            var wine = ScriptableObject.CreateInstance<FluidPreset>();
            wine.Material = FluidMaterial.Viscous(990f, 0f);            // kg/m³; as thin as water
            wine.Surface = SurfacePreset.Wine;                          // or wine.Look, for values of your own
            wine.ApplyTo(fluid);
            #endregion
            Object.DestroyImmediate(wine);
        }

        static void SetBudget(FluidSimulation fluid)
        {
            #region Set a budget and the solver
            fluid.Iterations = 2;                           // also Substeps, Relaxation, SleepSpeed, NumericalDamping
            fluid.DeepWater = DeepWater.On;
            fluid.Material = FluidMaterial.Seawater;        // a preset; fluid.DynamicViscosity = 4f changes that alone
            SolverSettings settings = fluid.Settings;       // all others: change a copy and give it back
            settings.softness = 0.002f;
            fluid.Settings = settings;

            SolverBudget budget = fluid.Budget;             // or let a time choose them
            budget.mode = BudgetMode.Milliseconds;
            budget.milliseconds = 1.5f;
            budget.maxIterations = 8;                       // bounds of its own, apart from fluid.Iterations
            fluid.Budget = budget;
            #endregion
        }

        static void ChangeSpacing(FluidSimulation fluid)
        {
            #region Change the spacing and keep the water
            fluid.Capacity = 8000;                          // first, so that it holds the finer water
            fluid.ParticleSpacing = 0.08f;                  // two or three frames later, in which the water stands still
            #endregion
        }

        static void Recycle(FluidDrain drain, FluidEmitter jet)
        {
            #region Let a drain feed a jet
            drain.RateLimit = 0.01f;        // 10 liters a second
            drain.RecycleTo = jet;
            jet.Rate = 0f;                  // nothing but what comes back
            #endregion
        }

        static void QueryWater(FluidProbe probe, Transform buoy)
        {
            #region Ask the water (queries.md)
            if (probe.TryGetSample(out FluidProbeSample water) && water.hasSurface)     // false before the first result
                buoy.position = new Vector3(buoy.position.x, water.ExtrapolatedHeight, buoy.position.z);
            #endregion
        }

        static Func<string> ReadAGauge(FluidProbe gauge)
        {
            string text = null;
            #region Ask at a point (queries.md)
            gauge.LevelStep = 0.02f;                                        // m
            gauge.OnLevelChanged += height => text = $"{height:0.00} m";
            #endregion
            return () => text;
        }

        static string QueryAndWait(FluidProbe probe)
        {
            string text = null;
            #region Ask and wait (queries.md)
            FluidProbeSample here = probe.MeasureNow();                     // slow: it waits for the GPU
            if (here.hasSurface)
                text = here.ToString();                                     // "at (0.000, -0.150, 0.000) m, step 12, ..."
            #endregion
            return text;
        }

        static void WatchABasin(FluidDetector basin, FluidEmitter tap)
        {
            #region Watch a basin (queries.md)
            basin.FillLevel = 0.8f;
            basin.OnFilled += () => tap.StopEmission();
            basin.OnEmptied += () => tap.StartEmission();
            if (basin.TryGetSample(out FluidDetectorSample inside))
                Debug.Log($"{1000f * inside.volume:0.0} liters, {inside.momentum.magnitude:0.0} kg m/s, {inside.age:0.000} s ago");
            #endregion
        }

        static void QueryManyPoints(FluidSimulation fluid, Vector3[] floats, ref FluidQueryBatch batch)
        {
            #region Ask the water in many places (queries.md)
            batch ??= new FluidQueryBatch(fluid, points: floats.Length, rays: 1);      // once; Dispose it in OnDisable
            batch.SetPoints(floats, 0, floats.Length);                                 // each frame in which they have moved
            for (int i = 0; i < floats.Length; i++)
                if (batch.TryGetSample(i, out FluidProbeSample water) && water.hasSurface)
                    floats[i].y = water.ExtrapolatedHeight;
            #endregion
        }

        static void CastRays(FluidQueryBatch batch, Transform eye, Transform marker, Transform leaf)
        {
            #region Cast rays against the water (queries.md)
            batch.RayCount = 1;
            batch.SetRay(0, new FluidRay(eye.position, eye.forward, 20f));      // or FluidRay.Sphere(eye.position, 0.1f, eye.forward)
            if (batch.TryGetHit(0, out FluidRayHit found) && found.hit)         // false before the first result, and where it misses
            {
                marker.SetPositionAndRotation(found.point, Quaternion.LookRotation(found.normal));
                leaf.position = found.ExtrapolatedPoint;                        // where the water has carried it since
            }
            #endregion
        }

        static void ShiftOrigin(Transform root, Vector3 shift, FluidSimulation[] fluids)
        {
            #region Shift the origin of the world
            root.position += shift;                         // fluids, colliders, bodies and cameras are below it
            foreach (FluidSimulation fluid in fluids)
                fluid.Teleport();
            #endregion
        }

        static void StartAgain(FluidSimulation fluid)
        {
            #region Pause and start again
            fluid.Paused = true;        // time stands still; it is drawn all the same
            fluid.Paused = false;
            fluid.Restart();            // volumes are filled again, the fluid's time is 0
            #endregion
        }

        static IEnumerator SaveState(FluidSimulation fluid, string path)
        {
            #region Save and restore the fluid
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return request;                                       // in a coroutine; nothing waits
            File.WriteAllBytes(path, request.Snapshot.ToBytes());
            #endregion
        }

        static void LoadState(FluidSimulation fluid, string path)
        {
            #region Load the fluid
            FluidSnapshot saved = FluidSnapshot.FromBytes(File.ReadAllBytes(path));
            fluid.Restore(saved);                                       // the next step goes on from it
            #endregion
        }

        static FluidSnapshotAsset StartFromAStoredState(FluidSimulation fluid, FluidSnapshotRequest request)
        {
            #region Start from a stored state
            FluidSnapshotAsset stored = FluidSnapshotAsset.Create(request.Snapshot);     // AssetDatabase.CreateAsset saves it
            fluid.StartState = stored;
            fluid.Restart();                                // begins with it instead of its volumes
            #endregion
            return stored;
        }

        internal static void BakeAMesh(Mesh mesh, SignedDistanceField field, string guidOfTheMesh, bool canceled)
        {
            #region Bake from a script (baking.md)
            MeshReport report = MeshCheck.Run(mesh);                     // what is wrong with it, in numbers and words
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 128;
            foreach (MeshLoss loss in report.LossesOf(settings))         // what of it these settings would not represent
                Debug.LogWarning(loss.Text);
            MeshSdfEstimate size = MeshSdfBaker.Estimate(TriangleMesh.Of(mesh), settings);   // voxels, bytes, or why not
            SdfBake bake = MeshSdfBaker.Bake(mesh, settings, (fraction, stage) => !canceled);  // null if canceled
            Texture3D replaced = field.Apply(bake, guidOfTheMesh);       // into the asset that is there; references to it stay
            #endregion
            _ = (report, size, replaced);
        }

        static ParticleSequence Export(FluidSimulation fluid, string folder)
        {
            #region Export particles
            var sequence = new ParticleSequence(fluid, folder, "water", ParticleFileFormat.Vtk);
            sequence.Capture();             // folder/water_000000.vtk, a few frames later
            #endregion
            return sequence;
        }

        static IEnumerator Record(FluidRecorder recorder, string path)
        {
            #region Record a fluid
            recorder.Fields = RecordingFields.Velocities | RecordingFields.Ids;
            recorder.Rate = 30f;            // frames a second of fluid time
            recorder.Record(path);
            yield return new WaitForSeconds(0.5f);
            recorder.Stop();
            while (recorder.IsWriting)      // the last frames are pending
                yield return null;
            #endregion
        }

        static void Play(FluidPlayback playback, string path)
        {
            #region Play a recording
            playback.Open(path);
            playback.Speed = 0.5f;
            playback.Play();
            playback.Time = 0.2;            // seconds since the first frame
            #endregion
        }

        [UnityTest]
        public IEnumerator The_snippets_that_record_and_play_show_the_fluid()
        {
            root = MakeFluid();
            string path = Path.Combine(Path.GetTempPath(), $"rill-snippet-{Guid.NewGuid():N}.rillrec");
            try
            {
                FluidRecorder recorder = root.AddComponent<FluidRecorder>();
                yield return Record(recorder, path);
                Assert.That((recorder.Problem, recorder.IsWriting), Is.EqualTo(((string)null, false)));
                Assert.That(recorder.FrameCount, Is.InRange(2, 40));
                FluidPlayback playback = root.AddComponent<FluidPlayback>();
                playback.WaitForFrames = true;
                Play(playback, path);
                yield return null;
                yield return null;
                Assert.That(playback.ShownFrame, Is.GreaterThan(0));
                playback.Close();
            }
            finally
            {
                File.Delete(path);
            }
        }

        [UnityTest]
        public IEnumerator The_snippets_that_save_and_load_bring_the_fluid_back()
        {
            root = MakeFluid();
            var fluid = root.GetComponent<FluidSimulation>();
            string folder = Path.Combine(Path.GetTempPath(), "rill-snippets-" + Guid.NewGuid().ToString("N")),
                path = Path.Combine(folder, "fluid.bin");
            Directory.CreateDirectory(folder);
            try
            {
                for (int i = 0; i < 5; i++)
                    yield return null;
                int steps = fluid.StepCount;
                IEnumerator save = SaveState(fluid, path);
                while (save.MoveNext())
                    for (int i = 0; i < 5; i++)
                        yield return null;
                ParticleSequence sequence = Export(fluid, folder);
                for (int i = 0; i < 5; i++)
                    yield return null;
                Assert.That(fluid.StepCount, Is.GreaterThan(steps));
                LoadState(fluid, path);
                Assert.That(fluid.StepCount, Is.EqualTo(steps));
                Assert.That(sequence.Written, Is.EqualTo(1));
                Assert.That(File.Exists(Path.Combine(folder, "water_000000.vtk")));
                sequence.Dispose();
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        static IEnumerator AssertScene(FluidSimulation fluid)
        {
            #region Assert in a test
            Time.captureDeltaTime = 1f / 60f;                                   // the same steps on every machine
            yield return FluidAssert.Settles(fluid, within: 5f, noise: 0.3f);   // plays until the water is calm
            FluidAssert.NothingLost(fluid);
            FluidAssert.NothingEscaped(fluid);
            #endregion
        }

        [UnityTest]
        public IEnumerator The_snippets_of_the_manual_do_what_the_page_says()
        {
            root = MakeFluid();
            var fluid = root.GetComponent<FluidSimulation>();
            ApplyPreset(fluid);
            Assert.That(fluid.Material.density, Is.EqualTo(990f));
            SetBudget(fluid);
            FluidEmitter jet = Part<FluidEmitter>();
            FluidDrain drain = Part<FluidDrain>();
            FluidCollider collider = Part<FluidCollider>();
            collider.Size = 0.3f * Vector3.one;
            OpenTap(jet);
            Assert.That(jet.Rate, Is.EqualTo(0.0005f));
            Recycle(drain, jet);
            FluidProbe probe = Part<FluidProbe>();
            probe.transform.localPosition = new Vector3(-0.6f, 0f, 0f);
            FluidDetector basin = Part<FluidDetector>();
            WatchABasin(basin, jet);
            Func<string> gauge = ReadAGauge(probe);
            MoveCollider(collider, true);
            ListenToHits(collider);
            AddSplash(fluid, new Vector3(0.3f, 0f, 0f));
            float highest = float.MinValue;
            using (var readback = new ParticleReadback())
            {
                for (int i = 0; i < 25; i++)
                {
                    ReadForce(collider);
                    highest = Mathf.Max(highest, ReadParticles(fluid, readback));
                    yield return null;
                }
            }
            Assert.That(highest, Is.EqualTo(0.4f).Within(0.04f), "the top of the splash as it is added, falling since");
            Assert.That(ReadStatistics(fluid), Does.Contain("particles").And.EndWith("0 refused"));
            fluid.TryGetStatistics(out FluidStatistics statistics);
            Assert.That(statistics.added, Is.EqualTo(8 * 12 * 10 + 125));
            Assert.That(collider.transform.position, Is.EqualTo(Vector3.up));
            Assert.That(fluid.Budget.mode, Is.EqualTo(BudgetMode.Milliseconds));
            var buoy = new GameObject("Buoy").transform;
            buoy.SetParent(root.transform, false);
            QueryWater(probe, buoy);
            Assert.That(buoy.position.y, Is.InRange(-0.4f, -0.1f), "1.2 m of water in four tenths of the box are 0.48 m in all of it");
            Assert.That(basin.Latest.valid);
            Assert.That(QueryAndWait(probe), Does.Contain($"step {fluid.StepCount}, 0.0"));
            Assert.That(gauge(), Does.StartWith("-0.").And.EndWith(" m"));
            var leaf = new GameObject("Leaf").transform;
            leaf.SetParent(root.transform, false);
            FluidQueryBatch batch = null;
            var floats = new[] { probe.transform.position, probe.transform.position + 0.05f * Vector3.right };
            Vector3 above = probe.transform.position + 0.4f * Vector3.up;
            probe.transform.SetPositionAndRotation(above, Quaternion.LookRotation(Vector3.down, Vector3.forward));     // the eye
            for (int i = 0; i < 6; i++)
            {
                QueryManyPoints(fluid, floats, ref batch);
                CastRays(batch, probe.transform, buoy, leaf);
                yield return null;
            }
            Assert.That(floats[1].y, Is.InRange(-0.45f, -0.15f));
            Assert.That(buoy.position.y, Is.EqualTo(floats[0].y).Within(0.1f));
            Assert.That(batch.TryGetHit(0, out FluidRayHit below) && below.hit);
            Assert.That(Vector3.Distance(leaf.position, below.point), Is.LessThan(0.1f), "a few frames further");
            batch.Dispose();

            StartAgain(fluid);
            Assert.That(fluid.StepCount, Is.EqualTo(0));
            yield return AssertScene(fluid);
            Time.captureDeltaTime = 0f;
        }

        [UnityTest]
        public IEnumerator The_snippets_that_control_a_fluid_do_what_the_page_says()
        {
            root = MakeFluid();
            var fluid = root.GetComponent<FluidSimulation>();
            Time.captureDeltaTime = 1f / 60f;
            for (int i = 0; i < 3; i++)
                yield return null;
            FillAndRemove(fluid, new Vector3(-0.6f, -0.4f, 0f), false);
            yield return null;
            FluidStatistics changed = FluidAssert.Measure(fluid);
            Assert.That(changed.drained, Is.InRange(80, 140), "a sphere of radius 0.3 m at 1,000 particles a cubic meter holds 113");
            Assert.That(changed.added, Is.InRange(8 * 12 * 10 + 1, 8 * 12 * 10 + 64));
            DisableAndEnable(fluid, root, true);
            Assert.That(fluid.StepCount, Is.EqualTo(4));
            yield return null;
            Assert.That(FluidAssert.Measure(fluid).particles, Is.EqualTo(changed.particles));
            DisableAndEnable(fluid, root, false);
            Assert.That(fluid.StepCount, Is.Zero);
            yield return null;
            FillAndRemove(fluid, Vector3.zero, true);
            yield return null;
            Assert.That(FluidAssert.Measure(fluid).particles, Is.Zero);
            var target = new GameObject("Target").transform;
            target.SetParent(root.transform, false);
            target.localPosition = 0.5f * Vector3.right;
            FluidVolume lake = new GameObject("Lake").AddComponent<FluidVolume>();
            lake.transform.SetParent(root.transform, false);
            lake.Size = new Vector3(2f, 0.4f, 1f);
            FollowATarget(fluid, target, lake.transform);
            Assert.That(root.transform.position.x, Is.EqualTo(0.5f));
            yield return null;
            Assert.That(FluidAssert.Measure(fluid).particles, Is.EqualTo(20 * 4 * 10));
            ChangeSpacing(fluid);
            for (int i = 0; i < 6; i++)
                yield return null;
            Assert.That((fluid.Capacity, fluid.ParticleSpacing), Is.EqualTo((8000, 0.08f)));
            SimulateWhatIsSeen(fluid);
            int before = fluid.StepCount;
            for (int i = 0; i < 8; i++)
                yield return null;
            Assert.That(fluid.IsCulled, "without a camera");
            Assert.That(fluid.StepCount - before, Is.EqualTo(2));
            Time.captureDeltaTime = 0f;
        }

        [UnityTest]
        public IEnumerator The_snippets_that_follow_and_start_from_a_state_do_what_the_page_says()
        {
            root = MakeFluid();
            var fluid = root.GetComponent<FluidSimulation>();
            Time.captureDeltaTime = 1f / 60f;
            var boat = new GameObject("Boat");
            FluidSnapshotAsset stored = null;
            try
            {
                boat.transform.position = 0.5f * Vector3.right;
                yield return null;
                FluidSnapshotRequest request = fluid.RequestSnapshot();
                yield return request;
                FollowByAComponent(fluid, boat.transform);
                yield return null;
                Assert.That(fluid.transform.position.x, Is.Zero, "nearer than six spacings");
                boat.transform.position = Vector3.right;
                yield return null;
                Assert.That(fluid.transform.position.x, Is.EqualTo(1f).Within(1e-3f));
                stored = StartFromAStoredState(fluid, request);
                Assert.That(fluid.StepCount, Is.Zero);
                yield return null;
                Assert.That(FluidAssert.Measure(fluid).particles, Is.EqualTo(8 * 12 * 10));
            }
            finally
            {
                Object.DestroyImmediate(boat);
                Object.DestroyImmediate(stored);
                Time.captureDeltaTime = 0f;
            }
        }

        T Part<T>() where T : Component
        {
            var made = new GameObject(typeof(T).Name);
            made.transform.SetParent(root.transform, false);
            made.transform.localPosition = new Vector3(0.5f, 0.5f, 0f);
            return made.AddComponent<T>();
        }
    }
}
