using System;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using Host.Output;
using UnityEngine;

namespace Host.Reference
{
    /// <summary>A scene for Blender's Cycles in Unity's axes and linear colors: scene.json, which cycles.py beside this file draws.</summary>
    sealed class CyclesScene
    {
        static readonly Tool blender = new("blender", "blender");

        readonly JsonArray materials = new(), objects = new();
        readonly JsonObject root = new();

        /// <summary>Folder of scene.json and of all that it refers to.</summary>
        public string Folder { get; }

        public CyclesScene(string folder)
        {
            Folder = folder;
            root["materials"] = materials;
            root["objects"] = objects;
        }

        /// <exception cref="HostException">Blender is not installed; with the command that installs it.</exception>
        public static void CheckInstalled()
        {
            if (!blender.IsInstalled)
                throw new HostException("the reference is drawn by Blender, which is not installed: apt-get install --no-install-recommends blender");
        }

        /// <param name="clamp">Most that a sample adds beyond the first hit; 0 for no limit.</param>
        public void SetPicture(string file, int width, int height, int samples, int seed, double clamp)
        {
            (root["picture"], root["width"], root["height"], root["samples"], root["seed"], root["clamp"]) =
                (file, width, height, samples, seed, clamp);
            (root["bounces"], root["threads"]) = (32, Environment.ProcessorCount);
        }

        /// <param name="toWorld">Of the camera's transform.</param>
        /// <param name="fieldOfView">Vertical, degrees.</param>
        public void SetCamera(Matrix4x4 toWorld, float fieldOfView, float near, float far)
            => root["camera"] = new JsonObject { ["matrix"] = Rows(toWorld), ["fieldOfView"] = fieldOfView, ["near"] = near, ["far"] = far };

        /// <param name="irradiance">On a surface that faces it, in units in which a white matte one then sends 1 / pi.</param>
        public void SetSun(Vector3 direction, Color color, double irradiance, double degrees)
            => root["sun"] = new JsonObject
            {
                ["direction"] = Numbers(direction.x, direction.y, direction.z),
                ["color"] = Numbers(color.r, color.g, color.b), ["irradiance"] = irradiance, ["degrees"] = degrees
            };

        public void SetWorld(Color color) => root["world"] = new JsonObject { ["color"] = Numbers(color.r, color.g, color.b) };

        /// <param name="file">Latitude and longitude, linear, as <see cref="SkyPicture"/> writes it.</param>
        public void SetSky(string file) => root["world"] = new JsonObject { ["sky"] = file };

        /// <summary>Also draws where the material is seen first.</summary>
        public void SetMask(string material, string picture) => root["mask"] = new JsonObject { ["material"] = material, ["picture"] = picture };

        public void AddMaterial(string name, JsonObject settings)
        {
            settings["name"] = name;
            materials.Add(settings);
        }

        /// <param name="smooth">Edges that bend less are round, degrees; 0 for flat faces.</param>
        public void AddObject(string name, string material, JsonObject shape, Matrix4x4 toWorld, double smooth, bool castsShadow = true)
        {
            (shape["name"], shape["material"], shape["matrix"], shape["smooth"], shape["shadow"]) =
                (name, material, Rows(toWorld), smooth, castsShadow);
            objects.Add(shape);
        }

        public void AddMesh(string name, string material, MeshData mesh, Matrix4x4 toWorld, double smooth, bool castsShadow = true)
        {
            string file = $"mesh{objects.Count}.bin";
            mesh.Write(Path.Combine(Folder, file));
            AddObject(name, material, new JsonObject { ["file"] = file }, toWorld, smooth, castsShadow);
        }

        /// <summary>Removes what was written for Blender, but no picture.</summary>
        public void Clean()
        {
            foreach (string file in Directory.GetFiles(Folder, "mesh*.bin").Append(Path.Combine(Folder, "scene.json"))
                .Append(Path.Combine(Folder, "sky.hdr")))
                File.Delete(file);
        }

        /// <summary>Draws the picture and returns its path.</summary>
        public string Draw()
        {
            CheckInstalled();
            string file = Path.Combine(Folder, "scene.json"), picture = Path.Combine(Folder, (string)root["picture"]);
            File.WriteAllText(file, root.ToJsonString());
            File.Delete(picture);
            blender.Run(new[] { "-b", "-noaudio", "--python-exit-code", "3", "-P", Path.Combine(AppContext.BaseDirectory, "Reference", "cycles.py"),
                "--", file });
            return File.Exists(picture) ? picture : throw new HostException($"Blender ended without drawing {picture}.");
        }

        public static JsonArray Numbers(params double[] values) => new(values.Select(value => (JsonNode)value).ToArray());

        static JsonArray Rows(Matrix4x4 matrix)
            => Numbers(Enumerable.Range(0, 16).Select(i => (double)matrix[i / 4, i % 4]).ToArray());
    }
}
