using System;

namespace Rill
{
    /// <summary>Something that keeps a fluid surface from looking as it should in this project.</summary>
    readonly struct SetupProblem
    {
        /// <summary>Describes the fault, its location and its consequence.</summary>
        public readonly string Text;

        /// <summary>Label of the button that puts it right; null where no single click does.</summary>
        public readonly string FixLabel;

        /// <summary>Puts it right; null without a label.</summary>
        public readonly Action Fix;

        public SetupProblem(string text, string fixLabel = null, Action fix = null)
        {
            Text = text;
            FixLabel = fixLabel;
            Fix = fix;
        }
    }
}
