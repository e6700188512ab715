using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>State that draws of a fluid need for one camera: constants, and whether they wait in Unity's queue.</summary>
    abstract class CameraView : ICameraPart
    {
        const int FramesKept = 3;       // for which a camera may stay away

        /// <summary>xyz displacement of the nearest water in the last substep, d, in the domain's frame. Null where no motion is needed.</summary>
        public RenderTexture Chords;

        readonly SurfaceConstants[] upload = new SurfaceConstants[1];
        GraphicsBuffer constants;
        Vector2Int submittedSize;
        int submittedFrame = -1, motionFrame = -1;
        MaterialPropertyBlock motion;
        bool isWritten;

        /// <param name="constantsName">Name of the buffer of its constants.</param>
        protected CameraView(Camera camera, string constantsName)
        {
            Camera = camera;
            constants = GpuBuffer.Constants<SurfaceConstants>(constantsName);
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

        /// <summary>The draw is submitted now.</summary>
        /// <param name="width">Width of the picture, pixels.</param>
        public void MarkSubmitted(int width, int height)
        {
            submittedFrame = Time.frameCount;
            submittedSize = new Vector2Int(width, height);
        }

        /// <summary>Properties of the draw that writes motion vectors.</summary>
        public MaterialPropertyBlock Motion => motion ??= new MaterialPropertyBlock();

        /// <summary>Whether a frame was recorded whose motion vectors are needed and not drawn yet.</summary>
        public bool HasMotion { get; set; }

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

        public virtual void Dispose() => GpuBuffer.Release(ref constants);
    }
}
