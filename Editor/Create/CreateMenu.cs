using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>GameObject > Rill.</summary>
    static class CreateMenu
    {
        internal const string Folder = "GameObject/Rill/";
        internal const int Priority = 10;

        [MenuItem(Folder + "Fluid", false, Priority)]
        static void Fluid(MenuCommand command) => SceneSetup.CreateFluid(command.context as GameObject);

        [MenuItem(Folder + "Fluid Volume", false, Priority + 1)]
        static void Volume(MenuCommand command) => SceneSetup.CreateVolume(command.context as GameObject);

        [MenuItem(Folder + "Emitter", false, Priority + 2)]
        static void Emitter(MenuCommand command) => SceneSetup.CreateEmitter(command.context as GameObject);

        [MenuItem(Folder + "Drain", false, Priority + 3)]
        static void Drain(MenuCommand command) => SceneSetup.CreateDrain(command.context as GameObject);

        [MenuItem(Folder + "Force Field", false, Priority + 4)]
        static void ForceField(MenuCommand command) => SceneSetup.CreateForceField(command.context as GameObject);

        [MenuItem(Folder + "Collider", false, Priority + 5)]
        static void Collider(MenuCommand command) => SceneSetup.CreateCollider(command.context as GameObject);
    }
}
