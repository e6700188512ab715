using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using UnityEngine;

namespace Host.Reference
{
    /// <summary>Water of a known shape before a checkerboard: what a shader of water is held against without any mesh of ours.</summary>
    /// <remarks>The setup stands in data/boards/README.md, for whoever draws the same. A change here is one there, and new pictures.</remarks>
    static class Boards
    {
        public const int Size = 256, Samples = 256;
        const float Index = 1.333f, Square = 0.5f, Plane = 3f, FieldOfView = 40f;

        // Each with what it is and the angle below which its edges are round.
        static readonly Dictionary<string, Func<(JsonObject Shape, double Smooth, Quaternion Turn)>> shapes = new()
        {
            ["sphere"] = () => (new JsonObject { ["shape"] = "sphere", ["radius"] = 0.7 }, 180, Quaternion.identity),
            ["cylinder"] = () => (new JsonObject { ["shape"] = "cylinder", ["radius"] = 0.5, ["length"] = 100 }, 30, Quaternion.identity),
            ["sheet"] = () => (new JsonObject { ["shape"] = "box", ["size"] = CyclesScene.Numbers(3, 3, 0.3) }, 0, Quaternion.Euler(0f, 30f, 0f)),
            ["empty"] = null,
        };

        public static IEnumerable<string> Names => shapes.Keys;

        /// <returns>The picture's path: folder/name.png.</returns>
        /// <exception cref="HostException">The board does not exist, or Blender is missing.</exception>
        public static string Draw(string name, string folder, int size, int samples, int seed)
        {
            if (!shapes.TryGetValue(name, out var shape))
                throw new HostException($"--board {name}: give {string.Join(", ", Names.SkipLast(1))} or {Names.Last()}.");
            CyclesScene.CheckInstalled();
            Directory.CreateDirectory(folder);
            var scene = new CyclesScene(folder);
            scene.SetPicture(name + ".png", size, size, samples, seed, 0);
            scene.SetCamera(Matrix4x4.Translate(new Vector3(0f, 0f, -4f)), FieldOfView, 0.01f, 5000f);
            scene.SetWorld(new Color(0.5f, 0.5f, 0.5f));
            scene.AddMaterial("board", new JsonObject
            {
                ["kind"] = "emission", ["board"] = new JsonObject
                {
                    ["size"] = Square,
                    ["colors"] = new JsonArray(CyclesScene.Numbers(0.8, 0.8, 0.8), CyclesScene.Numbers(0.1, 0.1, 0.1))
                }
            });
            const float thickness = 1e-3f;
            scene.AddObject("board", "board", new JsonObject { ["shape"] = "box", ["size"] = CyclesScene.Numbers(2000, 2000, thickness) },
                Matrix4x4.Translate(new Vector3(0f, 0f, Plane + 0.5f * thickness)), 0);
            if (shape != null)
            {
                var (water, smooth, turn) = shape();
                scene.AddMaterial("water", new JsonObject { ["kind"] = "glass", ["index"] = Index });
                scene.AddObject("water", "water", water, Matrix4x4.Rotate(turn), smooth);
            }
            string picture = scene.Draw();
            File.Delete(Path.Combine(folder, "scene.json"));
            return picture;
        }
    }
}
