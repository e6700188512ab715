using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>GameObject > Rill, as far as it needs the physics module.</summary>
    static class CreateFloatingBody
    {
        const float DensityOfWood = 0.5f;       // of the fluid's
        const float DensityOfBall = 0.3f;       // of the fluid's

        [MenuItem(CreateMenu.Folder + "Floating Body", false, CreateMenu.Priority + 7)]
        static void FloatingBody(MenuCommand command) => CreateMenu.Run(command, Create);

        [InitializeOnLoadMethod]
        static void Install() => FluidSceneSetup.Float = FloatBall;

        static void FloatBall(GameObject ball, FluidSimulation fluid)
        {
            float radius = 0.5f * ball.transform.lossyScale.x;
            ball.AddComponent<Rigidbody>().mass = DensityOfBall * fluid.Material.density * (4f / 3f * Mathf.PI * radius * radius * radius);
            ball.AddComponent<FluidBuoyancy>();
        }

        /// <summary>A cube half as dense as the fluid, above its center.</summary>
        internal static GameObject Create(GameObject parent)
        {
            return SceneSetup.CreateColliderObject(parent, PrimitiveType.Cube, "Floating Body", 0.25f, (made, fluid) =>
            {
                Vector3 side = made.transform.lossyScale;
                var body = made.AddComponent<Rigidbody>();
                body.mass = DensityOfWood * fluid.Material.density * Mathf.Abs(side.x * side.y * side.z);
                made.AddComponent<FluidBuoyancy>();
                made.transform.position += fluid.transform.rotation * new Vector3(0f, 0.25f * fluid.DomainSize.y, 0f);
            });
        }
    }
}
