using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using Host.Assets;
using Host.Output;
using Rill;
using Rill.Tests;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Reference
{
    sealed class ReferenceSettings
    {
        public string Scene, Mesh, Folder;
        public int Frame, Width, Height, Samples, Seed;
        public bool Foam;
    }

    /// <summary>Plays a scene to a frame, draws that by the product and by Cycles, and compares the two.</summary>
    sealed class ReferenceRun
    {
        const string Water = "water";
        const double Sun = 0.75;            // of its light on what faces it, as Solid.hlsl takes it
        const double SunDegrees = 0.53, Clamp = 10, Beyond = 0.15, Touching = 1.0;
        const double SmoothSolids = 40, SmoothWater = 60;
        const float Apart = 2e-5f;          // m, of faces of two solids in one plane

        readonly ReferenceSettings settings;
        readonly TextWriter output;
        readonly List<string> lines = new();

        public ReferenceRun(ReferenceSettings settings, TextWriter output)
        {
            this.settings = settings;
            this.output = output;
        }

        /// <returns>The exit code: see <see cref="CommandLine"/>.</returns>
        public int Execute()
        {
            CyclesScene.CheckInstalled();       // before the scene is played, which may take long
            MeshData given = settings.Mesh == null ? null : SurfaceFile.Read(settings.Mesh);
            LocatedScene located = Session.Locate(settings.Scene);
            string name = Path.GetFileNameWithoutExtension(located.File), folder = ResultsFolder.Of(settings.Folder, name + "-reference");
            Directory.CreateDirectory(folder);
            (Player.ScreenWidth, Player.ScreenHeight) = (settings.Width, settings.Height);
            using var session = new Session(located, player: true);
            session.LoadScene(located);
            FluidSimulation[] fluids = Object.FindObjectsOfType<FluidSimulation>();
            if (fluids.Length != 1)
                throw new HostException($"'{located.File}' has {fluids.Length} fluids; the reference draws one.");
            Camera camera = Camera.main ?? throw new HostException($"'{located.File}' has no camera that is tagged MainCamera.");
            if (camera.orthographic)
                throw new HostException($"the camera '{camera.name}' has no perspective; the reference draws only such as have one.");
            if (!settings.Foam)
                foreach (FluidFoam foam in Object.FindObjectsOfType<FluidFoam>())
                    foam.enabled = false;
            Play(session);
            byte[] ours = Screenshot.ReadRgba();
            for (int i = 3; i < ours.Length; i += 4)
                ours[i] = 255;                  // what shaders left there is not a part of the picture
            File.WriteAllBytes(Path.Combine(folder, "ours.png"), Png.Encode(ours, settings.Width, settings.Height));

            lines.Add(string.Create(CultureInfo.InvariantCulture, $"{name}, frame {settings.Frame} at 60 a second, "
                + $"{settings.Width} x {settings.Height}, foam {(settings.Foam ? "on" : "off")}, commit {SourceCommit.Describe()}"));
            var scene = new CyclesScene(folder);
            scene.SetPicture("reference.png", settings.Width, settings.Height, settings.Samples, settings.Seed, Clamp);
            scene.SetCamera(camera.transform.localToWorldMatrix, camera.fieldOfView, camera.nearClipPlane, camera.farClipPlane);
            AddLight(scene, camera, folder);
            MeshRenderer[] solids = AddSolids(scene);
            AddWater(scene, fluids[0], given, solids);
            scene.SetMask(Water, "mask.png");
            lines.Add(string.Create(CultureInfo.InvariantCulture, $"Cycles: {settings.Samples} samples, seed {settings.Seed}, "
                + $"clamp {Clamp}, 32 bounces; sun of {SunDegrees} degrees"));
            output.WriteLine($"drawing {settings.Width} x {settings.Height} with {settings.Samples} samples in Cycles");
            scene.Draw();
            Compare(folder, ours);
            scene.Clean();
            File.WriteAllLines(Path.Combine(folder, "figures.txt"), lines);
            foreach (string line in lines)
                output.WriteLine(line);
            output.WriteLine($"results in {folder}");
            session.End();
            return session.ErrorsLogged == 0 ? 0 : 1;
        }

        void Play(Session session) => Output.Progress.Run(output, "simulating", settings.Frame, report =>
        {
            PlayerLoop.Frame(0f);               // as rill run draws its first frame
            for (int frame = 1; frame <= settings.Frame; frame++)
            {
                PlayerLoop.Frame(1f / 60f);
                session.ThrowFault();
                report(frame, string.Create(CultureInfo.InvariantCulture, $"frame {frame}"));
            }
        });

        // The light that the shaders had in this frame.
        static void AddLight(CyclesScene scene, Camera camera, string folder)
        {
            SkyPicture.Write(camera, Path.Combine(folder, "sky.hdr"));
            scene.SetSky("sky.hdr");
            Vector4 toSun = Shader.GetGlobalVector("_WorldSpaceLightPos0"), color = Shader.GetGlobalVector("_LightColor0");
            if (color.x + color.y + color.z > 0f)
                scene.SetSun(-(Vector3)toSun, new Color(color.x, color.y, color.z), Math.PI * Sun, SunDegrees);
        }

        static MeshRenderer[] AddSolids(CyclesScene scene)
        {
            MeshRenderer[] renderers = Object.FindObjectsOfType<MeshRenderer>().Where(renderer => renderer.enabled
                && renderer.TryGetComponent(out MeshFilter filter) && filter.sharedMesh != null).ToArray();
            var known = new HashSet<Material>();
            float grown = 0f;
            foreach (MeshRenderer renderer in renderers)
            {
                Mesh mesh = renderer.GetComponent<MeshFilter>().sharedMesh;
                Material[] materials = renderer.sharedMaterials;
                for (int part = 0; part < mesh.subMeshCount && part < materials.Length; part++)
                {
                    Material material = materials[part];
                    string name = $"{material.name} {material.GetInstanceID()}";
                    if (known.Add(material))
                        scene.AddMaterial(name, Solid(material));
                    MeshData placed = MeshData.Of(mesh, part).InWorld(renderer.localToWorldMatrix, grown += Apart);
                    scene.AddMesh(renderer.name, name, placed, Matrix4x4.identity, SmoothSolids,
                        renderer.shadowCastingMode != UnityEngine.Rendering.ShadowCastingMode.Off);
                }
            }
            return renderers;
        }

        // Rill/Solid as it is; of other shaders the color, in an even light.
        static JsonObject Solid(Material material)
        {
            Color color = ColorOf(material, "_Color", ColorOf(material, "_BaseColor", Color.gray)).linear;
            Color ambient = ColorOf(material, "_Ambient", new Color(0.45f, 0.5f, 0.55f)).linear;
            return new JsonObject
            {
                ["kind"] = "solid", ["color"] = CyclesScene.Numbers(color.r, color.g, color.b), ["alpha"] = color.a,
                ["ambient"] = CyclesScene.Numbers(ambient.r, ambient.g, ambient.b),
                ["tile"] = material.HasProperty("_Tile") ? material.GetFloat("_Tile") : 0f,
            };
        }

        static Color ColorOf(Material material, string property, Color otherwise)
            => material.HasProperty(property) ? material.GetColor(property) : otherwise;

        void AddWater(CyclesScene scene, FluidSimulation fluid, MeshData given, MeshRenderer[] solids)
        {
            FluidSurface surface = Object.FindObjectOfType<FluidSurface>();
            SurfaceLook look = surface != null ? surface.Look : SurfaceLook.Water;
            // Light is scattered once, to all sides alike: a quarter of the sun's by a white matte surface, and all that comes from around.
            Vector3 absorption = look.Absorption, extinction = absorption + Vector3.one * look.ScatteringRate;
            Vector4 sun = Shader.GetGlobalVector("_LightColor0");
            Color around = (RenderSettings.ambientSkyColor.linear + RenderSettings.ambientEquatorColor.linear
                + RenderSettings.ambientGroundColor.linear) / 3f;
            Color scattered = look.scattering.linear * look.ScatteringRate;
            scene.AddMaterial(Water, new JsonObject
            {
                ["kind"] = "glass", ["index"] = look.refractionIndex, ["lightPasses"] = true,
                ["extinction"] = CyclesScene.Numbers(extinction.x, extinction.y, extinction.z),
                ["glow"] = CyclesScene.Numbers(scattered.r * (0.25 * sun.x + around.r), scattered.g * (0.25 * sun.y + around.g),
                    scattered.b * (0.25 * sun.z + around.b)),
            });
            double3[] particles = ParticlesOf(fluid);
            lines.Add(string.Create(CultureInfo.InvariantCulture, $"{particles.Length} particles, d {fluid.ParticleSpacing} m; "
                + $"index {look.refractionIndex}, absorption {absorption.x:0.00}, {absorption.y:0.00}, {absorption.z:0.00} 1/m, "
                + $"scattering {look.ScatteringRate:0.00} 1/m; without roughness and caustics"));
            if (given != null)
            {
                scene.AddMesh(Water, Water, given, Matrix4x4.identity, SmoothWater);
                lines.Add(string.Create(CultureInfo.InvariantCulture, $"surface: {Path.GetFileName(settings.Mesh)}, {given.Faces.Count} faces"));
                return;
            }
            var clock = Stopwatch.StartNew();
            List<double3> images = ImagesOf(particles, fluid, solids);
            var mesher = new WaterMesher(particles, images, new double3((float3)fluid.DomainSize) / fluid.ParticleSpacing, Beyond);
            var mesh = new MeshData();
            mesh.Vertices.AddRange(mesher.Vertices.Select(vertex => (Vector3)(float3)vertex));
            mesh.Faces.AddRange(mesher.Quads.Select(quad => new[] { quad.x, quad.y, quad.z, quad.w }));
            scene.AddMesh(Water, Water, mesh, fluid.DomainToWorld, SmoothWater);
            lines.Add(string.Create(CultureInfo.InvariantCulture, $"surface: anisotropic kernels on a grid of {WaterMesher.Cell} d, "
                + $"{mesh.Faces.Count} quads, {mesher.OpenEdges()} open edges, {images.Count} images in solids"));
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"the surface took {clock.Elapsed.TotalSeconds:0.0} s"));
        }

        // In d, in the domain's frame, at the time of the frame.
        static double3[] ParticlesOf(FluidSimulation fluid)
        {
            PbfSolver solver = fluid.Solver;
            var counters = new uint[solver.Counters.count];
            solver.Counters.GetData(counters);
            int alive = (int)counters[(int)ParticleCounter.Alive];
            Vector4[] positions = new Vector4[alive], velocities = new Vector4[alive];
            solver.Positions.GetData(positions, 0, 0, alive);
            solver.Velocities.GetData(velocities, 0, 0, alive);
            float lag = fluid.Clock.FrameLag.y;
            var particles = new double3[alive];
            for (int i = 0; i < alive; i++)
            {
                Vector4 at = positions[i] + velocities[i] * lag;
                particles[i] = new double3(at.x, at.y, at.z);
            }
            return particles;
        }

        static List<double3> ImagesOf(double3[] particles, FluidSimulation fluid, MeshRenderer[] solids)
        {
            Matrix4x4 toDomain = fluid.DomainToWorld.inverse;
            var images = new SolidImages(Touching);
            foreach (MeshRenderer renderer in solids)
            {
                if (renderer.sharedMaterials.Any(material => ColorOf(material, "_Color", Color.white).a < 1f))
                    continue;
                Mesh mesh = renderer.GetComponent<MeshFilter>().sharedMesh;
                Matrix4x4 matrix = toDomain * renderer.localToWorldMatrix;
                Vector3[] vertices = mesh.vertices;
                images.Add(Array.ConvertAll(mesh.triangles, corner => new double3((float3)matrix.MultiplyPoint3x4(vertices[corner]))));
            }
            return images.Of(particles);
        }

        void Compare(string folder, byte[] ours)
        {
            int width = settings.Width, height = settings.Height;
            byte[] theirs = Rgba(Path.Combine(folder, "reference.png")), mask = Rgba(Path.Combine(folder, "mask.png"));
            double3[] a = Colors(theirs), b = Colors(ours);
            double[] map = Flip.Map(a, b, width, height);
            bool[] isWater = Enumerable.Range(0, width * height).Select(i => mask[4 * i] >= 128).ToArray();
            double Mean(bool water) => map.Where((_, i) => isWater[i] == water).DefaultIfEmpty(0.0).Average();
            double ssim = Ssim.Mean(Array.ConvertAll(a, Gray), Array.ConvertAll(b, Gray), width, height);
            lines.Add(string.Create(CultureInfo.InvariantCulture, $"FLIP {map.Average():0.0000} ({Flip.PixelsPerDegree} pixels a degree): "
                + $"water {Mean(true):0.0000} on {100.0 * isWater.Count(w => w) / map.Length:0.0} % of the pixels, the rest {Mean(false):0.0000}"));
            lines.Add(string.Create(CultureInfo.InvariantCulture, $"SSIM {ssim:0.0000}"));

            byte[] beside = new byte[2 * ours.Length], differences = new byte[ours.Length];
            for (int y = 0; y < height; y++)
            {
                Array.Copy(ours, 4 * y * width, beside, 8 * y * width, 4 * width);
                Array.Copy(theirs, 4 * y * width, beside, 8 * y * width + 4 * width, 4 * width);
            }
            for (int i = 0; i < differences.Length; i++)
                differences[i] = i % 4 == 3 ? (byte)255 : (byte)Math.Round(255.0 * map[i / 4]);
            File.WriteAllBytes(Path.Combine(folder, "beside.png"), Png.Encode(beside, 2 * width, height));
            File.WriteAllBytes(Path.Combine(folder, "flip.png"), Png.Encode(differences, width, height));
        }

        // Luminance of a color in sRGB, as a screen shows it.
        static double Gray(double3 srgb) => Ssim.Luminance(new double3(Math.Pow(srgb.x, 2.2), Math.Pow(srgb.y, 2.2), Math.Pow(srgb.z, 2.2)));

        static double3[] Colors(byte[] rgba)
            => Enumerable.Range(0, rgba.Length / 4).Select(i => new double3(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]) / 255.0).ToArray();

        // Top row first.
        byte[] Rgba(string file)
        {
            PngImage image = PngImage.Read(File.ReadAllBytes(file), file);
            var rgba = new byte[4 * image.Width * image.Height];
            for (int i = 0; i < image.Pixels.Length; i++)
            {
                Color32 color = image.Pixels[(image.Height - 1 - i / image.Width) * image.Width + i % image.Width];
                (rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2], rgba[4 * i + 3]) = (color.r, color.g, color.b, 255);
            }
            return rgba;
        }
    }
}
