using System;

namespace Rill
{
    /// <summary>
    /// Marks a static that follows what is loaded, not what is played: assets and the Editor's scripts stay where play mode
    /// begins without a domain reload, and so must what they have set.
    /// </summary>
    [AttributeUsage(AttributeTargets.Field)]
    sealed class KeptBetweenPlaysAttribute : Attribute { }
}
