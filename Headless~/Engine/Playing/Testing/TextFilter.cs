using System;
using System.Linq;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Host.Testing
{
    /// <summary>Tests whose full name contains one of the texts, in upper or lower case.</summary>
    sealed class TextFilter : TestFilter
    {
        readonly string[] texts;

        public TextFilter(string[] texts) => this.texts = texts;

        public override bool Match(ITest test) => !test.IsSuite && texts.Any(text => test.FullName.Contains(text, StringComparison.OrdinalIgnoreCase));

        public override TNode AddToXml(TNode parent, bool recursive) => parent.AddElement("filter", string.Join("|", texts));
    }
}
