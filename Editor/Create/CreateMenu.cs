using System;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>GameObject > Rill.</summary>
    static class CreateMenu
    {
        internal const string Folder = "GameObject/Rill/";
        internal const int Priority = 10;

        static bool hasRun;

        /// <summary>Creates one object, whatever is selected.</summary>
        /// <remarks>
        /// From the hierarchy's context menu the editor calls an item once for every selected object, one right after the other;
        /// the first call counts. The next editor update lets the menu be chosen again.
        /// </remarks>
        internal static void Run(MenuCommand command, Func<GameObject, GameObject> create)
        {
            if (hasRun)
                return;
            hasRun = true;
            EditorApplication.delayCall += Rearm;
            create(Context(command));
        }

        /// <summary>Lets the menu be chosen again.</summary>
        internal static void Rearm() => hasRun = false;

        /// <summary>Returns the object that the menu was called on: of several selected objects the active one, else the object under the mouse or
        /// the selected one; null for none of a scene.</summary>
        static GameObject Context(MenuCommand command)
        {
            var context = command.context as GameObject;
            GameObject on = context == null || Selection.Contains(context) ? Selection.activeGameObject : context;
            return on != null && !EditorUtility.IsPersistent(on) ? on : null;
        }

        [MenuItem(Folder + "Fluid", false, Priority)]
        static void Fluid(MenuCommand command) => Run(command, SceneSetup.CreateFluid);

        [MenuItem(Folder + "Fluid Scene", false, Priority + 1)]
        static void FluidScene(MenuCommand command) => Run(command, FluidSceneSetup.Create);

        [MenuItem(Folder + "Fluid Volume", false, Priority + 2)]
        static void Volume(MenuCommand command) => Run(command, SceneSetup.CreateVolume);

        [MenuItem(Folder + "Emitter", false, Priority + 3)]
        static void Emitter(MenuCommand command) => Run(command, SceneSetup.CreateEmitter);

        [MenuItem(Folder + "Drain", false, Priority + 4)]
        static void Drain(MenuCommand command) => Run(command, SceneSetup.CreateDrain);

        [MenuItem(Folder + "Force Field", false, Priority + 5)]
        static void ForceField(MenuCommand command) => Run(command, SceneSetup.CreateForceField);

        [MenuItem(Folder + "Collider", false, Priority + 6)]
        static void Collider(MenuCommand command) => Run(command, SceneSetup.CreateCollider);

        [MenuItem(Folder + "Probe", false, Priority + 9)]
        static void Probe(MenuCommand command) => Run(command, SceneSetup.CreateProbe);

        [MenuItem(Folder + "Detector", false, Priority + 10)]
        static void Detector(MenuCommand command) => Run(command, SceneSetup.CreateDetector);

        [MenuItem(Folder + "Fluid Connection", false, Priority + 11)]
        static void Connection(MenuCommand command) => Run(command, _ => SceneSetup.CreateConnection(Selection.gameObjects));
    }
}
