using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>A boat that floats as it is: a hull with a bow, a cabin, and a mass that it carries without turning over.</summary>
    static class CreateFloatingBoat
    {
        const float LengthOfBox = 0.6f;         // of the fluid's shortest side
        const float Beam = 0.5f, Depth = 0.25f; // of the hull, of its length
        const float DensityOfBoat = 0.4f;       // of the fluid's, over the hull

        [MenuItem(CreateMenu.Folder + "Floating Boat", false, CreateMenu.Priority + 8)]
        static void FloatingBoat(MenuCommand command) => CreateMenu.Run(command, Create);

        /// <summary>A boat above the center of the fluid, along its x axis.</summary>
        internal static GameObject Create(GameObject parent)
        {
            return SceneSetup.CreateObject(parent, "Floating Boat", (boat, fluid) =>
            {
                Vector3 box = fluid.DomainSize;
                float length = LengthOfBox * Mathf.Min(box.x, box.y, box.z);
                var hull = new Vector3(0.75f * length, Depth * length, Beam * length);
                var bow = new Vector3(0.25f * length, hull.y, 0.6f * hull.z);
                Part(boat, "Hull", hull, new Vector3(-0.125f * length, 0f, 0f));
                Part(boat, "Bow", bow, new Vector3(0.375f * length, 0f, 0f));
                Part(boat, "Cabin", new Vector3(0.3f * length, 0.5f * hull.y, 0.5f * hull.z), new Vector3(-0.2f * length, 0.75f * hull.y, 0f));
                var body = boat.AddComponent<Rigidbody>();
                body.mass = DensityOfBoat * fluid.Material.density * (Volume(hull) + Volume(bow));
                boat.AddComponent<FluidBuoyancy>();
                boat.transform.position += fluid.transform.rotation * new Vector3(0f, 0.25f * box.y, 0f);
            });
        }

        static void Part(GameObject boat, string name, Vector3 size, Vector3 center)
        {
            GameObject made = GameObject.CreatePrimitive(PrimitiveType.Cube);
            made.name = name;
            made.transform.SetParent(boat.transform, false);
            made.transform.localPosition = center;
            made.transform.localScale = size;
            FluidCollider collider = made.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Box;
            collider.Size = Vector3.one;
        }

        static float Volume(Vector3 size) => size.x * size.y * size.z;
    }
}
