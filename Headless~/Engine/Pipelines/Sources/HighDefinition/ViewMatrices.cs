namespace UnityEngine.Rendering.HighDefinition
{
    /// <summary>Matrices of one view, as the device takes them and relative to where it is now; those of the last frame too.</summary>
    /// <remarks>HDRP 16.0, Runtime/RenderPipeline/Camera/HDCamera.cs (UpdateViewConstants): that of the last frame has no jitter.</remarks>
    internal sealed class ViewMatrices
    {
        public Matrix4x4 view, projection, both, steady, previous;
        public Vector3 position, previousPosition;      // the latter relative to the former
        bool hasPrevious;

        public void Update(Matrix4x4 worldToView, in Matrix4x4 unjittered, in Matrix4x4 jitter, Vector3 at)
        {
            worldToView.SetColumn(3, new Vector4(0, 0, 0, 1));
            Matrix4x4 next = GL.GetGPUProjectionMatrix(unjittered, true) * worldToView;
            previousPosition = hasPrevious ? position - at : Vector3.zero;
            previous = (hasPrevious ? steady : next) * Matrix4x4.Translate(-previousPosition);
            (view, projection, steady, position, hasPrevious) = (worldToView, GL.GetGPUProjectionMatrix(jitter * unjittered, true), next, at, true);
            both = projection * view;
        }
    }
}
