using System.Text.RegularExpressions;

namespace Host.Manual
{
    /// <summary>Names of headings in addresses, as GitHub makes them: lower case, spaces to hyphens, other signs gone.</summary>
    public static class Anchor
    {
        public static string Of(string heading) => Regex.Replace(heading.ToLowerInvariant(), @"[^\w\- ]", "").Replace(' ', '-');
    }
}
