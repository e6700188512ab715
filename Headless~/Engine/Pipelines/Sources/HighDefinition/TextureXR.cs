namespace UnityEngine.Rendering
{
    /// <summary>Textures of a camera are arrays where the device takes slices in one pass, on one eye too (TextureXR.hlsl: on Direct3D 11,
    /// Vulkan and Metal).</summary>
    public static class TextureXR
    {
        public static bool useTexArray => true;
    }
}
