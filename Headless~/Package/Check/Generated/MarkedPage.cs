using System;

namespace Host.Check
{
    /// <summary>A page of which the part between two marks is generated, and the rest is written by hand.</summary>
    abstract class MarkedPage : GeneratedFile
    {
        /// <summary>Name of the part, which its marks have.</summary>
        protected abstract string Part { get; }

        /// <summary>Whether the package has what the part is made from.</summary>
        protected abstract bool HasSources(PackageTree package);

        /// <summary>Returns the text between the marks; null, and a fault, where the sources do not give it.</summary>
        protected abstract string TextOfPart(PackageTree package, Findings findings);

        public sealed override string Text(PackageTree package, Findings findings)
        {
            if (!package.Has(Path) || !HasSources(package))
                return null;
            string page = package.Read(Path), first = $"<!-- {Part}: written by rill generate -->\n", last = $"<!-- end of {Part} -->";
            int start = page.IndexOf(first, StringComparison.Ordinal), end = page.IndexOf(last, StringComparison.Ordinal);
            if (start < 0 || end < start)
            {
                findings.Fault($"{Path} has lost the marks of its table of {Part}: '{first.Trim()}' and '{last}'. Put them back.");
                return null;
            }
            return TextOfPart(package, findings) is string text ? page[..(start + first.Length)] + "\n" + text + "\n" + page[end..] : null;
        }
    }
}
