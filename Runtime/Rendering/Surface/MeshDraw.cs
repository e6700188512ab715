using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// Draws the mesh of a fluid's surface: its depth, its colors, and what an eye in the water sees. The same buffers serve all cameras; a camera
    /// has nothing of its own but constants, which are written as its commands are recorded.
    /// </summary>
    /// <remarks>
    /// Depth is a draw of its own, one place earlier in the queue: the pipelines do not all promise an order of the passes of one material, but
    /// all sort by queue. The nearest face alone is then shaded, whatever the order of the triangles.
    /// A draw for each camera, since the scene's color is another for each in the Built-in pipeline, and so are the constants.
    /// </remarks>
    sealed class MeshDraw : IDisposable
    {
        /// <summary>Command of a draw of one instance, in <see cref="MeshFrame.arguments"/>.</summary>
        public const int MonoCommand = 0;

        /// <summary>And of two, one for each eye.</summary>
        public const int StereoCommand = 1;

        const int InsideVertices = 6;       // of the rectangle over the picture
        const string RefractionKeyword = "RILL_REFRACTION", ReflectionKeyword = "RILL_OWN_REFLECTION";

        Material colors = MaterialOf("Water"), depth = MaterialOf("WaterDepth"), inside = MaterialOf("WaterInside"), drops = MaterialOf("WaterDrops");
        readonly CameraParts<View> views = new CameraParts<View>();
        readonly List<View> replaced = new List<View>();

        /// <summary>Whether what is behind is seen bent, and whether a cube map of the user's own is mirrored.</summary>
        public void SetKeywords(bool refraction, bool ownReflection)
        {
            SetKeyword(RefractionKeyword, refraction);
            SetKeyword(ReflectionKeyword, ownReflection);
        }

        /// <summary>Before a camera culls.</summary>
        /// <returns>Whether it sees the fluid's box; then <see cref="Submit"/> follows, and <see cref="Record"/> as it draws.</returns>
        public bool Prepare(in FluidViews camera, in MeshFrame mesh)
        {
            TurnOff(camera.camera);
            DisposeReplaced();
            var box = new SurfaceFrame { domainToWorld = mesh.domainToWorld, domainSize = mesh.domainSize, spacing = mesh.spacing };
            if (!BoxOnPicture.Of(camera, box).IsSeen)
                return false;
            View view = ViewOf(camera.camera);
            if (view.IsSubmitted && !view.IsSubmittedFor(camera.width, camera.height))
            {
                // The draw that waits holds a copy of the scene of another size, and shows nothing.
                views.Remove(view);
                replaced.Add(view);
                view = ViewOf(camera.camera);
            }
            view.IsPrepared = true;
            return true;
        }

        /// <summary>What a draw of this camera may still show in this frame is no longer shown, until it is recorded again.</summary>
        public void TurnOff(Camera camera) => views.Find(camera)?.TurnOff();

        /// <summary>Whether <see cref="Prepare"/> has found that the camera sees the fluid in the picture that it draws now.</summary>
        public bool IsPreparedFor(Camera camera) => views.Find(camera) is View view && view.IsPrepared;

        /// <summary>The properties that the camera's draws have in this frame; null where they wait in Unity's queue already.</summary>
        public MaterialPropertyBlock BeginSubmit(in FluidViews camera, in MeshFrame mesh)
        {
            View view = ViewOf(camera.camera);
            if (view.IsSubmitted)
                return null;
            view.MarkSubmitted(camera.width, camera.height);
            mesh.SetOn(view.Properties);
            return view.Properties;
        }

        /// <summary>Has the camera draw the water in this frame.</summary>
        /// <param name="parameters">With the properties of <see cref="BeginSubmit"/>, for one camera.</param>
        public void Submit(RenderParams parameters, in MeshFrame mesh)
        {
            int command = StereoInstancing.IsActive ? StereoCommand : MonoCommand;
            parameters.worldBounds = mesh.bounds;
            parameters.material = depth;
            Graphics.RenderPrimitivesIndexedIndirect(parameters, MeshTopology.Triangles, mesh.indices, mesh.arguments, 1, command);
            parameters.material = colors;
            Graphics.RenderPrimitivesIndexedIndirect(parameters, MeshTopology.Triangles, mesh.indices, mesh.arguments, 1, command);
            if (mesh.drops != null)
            {
                parameters.material = drops;
                Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, mesh.arguments, 1,
                    StereoInstancing.IsActive ? SurfaceMesh.StereoDropCommand : SurfaceMesh.MonoDropCommand);
            }
            parameters.material = inside;
            Graphics.RenderPrimitives(parameters, MeshTopology.Triangles, InsideVertices);
        }

        /// <summary>Records what the camera's draws read of it; nothing where its picture was not prepared.</summary>
        /// <param name="camera">With the matrices that it draws with.</param>
        /// <param name="constants">Of the fluid's look; the camera's are filled in.</param>
        public void Record(CommandBuffer cmd, in FluidViews camera, SurfaceConstants constants)
        {
            View view = views.Find(camera.camera);
            if (view == null || !view.IsPrepared)
                return;
            view.LastFrame = Time.frameCount;
            constants.Set(camera);
            constants.pictureBounds = new Vector4(-1f, -1f, 1f, 1f);
            view.Write(cmd, constants);
        }

        /// <summary>Once a frame: gives back what belongs to cameras that have not seen the fluid lately.</summary>
        public void ReleaseUnused()
        {
            views.RemoveGone();
            DisposeReplaced();
        }

        public void Describe(StageDescription stage)
        {
            if (views.Count == 0)
                return;
            stage.Draw("WaterDepth", views.Count);
            stage.Draw("Water", views.Count);
            stage.Draw("WaterInside", views.Count);
            stage.Draw("WaterDrops", views.Count);
        }

        public void Dispose()
        {
            views.Clear();
            foreach (View view in replaced)
                view.Dispose();
            replaced.Clear();
            EngineObject.Destroy(ref colors);
            EngineObject.Destroy(ref depth);
            EngineObject.Destroy(ref inside);
            EngineObject.Destroy(ref drops);
        }

        static Material MaterialOf(string stage) => new Material(StageShader.Load(stage).Shader) { hideFlags = HideFlags.HideAndDontSave };

        void SetKeyword(string name, bool isOn)
        {
            if (isOn == colors.IsKeywordEnabled(name))
                return;
            if (isOn)
            {
                colors.EnableKeyword(name);
                inside.EnableKeyword(name);
                drops.EnableKeyword(name);
            }
            else
            {
                colors.DisableKeyword(name);
                inside.DisableKeyword(name);
                drops.DisableKeyword(name);
            }
        }

        View ViewOf(Camera camera)
        {
            View found = views.Find(camera);
            if (found == null)
                views.Add(found = new View(camera));
            found.LastFrame = Time.frameCount;
            return found;
        }

        void DisposeReplaced()
        {
            for (int i = replaced.Count - 1; i >= 0; i--)
            {
                if (replaced[i].IsSubmitted)
                    continue;
                replaced[i].Dispose();
                replaced.RemoveAt(i);
            }
        }

        /// <summary>What one camera has of its own.</summary>
        sealed class View : ICameraPart
        {
            const int FramesKept = 3;       // for which a camera may stay away

            public readonly MaterialPropertyBlock Properties = new MaterialPropertyBlock();

            readonly SurfaceConstants[] upload = new SurfaceConstants[1];
            GraphicsBuffer constants = GpuBuffer.Constants<SurfaceConstants>("Rill.Water.Constants");
            Vector2Int submittedSize;
            int submittedFrame = -1;
            bool isWritten;

            public View(Camera camera)
            {
                Camera = camera;
                constants.SetData(upload);
                Properties.SetConstantBuffer(SurfaceIds.Constants, constants, 0, constants.stride);
            }

            public Camera Camera { get; }
            public bool IsGone => Camera == null || Time.frameCount - LastFrame > FramesKept;
            public int LastFrame { get; set; }
            public bool IsPrepared { get; set; }

            /// <summary>Whether its draws wait in Unity's queue, which is emptied when the next frame begins.</summary>
            public bool IsSubmitted => submittedFrame == Time.frameCount;

            public bool IsSubmittedFor(int width, int height) => submittedSize == new Vector2Int(width, height);

            public void MarkSubmitted(int width, int height)
            {
                submittedFrame = Time.frameCount;
                submittedSize = new Vector2Int(width, height);
            }

            /// <summary>At once: draws that wait in this frame show nothing until <see cref="Write"/> is executed.</summary>
            public void TurnOff()
            {
                IsPrepared = false;
                if (!isWritten || !IsSubmitted)
                    return;
                isWritten = false;
                upload[0] = default;
                constants.SetData(upload);
            }

            public void Write(CommandBuffer cmd, in SurfaceConstants values)
            {
                isWritten = true;
                upload[0] = values;
                cmd.SetBufferData(constants, upload);
            }

            public void Dispose() => GpuBuffer.Release(ref constants);
        }
    }
}
