using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// Draws the mesh of a fluid's surface, its drops, and what an eye in the water sees. The same buffers serve all cameras; a camera
    /// has of its own constants and the rays that it sees through the surface, which are found as its commands are recorded.
    /// </summary>
    /// <remarks>
    /// Tiles of the picture that the nearest faces cover are shaded, and not their triangles, most of which are smaller than the four pixels that a
    /// GPU shades at least.
    /// A draw for each camera, since the scene's color is another for each in the Built-in pipeline, and so are the constants.
    /// </remarks>
    sealed class MeshDraw : IDisposable
    {
        const int RectangleVertices = 6;
        const string RefractionKeyword = "RILL_REFRACTION", ReflectionKeyword = "RILL_OWN_REFLECTION", FoamKeyword = "RILL_FOAM";

        readonly Material colors;
        Material inside = MaterialOf("WaterInside"), drops = MaterialOf("WaterDrops"), sprays = MaterialOf("WaterSpray");
        readonly WaterRays rays = new WaterRays();
        readonly WaterSpray spray = new WaterSpray();
        readonly CameraViews<WaterView> views = new CameraViews<WaterView>(camera => new WaterView(camera));
        bool refracts, reflectsOwn, withFoam;

        /// <param name="colors">Material of Water.shader with the colors; it is not destroyed with this.</param>
        public MeshDraw(Material colors) => this.colors = colors;

        /// <summary>Whether what is behind is seen bent, whether a cube map of the user's own is mirrored, and whether there is foam.</summary>
        public void SetKeywords(bool refraction, bool ownReflection, bool foam)
        {
            if ((refraction, ownReflection, foam) == (refracts, reflectsOwn, withFoam))
                return;
            (refracts, reflectsOwn, withFoam) = (refraction, ownReflection, foam);
            SetKeyword(colors);
            SetKeyword(inside);
            SetKeyword(drops);
            FluidRenderer.SetKeyword(sprays, ReflectionKeyword, ownReflection);
            FluidRenderer.SetKeyword(colors, FoamKeyword, foam);
        }

        /// <summary>Before a camera culls.</summary>
        /// <returns>Whether it sees the fluid's box; then <see cref="Submit"/> follows, and <see cref="Record"/> as it draws.</returns>
        public bool Prepare(in FluidViews camera, in MeshFrame mesh)
        {
            TurnOff(camera.camera);
            views.DisposeReplaced();
            BoxOnPicture seen = BoxOnPicture.Of(camera, mesh.Box);
            if (!seen.IsSeen)
                return false;
            WaterView view = views.ViewOf(camera.camera);
            // It holds a copy of the scene of another size, or rays of too small a part of the picture.
            if (view.IsSubmitted && !(view.IsSubmittedFor(camera.width, camera.height) && view.Holds(camera, seen.Bounds, mesh)))
                view = views.Replace(view);
            view.IsPrepared = true;
            if (!view.IsSubmitted)
                view.Prepare(camera, seen.Bounds, mesh);
            if (camera.needsMotion)
                SurfaceMotion.Set(view, mesh);
            return true;
        }

        /// <summary>Hides the draws of this camera that are left from this frame, until they are recorded again.</summary>
        public void TurnOff(Camera camera) => views.TurnOff(camera);

        /// <summary>Whether <see cref="Prepare"/> has found that the camera sees the fluid in the picture that it draws now.</summary>
        public bool IsPreparedFor(Camera camera) => views.IsPreparedFor(camera);

        /// <summary>The properties that the camera's draws have in this frame; null where they wait in Unity's queue already.</summary>
        public MaterialPropertyBlock BeginSubmit(in FluidViews camera, in MeshFrame mesh)
        {
            WaterView view = views.ViewOf(camera.camera);
            if (view.IsSubmitted)
                return null;
            view.MarkSubmitted(camera.width, camera.height);
            mesh.SetOn(view.Properties);
            PhaseGrid.SetOn(view.Properties, mesh.phases, mesh.field);
            CausticMap.SetOn(view.Properties, mesh.caustics);
            return view.Properties;
        }

        /// <summary>Has the camera draw the water in this frame.</summary>
        /// <param name="parameters">With the properties of <see cref="BeginSubmit"/>, for one camera.</param>
        public void Submit(RenderParams parameters, in MeshFrame mesh)
        {
            GraphicsBuffer tiles = views.ViewOf(parameters.camera).Tiles.Arguments;
            parameters.worldBounds = mesh.bounds;
            parameters.material = colors;
            Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, tiles, 1, WaterTiles.WaterCommand);
            if (mesh.drops != null)
            {
                parameters.material = drops;
                Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, mesh.arguments, 1,
                    StereoInstancing.IsActive ? SurfaceMesh.StereoDropCommand : SurfaceMesh.MonoDropCommand);
            }
            if (mesh.HasSpray)
            {
                parameters.material = sprays;
                Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, tiles, 1, WaterTiles.SprayCommand);
            }
            parameters.material = inside;
            Graphics.RenderPrimitives(parameters, MeshTopology.Triangles, RectangleVertices);
        }

        /// <summary>Records what the camera's draws read of it, and its rays; nothing where its picture was not prepared.</summary>
        /// <param name="camera">With the matrices that it draws with.</param>
        /// <param name="constants">Constants of the fluid's look; the camera's are filled in.</param>
        public void Record(CommandBuffer cmd, in FluidViews camera, in MeshFrame mesh, SurfaceConstants constants)
        {
            WaterView view = views.Find(camera.camera);
            if (view == null || !view.IsPrepared)
                return;
            view.LastFrame = Time.frameCount;
            constants.Set(camera);
            constants.pictureBounds = BoxOnPicture.Of(camera, mesh.Box).Bounds;
            view.SetWindow(camera, constants.pictureBounds, mesh);
            (constants.surfaceSize, constants.surfaceWindow) = (view.Window.Grid, view.Window.Rect);
            (constants.foamSize, constants.foamWindow) = (view.CoarseWindow.Grid, view.CoarseWindow.Rect);
            constants.foamColor = mesh.HasFoam ? mesh.foam.color : Vector4.one;
            view.Write(cmd, constants);
            WaterScratch.Instance.Prepare(view, Mathf.CeilToInt(view.CoarseWindow.Grid.x), Mathf.CeilToInt(view.CoarseWindow.Grid.y),
                WaterSpray.WordsOf(mesh));
            rays.Record(cmd, camera, mesh, view, refracts);
            if (view.Spray != null)
                spray.Record(cmd, camera, mesh, view);
            rays.RecordTiles(cmd, view);
            view.HasMotion = view.Chords != null;
        }

        /// <summary>Returns the textures of a camera; null for one that has none.</summary>
        public WaterView Find(Camera camera) => views.Find(camera);

        /// <summary>Once a frame: gives back what belongs to cameras that have not seen the fluid lately.</summary>
        public void ReleaseUnused() => views.ReleaseUnused();

        public void Describe(StageDescription stage)
        {
            if (views.Count == 0)
                return;
            stage.Draw("Water", views.Count);
            stage.Draw("WaterInside", views.Count);
            stage.Draw("WaterDrops", views.Count);
            stage.Draw("WaterSpray", views.Count);
            for (int i = 0; i < views.Count; i++)
                if (views[i].Faces != null)
                {
                    rays.Describe(stage, views[i]);
                    if (views[i].Chords != null)
                        stage.Draw("SurfaceMotion", 1);
                    if (views[i].Spray != null)
                        spray.Describe(stage, views[i].Faces.volumeDepth, withFoam);
                    views[i].Describe(stage);
                }
            WaterScratch.Instance.Describe(stage);
        }

        public void Dispose()
        {
            views.Dispose();
            rays.Dispose();
            EngineObject.Destroy(ref inside);
            EngineObject.Destroy(ref drops);
            EngineObject.Destroy(ref sprays);
        }

        static Material MaterialOf(string stage) => new Material(StageShader.Load(stage).Shader) { hideFlags = HideFlags.HideAndDontSave };

        void SetKeyword(Material material)
        {
            FluidRenderer.SetKeyword(material, RefractionKeyword, refracts);
            FluidRenderer.SetKeyword(material, ReflectionKeyword, reflectsOwn);
        }
    }
}
