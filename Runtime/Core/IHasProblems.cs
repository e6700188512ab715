using System.Collections.Generic;

namespace Rill
{
    /// <summary>Says what is wrong with it now, playing or not, in the words in which it is logged.</summary>
    interface IHasProblems
    {
        void ListProblems(List<string> problems);
    }

    static class Problems
    {
        /// <summary>Adds a problem; null and "" mean none.</summary>
        public static void AddIfAny(this List<string> problems, string problem)
        {
            if (!string.IsNullOrEmpty(problem))
                problems.Add(problem);
        }
    }
}
