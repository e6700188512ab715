using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>GameObject > Rill.</summary>
    static class CreateMenu
    {
        internal const string Folder = "GameObject/Rill/";
        internal const int Priority = 10;

        /// <summary>What the menu was called on: the object under the mouse or the selected one; null for none of a scene.</summary>
        internal static GameObject Context(MenuCommand command)
        {
            var context = command.context as GameObject;
            GameObject on = context != null ? context : Selection.activeGameObject;
            return on != null && !EditorUtility.IsPersistent(on) ? on : null;
        }

        [MenuItem(Folder + "Fluid", false, Priority)]
        static void Fluid(MenuCommand command) => SceneSetup.CreateFluid(Context(command));

        [MenuItem(Folder + "Fluid Volume", false, Priority + 1)]
        static void Volume(MenuCommand command) => SceneSetup.CreateVolume(Context(command));

        [MenuItem(Folder + "Emitter", false, Priority + 2)]
        static void Emitter(MenuCommand command) => SceneSetup.CreateEmitter(Context(command));

        [MenuItem(Folder + "Drain", false, Priority + 3)]
        static void Drain(MenuCommand command) => SceneSetup.CreateDrain(Context(command));

        [MenuItem(Folder + "Force Field", false, Priority + 4)]
        static void ForceField(MenuCommand command) => SceneSetup.CreateForceField(Context(command));

        [MenuItem(Folder + "Collider", false, Priority + 5)]
        static void Collider(MenuCommand command) => SceneSetup.CreateCollider(Context(command));
    }
}
