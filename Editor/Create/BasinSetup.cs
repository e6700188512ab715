using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Makes a basin around a fluid's box, of Unity's own cubes and cylinders: tiled floor and walls, and a pane of glass
    /// towards -z. It is only seen: the walls of the box hold the water.</summary>
    static class BasinSetup
    {
        /// <summary>Height of the walls above the floor, m.</summary>
        public const float WallHeight = 0.45f;

        /// <summary>Thickness of the floor, m.</summary>
        public const float Floor = 0.1f;

        /// <summary>The walls of the box that stone covers.</summary>
        public const BoxWalls Covered = BoxWalls.Left | BoxWalls.Right | BoxWalls.Bottom | BoxWalls.Front;

        const string Materials = PackagePaths.Root + "Runtime/Rendering/Materials/";
        const float Wall = 0.08f, Pane = 0.02f, Coping = 0.04f, Overhang = 0.02f;       // m

        /// <summary>A basin below a fluid, in the fluid's frame.</summary>
        public static GameObject Make(FluidSimulation fluid)
        {
            Vector3 box = fluid.DomainSize;
            GameObject basin = Child(fluid.gameObject, "Basin");
            basin.transform.localPosition = new Vector3(0f, -0.5f * box.y, 0f);
            float outX = 0.5f * box.x + Wall, outZ = 0.5f * box.z + Wall, front = -0.5f * box.z - Pane;
            Box(basin, "Floor", new Vector3(-outX, -Floor, front), new Vector3(outX, 0f, outZ), "Tiles");
            Box(basin, "Left Wall", new Vector3(-outX, 0f, front), new Vector3(-0.5f * box.x, WallHeight, outZ), "Tiles");
            Box(basin, "Right Wall", new Vector3(0.5f * box.x, 0f, front), new Vector3(outX, WallHeight, outZ), "Tiles");
            Box(basin, "Back Wall", new Vector3(-0.5f * box.x, 0f, 0.5f * box.z), new Vector3(0.5f * box.x, WallHeight, outZ), "Tiles");
            Box(basin, "Glass", new Vector3(-0.5f * box.x, 0f, front), new Vector3(0.5f * box.x, WallHeight, -0.5f * box.z), "Glass");
            float top = WallHeight + Coping, edge = outX + Overhang, inX = 0.5f * box.x, inZ = 0.5f * box.z;
            Box(basin, "Left Coping", new Vector3(-edge, WallHeight, front - Overhang), new Vector3(-inX, top, outZ + Overhang), "Stone");
            Box(basin, "Right Coping", new Vector3(inX, WallHeight, front - Overhang), new Vector3(edge, top, outZ + Overhang), "Stone");
            Box(basin, "Back Coping", new Vector3(-inX, WallHeight, inZ), new Vector3(inX, top, outZ + Overhang), "Stone");
            return basin;
        }

        /// <summary>A cube between two corners, m in the frame of an object.</summary>
        public static GameObject Box(GameObject parent, string name, Vector3 low, Vector3 high, string material)
        {
            GameObject made = Primitive(parent, PrimitiveType.Cube, name, material);
            made.transform.localPosition = 0.5f * (low + high);
            made.transform.localScale = high - low;
            return made;
        }

        /// <summary>A cylinder between two points, m in the frame of an object.</summary>
        public static GameObject Pipe(GameObject parent, string name, Vector3 from, Vector3 to, float radius, string material)
        {
            GameObject made = Primitive(parent, PrimitiveType.Cylinder, name, material);
            made.transform.localPosition = 0.5f * (from + to);
            made.transform.localRotation = Quaternion.FromToRotation(Vector3.up, to - from);
            made.transform.localScale = new Vector3(2f * radius, 0.5f * (to - from).magnitude, 2f * radius);
            return made;
        }

        /// <summary>An object of Unity's own with a material of the package.</summary>
        public static GameObject Primitive(GameObject parent, PrimitiveType type, string name, string material)
        {
            GameObject made = GameObject.CreatePrimitive(type);
            made.name = name;
            GameObjectUtility.SetParentAndAlign(made, parent);
            made.GetComponent<MeshRenderer>().sharedMaterial = AssetDatabase.LoadAssetAtPath<Material>($"{Materials}{material}.mat");
            return made;
        }

        /// <summary>An empty object at the origin of another.</summary>
        public static GameObject Child(GameObject parent, string name)
        {
            var made = new GameObject(name);
            GameObjectUtility.SetParentAndAlign(made, parent);
            return made;
        }
    }
}
