using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>RenderSettings.skybox around a camera: a cube whose positions and first texture coordinates are the directions.</summary>
    internal static class Sky
    {
        // A corner of the cube is at sqrt(3) of this, short of the far plane.
        const float Reach = 0.55f;

        static Mesh cube;

        public static void Draw(Camera camera) => Draw(camera.transform.position, camera.farClipPlane);

        public static void Draw(Vector3 eye, float farClipPlane)
        {
            Material material = RenderSettings.skybox;
            if (material == null)
                return;
            float size = 2 * Reach * farClipPlane;
            var call = new DrawCall
            {
                Call = "skybox", Material = material, Mesh = Cube(), Instances = 1,
                Matrix = Matrix4x4.TRS(eye, Quaternion.identity, Vector3.one * size),
            };
            for (int pass = 0; pass < material.passCount; pass++)
                Drawing.DrawPass(call, pass);
        }

        static Mesh Cube()
        {
            if (cube != null)
                return cube;
            Mesh outward = BuiltinMeshes.Of(PrimitiveType.Cube);
            int[] inward = outward.triangles;
            System.Array.Reverse(inward);
            cube = new Mesh { name = "Sky", IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave, vertices = outward.vertices };
            cube.SetUVs(0, new List<Vector3>(outward.vertices));
            cube.triangles = inward;
            return cube;
        }

        public static void Reset()
        {
            if (cube is object)
                Object.DestroyImmediate(cube, true);
            cube = null;
        }
    }
}
