using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Problems of the inspected objects, worded as they are logged.</summary>
    static class ProblemList
    {
        /// <param name="inspected">Several are told apart by their names.</param>
        public static List<string> Of(IReadOnlyList<Object> inspected)
        {
            var texts = new List<string>();
            var problems = new List<string>();
            foreach (Object one in inspected)
            {
                problems.Clear();
                (one as IHasProblems)?.ListProblems(problems);
                foreach (string problem in problems.Where(problem => !string.IsNullOrEmpty(problem)))
                    texts.Add(inspected.Count > 1 ? $"'{one.name}': {problem}" : char.ToUpperInvariant(problem[0]) + problem.Substring(1));
            }
            return texts;
        }
    }
}
