using System;
using System.Collections.Generic;
using System.Reflection;
using Host.Pipelines;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>A floor before a camera that the stand-in of URP draws, and passes that are written in a test.</summary>
    public abstract class UniversalFixture : GraphicsFixture
    {
        protected const int Width = 96, Height = 64;

        /// <summary>Before the passes of every test: a pass that says what it meets.</summary>
        const string Prelude = @"
            using System; using System.Collections.Generic; using UnityEngine; using UnityEngine.Rendering; using UnityEngine.Rendering.Universal;
            #if UNITY_6000_0_OR_NEWER
            using UnityEngine.Rendering.RenderGraphModule;
            #endif
            #pragma warning disable 0618, 0672
            ";

        static int scripts;

        protected RenderTexture target;
        protected Camera camera;
        private protected PlayedPipeline pipeline;

        [SetUp]
        public void MakeCamera()
        {
            target = new RenderTexture(Width, Height, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.D32_SFloat);
            camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0, 3, -6);
            camera.transform.LookAt(new Vector3(0, 0.5f, 0));
            camera.fieldOfView = 40;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.targetTexture = target;
        }

        [TearDown]
        public void EndPipeline()
        {
            pipeline?.Dispose();
            pipeline = null;
            target.Release();
        }

        /// <param name="name">"14", "17", or "17 by Execute".</param>
        private protected PlayedPipeline Start(string name, string root = null)
        {
            bool byExecute = name.EndsWith(" by Execute", StringComparison.Ordinal);
            return pipeline = PlayedPipeline.Start(PipelineKind.Universal, PipelineVersion.Find(name.Split(' ')[0]), root, byExecute);
        }

        /// <summary>A new object of the class Planted in these scripts.</summary>
        private protected object Plant(string source)
            => Activator.CreateInstance(pipeline.AddScripts("Planted" + ++scripts, Prelude + source).GetType("Planted", true));

        /// <summary>A property or field of the asset, a component or a planted object.</summary>
        private protected static void Set(object of, string name, object value)
        {
            const BindingFlags all = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic
                | BindingFlags.SetProperty | BindingFlags.SetField;
            of.GetType().InvokeMember(name, all, null, of, new[] { value });
        }

        private protected static object Get(object of, string name)
        {
            const BindingFlags all = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic
                | BindingFlags.GetProperty | BindingFlags.GetField;
            return of.GetType().InvokeMember(name, all, null, of, null);
        }

        protected Vector4[] Pixels()
        {
            var request = AsyncGPUReadback.Request(target);
            request.WaitForCompletion();
            return request.GetData<Vector4>().ToArray();
        }

        /// <summary>Errors that a frame logged.</summary>
        protected List<string> Errors => Logged.FindAll(line => line.StartsWith("Error", StringComparison.Ordinal)
            || line.StartsWith("Exception", StringComparison.Ordinal));
    }
}
