using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>GameObject > Rill, as far as it needs the physics module.</summary>
    static class CreateFloatingBody
    {
        const float DensityOfWood = 0.5f;       // of the fluid's

        [MenuItem(CreateMenu.Folder + "Floating Body", false, CreateMenu.Priority + 6)]
        static void FloatingBody(MenuCommand command) => CreateMenu.Run(command, Create);

        /// <summary>A cube half as dense as the fluid, above its middle.</summary>
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
