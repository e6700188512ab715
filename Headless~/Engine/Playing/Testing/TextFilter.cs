using System;
using System.Linq;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Host.Testing
{
    /// <summary>Tests whose full name contains one of the texts, in upper or lower case, and that have none of the categories left out, nor
    /// their fixtures.</summary>
    sealed class TextFilter : TestFilter
    {
        readonly string[] texts, leftOut;

        /// <param name="texts">None: every test.</param>
        public TextFilter(string[] texts, string[] leftOut)
        {
            this.texts = texts;
            this.leftOut = leftOut;
        }

        public override bool Match(ITest test)
            => !test.IsSuite && (texts.Length == 0 || texts.Any(text => test.FullName.Contains(text, StringComparison.OrdinalIgnoreCase)))
                && !IsLeftOut(test);

        // Tests marked Explicit run if a text names them, not if only categories are left out.
        public override bool IsExplicitMatch(ITest test) => texts.Length > 0 && base.IsExplicitMatch(test);

        bool IsLeftOut(ITest test) => test != null && (leftOut.Any(category => test.Properties[PropertyNames.Category].Contains(category))
            || IsLeftOut(test.Parent));

        public override TNode AddToXml(TNode parent, bool recursive) => parent.AddElement("filter", string.Join("|", texts));
    }
}
