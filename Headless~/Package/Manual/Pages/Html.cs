namespace Host.Manual
{
    /// <summary>Texts within HTML.</summary>
    static class Html
    {
        public static string Escape(string text) =>
            text.Replace("&", "&amp;").Replace("<", "&lt;").Replace(">", "&gt;").Replace("\"", "&quot;");
    }
}
