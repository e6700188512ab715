using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Problems of the project's render settings, each with a button that fixes it.</summary>
    sealed class SetupProblemList
    {
        readonly List<SetupProblem> problems = new List<SetupProblem>();

        public void Draw()
        {
            // Both passes of a frame have to draw the same rows.
            if (Event.current.type == EventType.Layout)
            {
                problems.Clear();
                foreach (IRenderSetup setup in RenderSetups.All)
                    problems.AddRange(setup.Problems);
            }
            foreach (SetupProblem problem in problems)
            {
                EditorGUILayout.HelpBox(problem.Text, MessageType.Warning);
                if (problem.Fix != null && GUILayout.Button(problem.FixLabel))
                    problem.Fix();
            }
        }
    }
}
