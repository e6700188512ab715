using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What one camera needs of one fluid's surface: its textures, with a slice for each eye, and what they show.</summary>
    sealed class SurfaceView : ICameraPart
    {
        const int FramesKept = 3;       // for which a camera may stay away

        readonly SurfaceConstants[] upload = new SurfaceConstants[1];
        GraphicsBuffer constants = GpuBuffer.Constants<SurfaceConstants>("Rill.Surface.Constants");
        Vector2Int submittedSize;
        int submittedFrame = -1, motionFrame = -1;
        bool isWritten;

        /// <summary>Of the draw that shades, which lives on until the next frame.</summary>
        public readonly MaterialPropertyBlock Shading = new MaterialPropertyBlock();

        /// <summary>Depth alone: the ellipsoids as they were drawn.</summary>
        public RenderTexture Drawn;

        /// <summary>The same smoothed, see SurfaceView.hlsl; <see cref="Smoothed"/> is what counts, the other holds the rows.</summary>
        public RenderTexture Rows, Smoothed;

        /// <summary>xyz unit normal, world; w variance.</summary>
        public RenderTexture Normals;

        /// <summary>Distance of the scene along the view, m; of the size of <see cref="Thickness"/>.</summary>
        public RenderTexture SceneDistance;

        /// <summary>Water in front of the scene along the ray, m; of each phase where their looks differ.</summary>
        public RenderTexture Thickness;

        /// <summary>uint, of each texel of <see cref="Thickness"/>, slice after slice; see SurfaceThickness.compute.</summary>
        public GraphicsBuffer Amounts;

        /// <summary>See FoamLayer.hlsl; half the size. Null where there is no foam.</summary>
        public RenderTexture Foam;

        /// <summary>uint4, of each texel of <see cref="Foam"/>, slice after slice; see SurfaceFoam.compute.</summary>
        public GraphicsBuffer FoamAmounts;

        /// <summary>xyz displacement of the nearest particle in the last substep, d, in the domain's frame. Null where no motion is needed.</summary>
        public RenderTexture Chords;

        /// <summary>Of the draw that writes motion vectors.</summary>
        public MaterialPropertyBlock Motion;

        public SurfaceView(Camera camera)
        {
            Camera = camera;
            constants.SetData(upload);
        }

        public Camera Camera { get; }

        /// <summary>Also where the camera has not drawn for some frames.</summary>
        public bool IsGone => Camera == null || Time.frameCount - LastFrame > FramesKept;

        /// <summary>Frame in which the camera last asked for it.</summary>
        public int LastFrame { get; set; }

        /// <summary>Whether the picture that the camera draws now was prepared.</summary>
        public bool IsPrepared { get; set; }

        /// <summary>Whether its draw waits in Unity's queue, which is emptied when the next frame begins: however often the camera draws until
        /// then, it comes each time.</summary>
        public bool IsSubmitted => submittedFrame == Time.frameCount;

        /// <summary>Whether textures and copies of the scene have to be of another size than those that the draw in the queue holds.</summary>
        public bool IsSubmittedFor(int width, int height) => submittedSize == new Vector2Int(width, height);

        /// <summary>Whether a frame was recorded whose motion vectors are needed and not drawn yet.</summary>
        public bool HasMotion { get; set; }

        /// <summary>What <see cref="Smoothed"/> and <see cref="Normals"/> show; null where they show nothing yet.</summary>
        public SurfaceState? Shown { get; set; }

        /// <summary>The draw is submitted now.</summary>
        /// <param name="width">Of the picture, pixels.</param>
        public void MarkSubmitted(int width, int height)
        {
            submittedFrame = Time.frameCount;
            submittedSize = new Vector2Int(width, height);
        }

        /// <summary>Whether the draw of motion vectors is to be submitted: once a frame too.</summary>
        public bool TrySubmitMotion()
        {
            bool isFirst = motionFrame != Time.frameCount;
            motionFrame = Time.frameCount;
            return isFirst;
        }

        /// <summary>At once: a draw that waits in this frame shows nothing until <see cref="Write"/> is executed.</summary>
        public void TurnOff()
        {
            IsPrepared = false;
            if (!isWritten || !IsSubmitted)
                return;
            isWritten = false;
            upload[0] = default;
            constants.SetData(upload);
        }

        /// <summary>Records what the draws and passes of the camera read from here on.</summary>
        public void Write(CommandBuffer cmd, in SurfaceConstants values)
        {
            isWritten = true;
            upload[0] = values;
            cmd.SetBufferData(constants, upload);
        }

        public void SetConstants(MaterialPropertyBlock block) => block.SetConstantBuffer(SurfaceIds.Constants, constants, 0, constants.stride);

        public void SetConstants(CommandBuffer cmd, ComputeShader shader)
            => cmd.SetComputeConstantBufferParam(shader, SurfaceIds.Constants, constants, 0, constants.stride);

        public int Width => Smoothed.width;
        public int Height => Smoothed.height;

        /// <summary>Makes the textures where they are missing or of another size.</summary>
        /// <param name="thicknessDivisor">Width of the others over that of the textures of thickness.</param>
        /// <param name="phases">Whose thickness is told apart.</param>
        public void Prepare(int width, int height, int eyes, int thicknessDivisor, in PhaseFrame phases)
        {
            PrepareSurface(width, height, eyes);
            PrepareThickness((width + thicknessDivisor - 1) / thicknessDivisor, (height + thicknessDivisor - 1) / thicknessDivisor, eyes,
                phases.Components);
        }

        void PrepareSurface(int width, int height, int eyes)
        {
            if (Holds(Smoothed, width, height, eyes))
                return;
            ReleaseSurface();
            Drawn = Make("Rill.Surface.Drawn", width, height, eyes, GraphicsFormat.None, false);
            Rows = Make("Rill.Surface.Rows", width, height, eyes, GraphicsFormat.R32_SFloat, true);
            Smoothed = Make("Rill.Surface.Depth", width, height, eyes, GraphicsFormat.R32_SFloat, true);
            Normals = Make("Rill.Surface.Normals", width, height, eyes, GraphicsFormat.R16G16B16A16_SFloat, true);
        }

        void PrepareThickness(int width, int height, int eyes, int components)
        {
            GraphicsFormat format = components > 1 ? GraphicsFormat.R16G16B16A16_SFloat : GraphicsFormat.R32_SFloat;
            if (Holds(Thickness, width, height, eyes) && Thickness.graphicsFormat == format)
                return;
            ReleaseThickness();
            SceneDistance = Make("Rill.Surface.SceneDistance", width, height, eyes, GraphicsFormat.R32_SFloat, false);
            Thickness = Make("Rill.Surface.Thickness", width, height, eyes, format, true);
            Amounts = GpuBuffer.Structured<uint>("Rill.Surface.Amounts", (long)width * height * eyes * components);
        }

        /// <summary>The same for foam, after <see cref="Prepare"/>; gives back what is not needed.</summary>
        public void PrepareFoam(bool isNeeded)
        {
            int width = (Width + 1) / 2, height = (Height + 1) / 2, eyes = Smoothed.volumeDepth;
            if (isNeeded && Holds(Foam, width, height, eyes))
                return;
            ReleaseFoam();
            if (!isNeeded)
                return;
            Foam = Make("Rill.Surface.Foam", width, height, eyes, GraphicsFormat.R16G16B16A16_SFloat, true);
            FoamAmounts = GpuBuffer.Structured<Unity.Mathematics.uint4>("Rill.Surface.FoamAmounts", (long)width * height * eyes);
        }

        /// <summary>The same for motion vectors, after <see cref="Prepare"/>; gives back what is not needed.</summary>
        public void PrepareMotion(bool isNeeded)
        {
            if (isNeeded == (Chords != null))
                return;
            EngineObject.Release(ref Chords);
            if (!isNeeded)
                return;
            Chords = Make("Rill.Surface.Chords", Width, Height, Smoothed.volumeDepth, GraphicsFormat.R16G16B16A16_SFloat, false);
            Motion ??= new MaterialPropertyBlock();
            Shown = null;
        }

        public void Dispose()
        {
            GpuBuffer.Release(ref constants);
            ReleaseFoam();
            ReleaseSurface();
            ReleaseThickness();
        }

        void ReleaseSurface()
        {
            EngineObject.Release(ref Drawn);
            EngineObject.Release(ref Rows);
            EngineObject.Release(ref Smoothed);
            EngineObject.Release(ref Normals);
            EngineObject.Release(ref Chords);
            Shown = null;
        }

        void ReleaseThickness()
        {
            EngineObject.Release(ref SceneDistance);
            EngineObject.Release(ref Thickness);
            GpuBuffer.Release(ref Amounts);
        }

        void ReleaseFoam()
        {
            EngineObject.Release(ref Foam);
            GpuBuffer.Release(ref FoamAmounts);
        }

        static bool Holds(RenderTexture texture, int width, int height, int eyes) =>
            texture != null && texture.width == width && texture.height == height && texture.volumeDepth == eyes;

        public void Describe(StageDescription stage)
        {
            foreach (RenderTexture texture in new[] { Drawn, Rows, Smoothed, Normals, Chords, SceneDistance, Thickness, Foam })
                if (texture != null)
                    stage.Texture(texture.name, (long)texture.width * texture.height * texture.volumeDepth * BytesOf(texture));
            if (Amounts != null)
                stage.Buffer("Rill.Surface.Amounts", Amounts);
            if (FoamAmounts != null)
                stage.Buffer("Rill.Surface.FoamAmounts", FoamAmounts);
        }

        static int BytesOf(RenderTexture texture) => texture.graphicsFormat == GraphicsFormat.R16G16B16A16_SFloat ? 8 : 4;

        static RenderTexture Make(string name, int width, int height, int eyes, GraphicsFormat format, bool written)
        {
            return GpuTexture.Create(name, new RenderTextureDescriptor(width, height, format, format == GraphicsFormat.None
                ? GraphicsFormat.D32_SFloat : GraphicsFormat.None)
            {
                dimension = TextureDimension.Tex2DArray, volumeDepth = eyes, enableRandomWrite = written,
            });
        }
    }
}
