using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>A view of a fluid's surface without a frame around it: what the recorder's textures hold, as numbers.</summary>
    sealed class SurfacePicture : IDisposable
    {
        readonly FluidSurfaceRecorder recorder = new FluidSurfaceRecorder();
        readonly GameObject eye = new GameObject("Eye");
        readonly Texture2D nothing;
        FluidViews views;
        int slice;          // the eye whose textures are read

        /// <summary>What stands in front of the water at every pixel is as far away as this, m.</summary>
        public SurfacePicture(float sceneDepth = 1000f)
        {
            SceneDepth = sceneDepth;
            nothing = new Texture2D(1, 1, TextureFormat.RFloat, false, true);
            eye.AddComponent<Camera>().enabled = false;
        }

        public float SceneDepth { get; set; }

        public int Width => views.width;
        public int Height => views.height;

        /// <summary>Depth along the view, m; 0 where there is no water. Row by row from the bottom.</summary>
        public float[] Depth { get; private set; }

        /// <summary>World, towards the eye; w the variance.</summary>
        public float4[] Normals { get; private set; }

        /// <summary>m; of half the width and height.</summary>
        public float[] Thickness { get; private set; }

        public Matrix4x4 WorldToView => views.ViewOf(slice);
        public Matrix4x4 Projection => views.ProjectionOf(slice);

        /// <param name="from">World, m.</param>
        /// <param name="size">Angle from the picture's bottom to its top, degrees; below 0: minus the height, m, without perspective.</param>
        public SurfacePicture Look(Vector3 from, Vector3 at, float size, int width, int height, float near = 0.1f, float far = 200f)
        {
            Matrix4x4 toWorld = Matrix4x4.TRS(from,
                Quaternion.LookRotation(at - from, Mathf.Abs((at - from).normalized.y) > 0.99f ? Vector3.forward : Vector3.up),
                new Vector3(1f, 1f, -1f));
            float aspect = (float)width / height;
            views = new FluidViews
            {
                camera = eye.GetComponent<Camera>(), eyes = 1, view = toWorld.inverse, width = width, height = height, sceneSize = Vector2.one,
                projection = size > 0f ? Matrix4x4.Perspective(size, aspect, near, far)
                    : Matrix4x4.Ortho(0.5f * size * aspect, -0.5f * size * aspect, 0.5f * size, -0.5f * size, near, far),
            };
            return this;
        }

        /// <summary>A second eye to the right of the view that was given, m; both are drawn in one pass, and one of them is read.</summary>
        public SurfacePicture WithTwoEyes(float distance, int read)
        {
            views.eyes = 2;
            views.rightView = Matrix4x4.Translate(Vector3.left * distance) * views.view;
            views.rightProjection = views.projection;
            slice = read;
            return this;
        }

        /// <summary>Draws the newest state of a solver whose domain's lowest corner is the world's origin.</summary>
        public SurfacePicture Draw(TestFluid fluid, float smoothing = 1f, SurfaceQuality quality = SurfaceQuality.Medium)
        {
            PbfSolver solver = fluid.Solver;
            if (!solver.SurfaceIsCurrent)
                GpuTest.Run(cmd => solver.RecordSurface(cmd, fluid.Input));
            SurfaceFrame frame = SurfaceFrame.Of(solver, Matrix4x4.Scale(Vector3.one * fluid.Spacing), Vector4.zero, smoothing, quality);
            nothing.SetPixelData(new[] { DeviceDepthOf(SceneDepth) }, 0);
            nothing.Apply(false);
            Shader.SetGlobalTexture("_CameraDepthTexture", nothing);
            if (!recorder.Prepare(views, frame))
                throw new InvalidOperationException("The fluid is not on the picture.");
            GpuTest.Run(cmd => recorder.Record(cmd, views, frame));
            SurfaceView view = recorder.ViewOf(views.camera);
            (Depth, Normals, Thickness) = (view.Window.Whole(Read<float>(view.Smoothed, slice), view.Smoothed.width),
                view.Window.Whole(ReadHalves(view.Normals, slice), view.Normals.width),
                view.ThicknessWindow.Whole(Read<float>(view.Thickness, slice), view.Thickness.width));
            views.width = (int)view.Window.Grid.x;
            views.height = (int)view.Window.Grid.y;
            for (int i = 0; i < Depth.Length; i++)
                Depth[i] = Depth[i] > 0f ? DepthAlongView(Depth[i]) : 0f;
            return this;
        }

        /// <summary>The ray through the middle of a pixel, of length 1 along the view.</summary>
        public void Ray(int x, int y, out float3 origin, out float3 direction)
        {
            var picture = new Vector2((x + 0.5f) / Width * 2f - 1f, (y + 0.5f) / Height * 2f - 1f);
            Matrix4x4 p = Projection;
            bool isOrthographic = p.m32 == 0f;
            Matrix4x4 toWorld = WorldToView.inverse;
            var across = new Vector3((picture.x + (isOrthographic ? -p.m03 : p.m02)) / p.m00,
                (picture.y + (isOrthographic ? -p.m13 : p.m12)) / p.m11, 0f);
            origin = toWorld.MultiplyPoint3x4(isOrthographic ? across : Vector3.zero);
            direction = toWorld.MultiplyVector(isOrthographic ? Vector3.back : across + Vector3.back);
        }

        /// <summary>Where the surface is at a pixel, world, m.</summary>
        public float3 Point(int x, int y)
        {
            Ray(x, y, out float3 origin, out float3 direction);
            return origin + direction * Depth[y * Width + x];
        }

        /// <summary>Depth along the view where a point of the world is seen, m, and that of the surface there; false beyond the picture,
        /// where there is no water and at edges.</summary>
        /// <param name="edge">Depths around a pixel that differ by more are those of an edge, m.</param>
        public bool TrySee(float3 world, float edge, out float depth, out float surface)
        {
            depth = surface = 0f;
            Vector4 clip = Projection * (WorldToView * new Vector4(world.x, world.y, world.z, 1f));
            depth = -WorldToView.MultiplyPoint3x4(world).z;
            float x = (clip.x / clip.w * 0.5f + 0.5f) * Width - 0.5f, y = (clip.y / clip.w * 0.5f + 0.5f) * Height - 0.5f;
            int column = Mathf.FloorToInt(x), row = Mathf.FloorToInt(y);
            if (column < 0 || row < 0 || column + 1 >= Width || row + 1 >= Height)
                return false;
            var around = new float4(Depth[row * Width + column], Depth[row * Width + column + 1], Depth[(row + 1) * Width + column],
                Depth[(row + 1) * Width + column + 1]);
            if (math.cmin(around) == 0f || math.cmax(around) - math.cmin(around) > edge)
                return false;
            surface = math.lerp(math.lerp(around.x, around.y, x - column), math.lerp(around.z, around.w, x - column), y - row);
            return true;
        }

        public void Dispose()
        {
            recorder.Dispose();
            UnityEngine.Object.DestroyImmediate(eye);
            UnityEngine.Object.DestroyImmediate(nothing);
        }

        float DeviceDepthOf(float z)
        {
            Matrix4x4 p = views.projection;
            float clip = p.m32 == 0f ? -p.m22 * z + p.m23 : -p.m22 + p.m23 / z;
            float reversed = 0.5f - 0.5f * clip;
            return SystemInfo.usesReversedZBuffer ? reversed : 1f - reversed;
        }

        float DepthAlongView(float depth)
        {
            Matrix4x4 p = Projection;
            float clip = 1f - 2f * depth;
            return p.m32 == 0f ? (p.m23 - clip) / p.m22 : p.m23 / (clip + p.m22);
        }

        static T[] Read<T>(RenderTexture texture, int slice) where T : struct
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture);
            request.WaitForCompletion();
            return request.GetData<T>(slice).ToArray();
        }

        static float4[] ReadHalves(RenderTexture texture, int slice)
        {
            ushort[] halves = Read<ushort>(texture, slice);
            var values = new float4[halves.Length / 4];
            for (int i = 0; i < values.Length; i++)
                for (int c = 0; c < 4; c++)
                    values[i][c] = Mathf.HalfToFloat(halves[4 * i + c]);
            return values;
        }
    }
}
