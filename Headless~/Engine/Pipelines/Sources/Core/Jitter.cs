namespace UnityEngine.Rendering
{
    /// <summary>By how much a frame's projection is moved for temporal antialiasing: URP 17.1.0, Runtime/TemporalAA.cs; HDRP 16.0,
    /// HDCamera.cs (GetJitteredProjectionMatrix).</summary>
    internal static class Jitter
    {
        public static Matrix4x4 MatrixOf(int frame, int width, int height)
        {
            int index = (frame & 1023) + 1;
            return Matrix4x4.Translate(new Vector3((Halton(index, 2) - 0.5f) * 2 / width, (Halton(index, 3) - 0.5f) * 2 / height, 0));
        }

        static float Halton(int index, int radix)
        {
            float result = 0, fraction = 1f / radix;
            for (; index > 0; index /= radix, fraction /= radix)
                result += index % radix * fraction;
            return result;
        }
    }
}
